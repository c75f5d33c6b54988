#include "limes/report/scene.h"

#include <algorithm>

#include "limes/core/error.h"

namespace limes {
namespace {

void check_size(const char* what, std::size_t have, std::size_t want) {
  if (have != 0 && have != want)
    throw InputError("picture: {} {}, but the surface needs {} or none", have, what, want);
}

template <std::size_t N>
void check_indices(const char* what, const std::vector<std::array<int, N>>& cells,
                   std::size_t num_points) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const int i : cells[c]) {
      if (i < 0 || static_cast<std::size_t>(i) >= num_points)
        throw InputError("picture: {} {} uses point {}, there are {}", what, c, i, num_points);
    }
  }
}

void check_finite(const char* what, const std::vector<Vec3>& points) {
  const auto bad = std::find_if(points.begin(), points.end(),
                                [](const Vec3& p) { return !p.array().isFinite().all(); });
  if (bad != points.end())
    throw InputError("picture: point {} of {} is not finite", bad - points.begin(), what);
}

}  // namespace

std::vector<Vec3> smooth_normals(const std::vector<Vec3>& points,
                                 const std::vector<std::array<int, 3>>& triangles) {
  check_indices("triangle", triangles, points.size());
  std::vector<Vec3> normals(points.size(), Vec3::Zero());
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  for (const auto& [a, b, c] : triangles) {
    const Vec3 n = (points[at(b)] - points[at(a)]).cross(points[at(c)] - points[at(a)]);
    normals[at(a)] += n;
    normals[at(b)] += n;
    normals[at(c)] += n;
  }
  for (Vec3& n : normals)
    n.normalize();
  return normals;
}

void check_scene(const Scene& scene) {
  for (const Surface& s : scene.surfaces) {
    check_finite("a surface", s.points);
    check_indices("triangle", s.triangles, s.points.size());
    check_size("normals", s.normals.size(), s.points.size());
    check_size("values", s.values.size(), s.points.size());
    check_size("point colours", s.point_colours.size(), s.points.size());
    check_size("triangle colours", s.triangle_colours.size(), s.triangles.size());
  }
  for (const Lines& l : scene.lines) {
    check_finite("lines", l.points);
    check_indices("segment", l.segments, l.points.size());
  }
  for (const Markers& m : scene.markers)
    check_finite("markers", m.points);
}

}  // namespace limes
