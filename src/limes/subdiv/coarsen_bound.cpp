#include "limes/subdiv/coarsen_bound.h"

#include <cmath>
#include <optional>

namespace limes {
namespace {

/// An old vertex, and by how much it may be wrong when every given vertex is wrong by 1.
struct OldVertex {
  Vec3 x;
  double gain;
};

class ClosedForm {
 public:
  ClosedForm(const Adjacency& fine, const Unsplit& coarse, const Adjacency& adjacency,
             const Features& features, std::span<const Vec3> fine_points)
      : fine_(fine), coarse_(coarse), adjacency_(adjacency), points_(fine_points) {
    const Topology& topology = adjacency.topology();
    smooth_.resize(static_cast<std::size_t>(topology.num_vertices()), 1);
    for (const SharpEdge& e : features.edges)
      smooth_[adjacency.from(e.halfedge)] = smooth_[adjacency.to(e.halfedge)] = 0;
    for (const SharpVertex& v : features.vertices)
      smooth_[v.vertex] = 0;
    if (!features.smooth_triangles) return;
    for (int f = 0; f < topology.num_faces(); ++f)  // edge points have other weights there
      if (topology.face_size(FaceId(f)) == 3)
        for (const VertexId v : topology.face(FaceId(f)))
          smooth_[v] = 0;
  }

  [[nodiscard]] std::optional<OldVertex> operator()(VertexId v) const {
    const int n = adjacency_.valence(v);
    if (smooth_[v] == 0 || n == 3 || adjacency_.is_boundary(v)) return {};
    const Vec3 given = point(coarse_.old_vertex[static_cast<std::size_t>(v.value)]);
    Vec3 edges = Vec3::Zero(), faces = Vec3::Zero();  // relative to it: far away no digits are lost
    HalfedgeId h = adjacency_.ring_start(v);
    for (int i = 0; i < n; ++i, h = adjacency_.ring_next(h)) {
      const HalfedgeId half = coarse_.half[h];
      edges += point(fine_.to(half)) - given;
      faces += point(fine_.to(fine_.next(half))) - given;
    }
    return OldVertex{given + (faces - 4.0 * edges) / (n * (n - 3.0)), (n + 5.0) / std::abs(n - 3)};
  }

 private:
  [[nodiscard]] const Vec3& point(VertexId v) const {
    return points_[static_cast<std::size_t>(v.value)];
  }

  const Adjacency& fine_;
  const Unsplit& coarse_;
  const Adjacency& adjacency_;
  std::span<const Vec3> points_;
  IdArray<VertexId, char> smooth_;  // no bits: by reference
};

}  // namespace

ResidualBound residual_bound(const Adjacency& fine, const Unsplit& coarse,
                             const Adjacency& adjacency, const Features& features,
                             std::span<const Vec3> fine_points) {
  const Topology& topology = adjacency.topology();
  const ClosedForm old_vertex(fine, coarse, adjacency, features, fine_points);
  ResidualBound bound;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const VertexId middle = coarse.face_point[FaceId(f)];
    const Vec3& given = fine_points[static_cast<std::size_t>(middle.value)];
    Vec3 mean = Vec3::Zero();
    double gain = 0;
    bool known = true;
    for (const VertexId v : topology.face(FaceId(f))) {
      const auto old = old_vertex(v);
      if (!(known = old.has_value())) break;
      mean += old->x - given;
      gain += old->gain;
    }
    if (!known) continue;
    const double size = topology.face_size(FaceId(f));
    const double distance = mean.norm() / size / (1.0 + gain / size);
    if (distance > bound.distance) bound = {distance, middle};
  }
  return bound;
}

}  // namespace limes
