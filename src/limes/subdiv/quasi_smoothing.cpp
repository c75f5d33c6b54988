#include "limes/subdiv/quasi_smoothing.h"

#include <algorithm>
#include <cmath>

#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/stencil.h"

namespace limes {
namespace {

enum class Role { held, curve, free };

/// What lies around an old vertex.
struct Surroundings {
  std::vector<std::int32_t> middles;        // new vertices, counter-clockwise
  std::vector<std::int32_t> curve_middles;  // those on boundary and tagged edges at the vertex
  int num_tagged_edges = 0;                 // boundary edges not counted

  void clear() {
    middles.clear();
    curve_middles.clear();
    num_tagged_edges = 0;
  }
};

class Smoothing {
 public:
  Smoothing(const Adjacency& parent, const Bisection& step, const QuasiMarks& marks,
            const QuasiSmoothingRules& rules, std::span<const Vec3> coarse, std::span<Vec3> fine)
      : parent_(parent), step_(step), marks_(marks), rules_(rules), coarse_(coarse), fine_(fine) {}

  void place_new(EdgeId e) const {
    const VertexId middle = step_.middle[e];
    if (!middle.valid()) return;
    const HalfedgeId h = parent_.halfedge(e), twin = parent_.twin(h);
    const Vec3 ends = old(parent_.from(h)) + old(parent_.to(h));
    if (!twin.valid() || marks_.edge(e))
      fine(middle) = 0.5 * ends;
    else
      fine(middle) =
          0.25 *
          (ends + (old(parent_.from(parent_.prev(h))) + old(parent_.from(parent_.prev(twin)))));
  }

  /// Precondition: the new vertices are in place.
  void place_old(VertexId v, Surroundings& around) const {
    fine(v) = old(v);
    if (!parent_.ring_start(v).valid()) return;
    look_around(v, around);
    const Role role = role_of(v, around);
    if (role == Role::held) return;
    const auto& pull = role == Role::curve ? around.curve_middles : around.middles;
    if (pull.empty()) return;
    const auto value = [&](std::int32_t i) -> Vec3 { return fine(VertexId(i)); };
    const Vec3 mean =
        sum_group(std::span<const std::int32_t>(pull), value) / static_cast<double>(pull.size());
    const Vec3 target = 0.5 * old(v) + 0.5 * mean;
    if (parent_.is_boundary(v) && rules_.boundary == QuasiBoundary::curve_normal) {
      const Vec3 n = normal(v);
      fine(v) = old(v) + n.dot(target - old(v)) * n;
    } else {
      fine(v) = target;
    }
  }

 private:
  [[nodiscard]] const Vec3& old(VertexId v) const {
    return coarse_[static_cast<std::size_t>(v.value)];
  }
  Vec3& fine(VertexId v) const { return fine_[static_cast<std::size_t>(v.value)]; }

  void look_around(VertexId v, Surroundings& around) const {
    around.clear();
    const auto add_edge = [&](EdgeId e) {
      const bool boundary = parent_.is_boundary(e), tagged = marks_.edge(e);
      const VertexId middle = step_.middle[e];
      if (tagged && (!boundary || rules_.tags == QuasiTags::held)) ++around.num_tagged_edges;
      if (middle.valid()) around.middles.push_back(middle.value);
      if (middle.valid() && (boundary || tagged)) around.curve_middles.push_back(middle.value);
    };
    const HalfedgeId start = parent_.ring_start(v);
    for (HalfedgeId h = start; h.valid();) {
      add_edge(parent_.edge(h));
      const VertexId opposite = step_.middle[parent_.edge(parent_.next(h))];
      if (opposite.valid()) around.middles.push_back(opposite.value);
      const HalfedgeId in = parent_.prev(h);
      h = parent_.twin(in);
      if (!h.valid()) add_edge(parent_.edge(in));
      if (h == start) break;
    }
  }

  [[nodiscard]] Role role_of(VertexId v, const Surroundings& around) const {
    if (marks_.vertex(v)) return Role::held;
    const bool boundary = parent_.is_boundary(v);
    if (rules_.tags == QuasiTags::held) {
      if (around.num_tagged_edges > 0) return Role::held;
    } else {
      const int num_curve_edges = around.num_tagged_edges + (boundary ? 2 : 0);
      if (num_curve_edges > 2) return Role::held;
      if (num_curve_edges == 2 && !boundary) return Role::curve;
    }
    if (!boundary) return Role::free;
    return rules_.boundary == QuasiBoundary::fixed ? Role::held : Role::curve;
  }

  /// Unit normal of the refined mesh before smoothing, its faces weighted by area; zero where they
  /// have none.
  [[nodiscard]] Vec3 normal(VertexId v) const {
    double size = 0;
    const auto spoke = [&](VertexId to) -> Vec3 { return old(to) - old(v); };
    const auto for_each_face = [&](const auto& visit) {
      for (HalfedgeId h = parent_.ring_start(v); h.valid(); h = parent_.ring_next(h))
        visit(h, parent_.prev(h));
    };
    for_each_face([&](HalfedgeId out, HalfedgeId in) {
      size = std::max({size, spoke(parent_.to(out)).cwiseAbs().maxCoeff(),
                       spoke(parent_.from(in)).cwiseAbs().maxCoeff()});
    });
    if (size == 0) return Vec3::Zero();
    Vec3 sum = Vec3::Zero();
    for_each_face([&](HalfedgeId out, HalfedgeId in) {
      // Half of a face that is split at v lies around v, else all of it.
      const bool split_here =
          step_.middle[parent_.edge(out)].valid() || step_.middle[parent_.edge(in)].valid();
      const Vec3 area = (spoke(parent_.to(out)) / size).cross(spoke(parent_.from(in)) / size);
      sum += (split_here ? 0.5 : 1.0) * area;
    });
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3::Zero();
  }

  const Adjacency& parent_;
  const Bisection& step_;
  const QuasiMarks& marks_;
  QuasiSmoothingRules rules_;
  std::span<const Vec3> coarse_;
  std::span<Vec3> fine_;
};

}  // namespace

void quasi_smoothing(const Adjacency& parent, const Bisection& step, const QuasiMarks& marks,
                     const QuasiSmoothingRules& rules, std::span<const Vec3> coarse,
                     std::span<Vec3> fine) {
  const Smoothing smoothing(parent, step, marks, rules, coarse, fine);
  for_each_index(parent.num_edges(), [&](std::int64_t e) { smoothing.place_new(EdgeId(e)); });
  for_each_block(parent.topology().num_vertices(), 512, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    Surroundings around;
    for (std::int64_t v = begin; v < end; ++v)
      smoothing.place_old(VertexId(v), around);
  });
}

}  // namespace limes
