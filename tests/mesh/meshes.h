#pragma once

#include <initializer_list>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes {

/// A mesh of the given faces; without points its vertices lie on a curve in space where no three
/// are on a line and no four in a plane: (i, i^2, i^3).
inline Mesh make_mesh(int num_vertices, std::initializer_list<std::initializer_list<int>> faces) {
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (const auto& face : faces) {
    for (const int v : face)
      corners.emplace_back(v);
    offsets.push_back(static_cast<int>(corners.size()));
  }
  Mesh mesh;
  mesh.topology = Topology(num_vertices, std::move(offsets), std::move(corners));
  for (int i = 0; i < num_vertices; ++i) {
    const double t = i;
    mesh.points.push_back(Vec3(t, t * t, t * t * t));
  }
  return mesh;
}

/// A unit cube, faces outwards; vertex i lies at the bits of i.
inline Mesh make_cube() {
  Mesh mesh = make_mesh(
      8, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  for (int i = 0; i < 8; ++i)
    mesh.points[VertexId(i)] = Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  return mesh;
}

/// The corners of a face as plain numbers.
inline std::vector<int> corners_of(const Mesh& mesh, int face) {
  std::vector<int> corners;
  for (const VertexId v : mesh.topology.face(FaceId(face)))
    corners.push_back(v.value);
  return corners;
}

}  // namespace limes
