#pragma once

#include <cmath>
#include <numbers>

#include "limes/mesh/mesh.h"

namespace limes::testing {

inline Mesh make_mesh(std::vector<Vec3> points, std::vector<int> quads) {
  std::vector<VertexId> corners;
  for (const int v : quads)
    corners.emplace_back(v);
  Mesh mesh;
  mesh.topology = Topology(static_cast<int>(points.size()), 4, std::move(corners));
  mesh.points = IdArray<VertexId, Vec3>(std::move(points));
  mesh.tags.boundary = BoundaryRule::edges_and_corners;
  return mesh;
}

/// A regular n-gon of circumradius 1 around `centre`, made of n quads that meet at an interior vertex
/// of valence n.
inline Mesh regular_polygon(int n, const Vec2& centre = Vec2::Zero()) {
  std::vector<Vec3> x{Vec3(centre.x(), centre.y(), 0)};
  std::vector<int> quads;
  const auto corner = [&](int i) {
    const double a = 2 * std::numbers::pi * i / n;
    return Vec3(centre.x() + std::cos(a), centre.y() + std::sin(a), 0);
  };
  for (int i = 0; i < n; ++i) {
    x.push_back(corner(i));
    x.push_back(0.5 * (corner(i) + corner(i + 1)));
  }
  for (int i = 0; i < n; ++i) {
    const int before = 2 + 2 * ((i + n - 1) % n);
    quads.insert(quads.end(), {0, before, 1 + 2 * i, 2 + 2 * i});
  }
  return make_mesh(std::move(x), std::move(quads));
}

/// m x n quads on a rectangle, moved by a smooth map.
template <class Map>
Mesh grid(int m, int n, const Map& map) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i) {
      const Vec2 p = map(Vec2(double(i) / m, double(j) / n));
      x.emplace_back(p.x(), p.y(), 0);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      const int v = j * (m + 1) + i;
      quads.insert(quads.end(), {v, v + 1, v + m + 2, v + m + 1});
    }
  return make_mesh(std::move(x), std::move(quads));
}

}  // namespace limes::testing
