#include "limes/mesh/triangulate.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_set>

#include "limes/core/error.h"

namespace limes {
namespace {

/// Edges that are taken, without order.
class EdgeSet {
 public:
  void add(int a, int b) { keys_.insert(key(a, b)); }
  [[nodiscard]] bool has(int a, int b) const { return keys_.contains(key(a, b)); }

 private:
  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
           static_cast<std::uint64_t>(std::max(a, b));
  }
  std::unordered_set<std::uint64_t> keys_;
};

EdgeSet edges_of(const Topology& topology) {
  EdgeSet edges;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.add(face[i].value, face[(i + 1) % face.size()].value);
  }
  return edges;
}

/// Cuts ears off one face, seen along its mean normal.
class EarCutter {
 public:
  EarCutter(std::span<const VertexId> face, std::span<const Vec3> points, EdgeSet* taken)
      : points_(points), taken_(taken) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
      left_.push_back(face[i].value);
      normal += (at(face[i].value) - at(face[0].value))
                    .cross(at(face[(i + 1) % face.size()].value) - at(face[0].value));
    }
    normal_ = normal.normalized();
  }

  void run(int source, Triangulation& out) {
    if (left_.size() < 3) return;
    while (left_.size() > 3) {
      const std::size_t ear = next_ear(source);
      out.triangles.push_back({before(ear), left_[ear], after(ear)});
      out.source.push_back(source);
      if (taken_) taken_->add(before(ear), after(ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    out.triangles.push_back({left_[0], left_[1], left_[2]});
    out.source.push_back(source);
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

  [[nodiscard]] std::size_t next_ear(int source) const {
    if (const auto ear = shortest([&](std::size_t i) { return is_free(i) && is_ear(i); }))
      return *ear;
    // A face that crosses itself may have none: then any corner.
    if (const auto corner = shortest([&](std::size_t i) { return is_free(i); })) return *corner;
    throw InputError(
        "face {} cannot be cut into triangles: all vertices that a cut could join have an edge",
        source);
  }

  /// The allowed corner with the shortest cut.
  template <class Allowed>
  [[nodiscard]] std::optional<std::size_t> shortest(const Allowed& allowed) const {
    constexpr double equal = 1e-9;
    std::optional<std::size_t> best;
    double best_length = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const double length = (at(after(i)) - at(before(i))).norm();
      if (best && length > best_length * (1.0 + equal)) continue;
      const bool shorter = !best || length < best_length * (1.0 - equal);
      if ((shorter || cut(i) < cut(*best)) && allowed(i)) {
        best = i;
        best_length = length;
      }
    }
    return best;
  }
  [[nodiscard]] std::array<int, 2> cut(std::size_t i) const {
    return {std::min(before(i), after(i)), std::max(before(i), after(i))};
  }
  [[nodiscard]] bool is_free(std::size_t i) const {
    return !taken_ || !taken_->has(before(i), after(i));
  }
  /// A corner that turns left and whose triangle holds no other corner.
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
  EdgeSet* taken_;
  std::vector<int> left_;
  Vec3 normal_;
};

}  // namespace

Triangulation triangulate(const Topology& topology, std::span<const Vec3> points, Cuts cuts) {
  LIMES_ASSERT(static_cast<int>(points.size()) >= topology.num_vertices());
  EdgeSet edges;
  if (cuts == Cuts::new_edges) edges = edges_of(topology);
  Triangulation result;
  for (int f = 0; f < topology.num_faces(); ++f)
    EarCutter(topology.face(FaceId(f)), points, cuts == Cuts::new_edges ? &edges : nullptr)
        .run(f, result);
  return result;
}

}  // namespace limes
