#include "limes/mesh/measure.h"

#include <algorithm>
#include <cmath>

#include "limes/mesh/pieces.h"

namespace limes {

double Bounds::quarter_diagonal() const {
  if (!(lower.array() <= upper.array()).all()) return 0;
  const Vec3 quarter = 0.25 * upper - 0.25 * lower;  // upper - lower may overflow
  return quarter.stableNorm();
}

Bounds bounding_box(const Mesh& mesh) {
  Bounds bounds;
  for (const VertexId v : mesh.topology.corners()) {
    bounds.lower = bounds.lower.cwiseMin(mesh.points[v]);
    bounds.upper = bounds.upper.cwiseMax(mesh.points[v]);
  }
  return bounds;
}

ScaledArea face_area(const Mesh& mesh, FaceId face) {
  const auto corners = mesh.topology.face(face);
  Bounds box;
  for (const VertexId v : corners) {
    box.lower = box.lower.cwiseMin(mesh.points[v]);
    box.upper = box.upper.cwiseMax(mesh.points[v]);
  }
  const bool finite = std::all_of(corners.begin(), corners.end(),
                                  [&](VertexId v) { return mesh.points[v].allFinite(); });
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!finite) return {nan, nan};
  const double quarter_size = box.quarter_diagonal();
  if (quarter_size == 0) return {0, 0};
  // fan of triangles around the first corner, in units of the face's size
  const Vec3& origin = mesh.points[corners[0]];
  const auto arm = [&](std::size_t i) -> Vec3 {
    return (0.25 * mesh.points[corners[i]] - 0.25 * origin) / quarter_size;
  };
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += arm(i).cross(arm(i + 1));
  const double relative = 0.5 * sum.norm();
  const double size = 4.0 * quarter_size;
  return {relative * size * size, relative};
}

namespace {

/// Fills what depends on how vertices hang together.
class Counter {
 public:
  explicit Counter(const Mesh& mesh)
      : topology_(mesh.topology),
        next_(next_halfedges(topology_)),
        edges_(group_by_edge(topology_)),
        valence_(static_cast<std::size_t>(topology_.num_vertices()), 0),
        on_boundary_(static_cast<std::size_t>(topology_.num_vertices()), 0) {}

  void count(MeshMeasure& out) {
    DisjointSets components(topology_.num_vertices());
    DisjointSets boundary(topology_.num_vertices());
    for (std::size_t g = 0; g + 1 < edges_.offsets.size(); ++g) {
      const HalfedgeId h = edges_.halfedges[static_cast<std::size_t>(edges_.offsets[g])];
      const VertexId a = topology_.corner(h), b = topology_.corner(next_[h]);
      if (a == b) continue;  // a corner given twice in a row
      ++out.edges;
      ++valence_[a];
      ++valence_[b];
      components.join(a.value, b.value);
      if (edges_.offsets[g + 1] - edges_.offsets[g] != 1) continue;
      on_boundary_[a] = on_boundary_[b] = 1;
      boundary.join(a.value, b.value);
    }
    IdArray<VertexId, char> used(static_cast<std::size_t>(topology_.num_vertices()), 0);
    for (const VertexId v : topology_.corners())
      used[v] = 1;
    int num_used = 0;
    for (int i = 0; i < topology_.num_vertices(); ++i) {
      const VertexId v(i);
      if (used[v] == 0) continue;
      ++num_used;
      out.components += components.find(i) == i ? 1 : 0;
      out.boundary_loops += on_boundary_[v] != 0 && boundary.find(i) == i ? 1 : 0;
      ++(on_boundary_[v] != 0 ? out.valence_boundary : out.valence_interior)[valence_[v]];
    }
    out.euler = num_used - out.edges + topology_.num_faces();
  }

 private:
  const Topology& topology_;
  IdArray<HalfedgeId, HalfedgeId> next_;
  EdgeGroups edges_;
  IdArray<VertexId, int> valence_;
  IdArray<VertexId, char> on_boundary_;
};

}  // namespace

MeshMeasure measure(const Mesh& mesh) {
  MeshMeasure result;
  result.vertices = mesh.topology.num_vertices();
  result.faces = mesh.topology.num_faces();
  Counter(mesh).count(result);
  result.bounds = bounding_box(mesh);
  for (int f = 0; f < result.faces; ++f)
    result.area += face_area(mesh, FaceId(f)).area;
  return result;
}

}  // namespace limes
