#include "limes/report/render.h"

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"
#include "limes/core/parallel.h"
#include "limes/report/raster.h"

namespace limes {
namespace {

constexpr int pixel_rows_per_strip = 16;

/// First and last strip of something between two rows of samples; empty when out of the picture.
struct StripRange {
  int first, last;
  StripRange(double low, double high, const raster::Frame& frame, int height)
      : first(static_cast<int>(std::clamp(low, 0.0, frame.height - 1.0)) / height),
        last(static_cast<int>(std::clamp(high, 0.0, frame.height - 1.0)) / height) {
    if (high < 0 || low >= frame.height) last = first - 1;
  }
};

void sort_triangles(const raster::Frame& frame, int height, std::vector<raster::Strip>& strips) {
  for (std::size_t s = 0; s < frame.surfaces.size(); ++s) {
    const raster::PreparedSurface& surface = frame.surfaces[s];
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const raster::Triangle& triangle = surface.triangles[t];
      const auto y = [&](int v) { return surface.vertices[static_cast<std::size_t>(v)].y; };
      const auto [low, high] = std::minmax({y(triangle.a), y(triangle.b), y(triangle.c)});
      const StripRange range(static_cast<double>(low) / raster::subpixels,
                             static_cast<double>(high) / raster::subpixels, frame, height);
      for (int i = range.first; i <= range.last; ++i)
        strips[static_cast<std::size_t>(i)].triangles[s].push_back(static_cast<int>(t));
    }
  }
}

void sort_segments(const raster::Frame& frame, int height, std::vector<raster::Strip>& strips) {
  for (std::size_t l = 0; l < frame.lines.size(); ++l) {
    const raster::PreparedLines& lines = frame.lines[l];
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
      const auto [low, high] = std::minmax({lines.segments[i].ay, lines.segments[i].by});
      const StripRange range(low - lines.half_width, high + lines.half_width, frame, height);
      for (int k = range.first; k <= range.last; ++k)
        strips[static_cast<std::size_t>(k)].segments[l].push_back(static_cast<int>(i));
    }
  }
}

std::vector<raster::Strip> make_strips(const raster::Frame& frame) {
  const int height = pixel_rows_per_strip * frame.samples;
  std::vector<raster::Strip> strips;
  for (int begin = 0; begin < frame.height; begin += height) {
    strips.push_back({begin, std::min(begin + height, frame.height), {}, {}});
    strips.back().triangles.resize(frame.surfaces.size());
    strips.back().segments.resize(frame.lines.size());
  }
  sort_triangles(frame, height, strips);
  sort_segments(frame, height, strips);
  return strips;
}

}  // namespace

Image render(const Scene& scene, const Camera& camera, const RenderOptions& options) {
  LIMES_ASSERT(options.size.width > 0 && options.size.height > 0 && options.density > 0 &&
               options.samples >= 1 && options.samples <= 8);
  check_scene(scene);
  const raster::Frame frame = raster::prepare(scene, camera, options);
  const std::vector<raster::Strip> strips = make_strips(frame);
  Image image(frame.width / frame.samples, frame.height / frame.samples, scene.background);
  for_each_block(static_cast<std::int64_t>(strips.size()), 1,
                 [&](std::int64_t begin, std::int64_t end) {
                   for (std::int64_t i = begin; i < end; ++i)
                     raster::draw_strip(frame, strips[static_cast<std::size_t>(i)], image);
                 });
  return image;
}

Vec2 project(const Vec3& point, const Camera& camera, const PictureSize& size) {
  const Vec3 p = camera.to_view(point);
  const double distance = camera.projection == Projection::perspective ? -p[2] : 1;
  const double scale = size.height / 2.0 / camera.half_height / distance;
  return {size.width / 2.0 + scale * p[0], size.height / 2.0 - scale * p[1]};
}

}  // namespace limes
