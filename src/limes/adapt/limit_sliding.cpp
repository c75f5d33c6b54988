#include "limes/adapt/limit_sliding.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

namespace limes {
namespace {

using Triangle = std::array<Vec3, 3>;

/// Nearest point on the segment from a to b.
Vec3 nearest_on(const Vec3& a, const Vec3& b, const Vec3& x) {
  const Vec3 d = b - a;
  const double length = d.squaredNorm();
  return length > 0 ? Vec3(a + std::clamp(d.dot(x - a) / length, 0.0, 1.0) * d) : a;
}

/// Nearest point of a triangle: below x if that is inside, else on a side.
Vec3 nearest_on(const Triangle& t, const Vec3& x) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  bool inside = n.squaredNorm() > 0;
  for (std::size_t i = 0; i < 3; ++i)
    inside = inside && n.dot((t[(i + 1) % 3] - t[i]).cross(x - t[i])) >= 0;
  if (inside) return x - n * (n.dot(x - t[0]) / n.squaredNorm());
  Vec3 best = nearest_on(t[0], t[1], x);
  for (const std::size_t i : {1U, 2U}) {
    const Vec3 other = nearest_on(t[i], t[(i + 1) % 3], x);
    if ((other - x).squaredNorm() < (best - x).squaredNorm()) best = other;
  }
  return best;
}

/// A point of the fine mesh and the unit normal of its triangle.
struct Footpoint {
  Vec3 x = Vec3::Zero(), normal = Vec3::Zero();
};

class FineSurface {
 public:
  FineSurface(const Mesh& mesh, const Mesh& fine, int steps, IdArray<VertexId, char> stays)
      : fine_(&fine),
        per_face_(1 << (2 * steps)),
        faces_(static_cast<std::size_t>(mesh.topology.num_vertices())),
        stays_(std::move(stays)) {
    const Topology& t = mesh.topology;
    for (int f = 0; f < t.num_faces(); ++f)
      for (const VertexId v : t.face(FaceId(f)))
        faces_[v].push_back(FaceId(f));
    const Adjacency adjacency(t);
    for (int v = 0; v < t.num_vertices(); ++v)
      if (adjacency.is_boundary(VertexId(v))) stays_[VertexId(v)] = 1;
    for (const CreaseTag& crease : mesh.tags.creases)
      stays_[crease.a] = stays_[crease.b] = 1;
  }

  [[nodiscard]] bool stays(VertexId v) const { return stays_[v] != 0; }

  [[nodiscard]] Footpoint nearest(VertexId v, const Vec3& x) const {
    Footpoint best;
    double least = std::numeric_limits<double>::infinity();
    for (const FaceId f : faces_[v])
      for (int child = f.value * per_face_; child < (f.value + 1) * per_face_; ++child) {
        const auto c = fine_->topology.face(FaceId(child));
        const auto at = [&](std::size_t k) { return fine_->points[c[k]]; };
        for (const Triangle& t : {Triangle{at(0), at(1), at(2)}, Triangle{at(0), at(2), at(3)}}) {
          const Vec3 there = nearest_on(t, x);
          const double d = (there - x).squaredNorm();
          if (!(d < least)) continue;
          least = d;
          best = {there, (t[1] - t[0]).cross(t[2] - t[0]).normalized()};
        }
      }
    return best;
  }

 private:
  const Mesh* fine_;
  int per_face_;
  IdArray<VertexId, std::vector<FaceId>> faces_;  // of the coarser mesh
  IdArray<VertexId, char> stays_;
};

}  // namespace

Sliding sliding_on_refinement(const Mesh& mesh, const Mesh& fine, int steps,
                              IdArray<VertexId, char> stays) {
  const auto surface = std::make_shared<const FineSurface>(mesh, fine, steps, std::move(stays));
  return {[surface](VertexId v, const Vec3& x) {
            Eigen::Matrix<double, 3, Eigen::Dynamic> out(3, surface->stays(v) ? 0 : 2);
            if (out.cols() == 0) return out;
            const Vec3 n = surface->nearest(v, x).normal;
            out.col(0) = n.unitOrthogonal();
            out.col(1) = n.cross(out.col(0));
            return out;
          },
          [surface](VertexId v, const Vec3& x) { return surface->nearest(v, x).x; }};
}

}  // namespace limes
