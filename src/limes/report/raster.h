#pragma once

#include <cstdint>
#include <vector>

#include "limes/report/render.h"

/// The two halves of render(): geometry into samples' coordinates (raster_prepare.cpp), then strips
/// of samples into pixels (raster_strip.cpp).
namespace limes::raster {

/// Positions are snapped to 1/256 sample: then "which side of an edge" is exact integer arithmetic.
constexpr int subpixel_bits = 8;
constexpr int subpixels = 1 << subpixel_bits;

/// A surface point on the grid of samples. Attributes are plain, not divided by the distance.
struct Vertex {
  std::int32_t x, y;  ///< in 1/256 samples, y downwards
  float depth;        ///< grows towards the eye; affine on the screen
  float inverse_w;    ///< 1 / distance; 1 in orthographic views
  float value;        ///< 0 to 1 over the colour scale, or NaN
  Colour colour;
  float normal[3];  ///< in the camera's frame
};

struct Triangle {
  int a, b, c;  ///< vertices
  int source;   ///< index in Surface::triangles
};

struct PreparedSurface {
  const Surface* surface;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<float> iso_lines;         ///< on the same scale as Vertex::value
  std::vector<Eigen::Vector3f> facets;  ///< per source triangle, in the camera's frame; only where
                                        ///< a shaded surface has no normals
};

/// A segment in samples' coordinates.
struct Segment {
  double ax, ay, bx, by;
  float depth_a, depth_b;
  std::uint32_t group;  ///< one stamp per Lines: a shining-through line is blended once
};

struct PreparedLines {
  const Lines* lines;
  double half_width;  ///< in samples
  std::vector<Segment> segments;
};

struct PreparedMarker {
  const Markers* style;
  double x, y, radius, edge;
  float depth;
};

/// Everything that the strips need; coordinates in samples.
struct Frame {
  int width, height;  ///< samples
  int samples;        ///< per pixel and direction
  double unit;        ///< samples per unit of the picture
  bool perspective;
  Colour background;
  std::vector<PreparedSurface> surfaces;
  std::vector<PreparedLines> lines;
  std::vector<PreparedMarker> markers;
};

[[nodiscard]] Frame prepare(const Scene& scene, const Camera& camera, const RenderOptions& options);

/// Rows of samples [begin, end); which triangles and segments may touch them.
struct Strip {
  int begin, end;
  std::vector<std::vector<int>> triangles;  ///< per surface, ascending
  std::vector<std::vector<int>> segments;   ///< per Lines
};

/// Draws one strip into its rows of pixels; strips are independent of each other.
void draw_strip(const Frame& frame, const Strip& strip, Image& image);

}  // namespace limes::raster
