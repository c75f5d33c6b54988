#include "meshes.h"

#include "limes/mesh/measure.h"
#include "limes/mesh/triangulate.h"

namespace gallery {

using namespace limes;

Mesh from_triangles(std::vector<Vec3> points, const std::vector<std::array<int, 3>>& triangles) {
  std::vector<VertexId> corners;
  for (const auto& triangle : triangles)
    for (const int v : triangle)
      corners.emplace_back(v);
  Mesh mesh;
  mesh.topology = Topology(static_cast<int>(points.size()), 3, std::move(corners));
  mesh.points = IdArray<VertexId, Vec3>(std::move(points));
  return mesh;
}

Mesh triangulated(const Mesh& mesh) {
  return from_triangles(mesh.points.vector(),
                        triangulate(mesh.topology, mesh.points.span(), Cuts::new_edges).triangles);
}

Mesh without_tags(Mesh mesh) {
  mesh.tags = {};
  return mesh;
}

std::optional<double> volume(const Mesh& mesh) {
  if (measure(mesh).boundary_loops > 0) return {};
  const Mesh cut = triangulated(mesh);
  double sum = 0;
  for (int f = 0; f < cut.topology.num_faces(); ++f) {
    const auto corners = cut.topology.face(FaceId(f));
    sum += cut.points[corners[0]].dot(cut.points[corners[1]].cross(cut.points[corners[2]]));
  }
  return sum / 6;
}

}  // namespace gallery
