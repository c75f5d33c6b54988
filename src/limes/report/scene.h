#pragma once

#include <array>
#include <vector>

#include "limes/core/types.h"
#include "limes/report/colour_map.h"

namespace limes {

enum class Shading {
  flat,   ///< colours as they are: plane fields
  faint,  ///< at most 6 % darker where the surface turns away from the eye: fields in space
  lit     ///< two soft lights: surfaces without a field
};

/// Triangles of one kind. The colour comes from `values` if there are any, else from
/// `point_colours`, else from `triangle_colours`, else it is `colour`.
struct Surface {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<Vec3> normals;                  ///< per point; empty: each triangle its own (facets)
  std::vector<double> values;                 ///< per point; NaN: no data
  ColourScale scale;                          ///< for the values
  std::vector<Colour> point_colours;          ///< per point
  std::vector<Colour> triangle_colours;       ///< per triangle
  Colour colour = palette::clay;
  Shading shading = Shading::lit;
};

/// Line segments of one look, each a pair of points.
struct Lines {
  std::vector<Vec3> points;
  std::vector<std::array<int, 2>> segments;
  double width = 1.2;  ///< in units of the picture (see RenderOptions)
  Colour colour = palette::ink;
  bool on_top = false;        ///< drawn over everything instead of where it is seen
  double hidden_opacity = 0;  ///< how much of a hidden part shines through, 0 to 1
};

enum class MarkerShape { disc, square, diamond, triangle, ring };

/// Marks at points, all of one look.
struct Markers {
  std::vector<Vec3> points;
  MarkerShape shape = MarkerShape::disc;
  double size = 9;  ///< diameter, in units of the picture
  Colour fill = palette::paper;
  Colour edge = palette::ink;
  double edge_width = 1.4;
  bool on_top = false;
};

struct Scene {
  std::vector<Surface> surfaces;
  std::vector<Lines> lines;  ///< drawn after the surfaces
  std::vector<Markers> markers;
  Colour background = palette::paper;
};

/// Area-weighted normals at points, unit length; zero where no triangle gives a direction.
/// @throws InputError for an index out of range
[[nodiscard]] std::vector<Vec3> smooth_normals(const std::vector<Vec3>& points,
                                               const std::vector<std::array<int, 3>>& triangles);

/// @throws InputError naming the array that does not fit the points or the index out of range
void check_scene(const Scene& scene);

}  // namespace limes
