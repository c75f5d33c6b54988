#include "limes/core/error.h"
#include "limes/report/pictures.h"

namespace limes {
namespace {

/// Cuts ears off one face, seen along its mean normal.
class EarCutter {
 public:
  EarCutter(std::span<const VertexId> face, std::span<const Vec3> points) : points_(points) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
      left_.push_back(face[i].value);
      normal += (at(face[i].value) - at(face[0].value))
                    .cross(at(face[(i + 1) % face.size()].value) - at(face[0].value));
    }
    normal_ = normal.normalized();
  }

  void run(int source, Triangulation& out) {
    while (left_.size() >= 3) {
      const std::size_t ear = find_ear();
      out.triangles.push_back({before(ear), left_[ear], after(ear)});
      out.source.push_back(source);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
  }

 private:
  [[nodiscard]] const Vec3& at(int v) const { return points_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] int before(std::size_t i) const {
    return left_[(i + left_.size() - 1) % left_.size()];
  }
  [[nodiscard]] int after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }
  [[nodiscard]] double area(int a, int b, int c) const {
    return normal_.dot((at(b) - at(a)).cross(at(c) - at(a)));
  }

  /// A corner that turns left and whose triangle holds no other corner; among those the one with
  /// the shortest cut, which divides a quad along its shorter diagonal.
  [[nodiscard]] std::size_t find_ear() const {
    std::size_t best = 0;
    double best_length = -1;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (!is_ear(i)) continue;
      const double length = (at(after(i)) - at(before(i))).squaredNorm();
      if (best_length < 0 || length < best_length) {
        best = i;
        best_length = length;
      }
    }
    return best;  // a face that crosses itself has none: then any corner
  }
  [[nodiscard]] bool is_ear(std::size_t i) const {
    const int a = before(i), b = left_[i], c = after(i);
    if (!(area(a, b, c) > 0)) return false;
    for (const int v : left_) {
      if (v == a || v == b || v == c) continue;
      if (area(a, b, v) >= 0 && area(b, c, v) >= 0 && area(c, a, v) >= 0) return false;
    }
    return true;
  }

  std::span<const Vec3> points_;
  std::vector<int> left_;
  Vec3 normal_;
};

}  // namespace

Triangulation triangulate(const Topology& topology, std::span<const Vec3> points) {
  LIMES_ASSERT(static_cast<int>(points.size()) >= topology.num_vertices());
  Triangulation result;
  for (int f = 0; f < topology.num_faces(); ++f)
    EarCutter(topology.face(FaceId(f)), points).run(f, result);
  return result;
}

}  // namespace limes
