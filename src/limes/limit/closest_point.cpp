#include "limes/limit/closest_point.h"

#include <array>
#include <cmath>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/limit/patch_minimum.h"

namespace limes {
namespace {

/// The search for one query, in the tree's units.
class Search {
 public:
  Search(const SurfaceTree& tree, const Vec3& q)
      : squares_(tree.squares()), objective_(q, tree.centre(), tree.size()), best_(objective_) {
    tree.traverse([&](const BoxTree::Boxes4& boxes) { return objective_.minima(boxes); },
                  [&] { return best_.largest(); },
                  [&](const SurfaceTree::Patch& patch) {
                    search_patch(patch.bezier, patch.centre - objective_.origin(), patch.place,
                                 objective_, best_);
                  },
                  [&](const SurfaceSquare& square) { visit(square); });
  }

  [[nodiscard]] const DistanceObjective& objective() const { return objective_; }
  [[nodiscard]] const ClosestSoFar& best() const { return best_; }

 private:
  void visit(const SurfaceSquare& square) {
    const Vec3 shift = square.centre - objective_.origin();
    if (squares_.is_patch(square))
      return search_patch(squares_.patch(square), shift, square.place, objective_, best_);
    if (squares_.is_self_similar(square)) {
      best_.offer(shift, square.place, square.place.origin, 2);
      // all that is left are points that the vertex stands for
      const Bounds box = squares_.hull_box(square);
      if ((box.upper - box.lower).norm() <= 5.0 * objective_.tolerance()) return;
    }
    if (!best_.excludes(lower_bound(square, shift), square.place)) visit_children(square);
  }

  void visit_children(const SurfaceSquare& square) {
    std::array<SurfaceSquare, 4> children;
    std::array<double, 4> bounds;
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    for (std::size_t i = 0; i < 4; ++i) {
      children[i] = squares_.child(square, static_cast<int>(i));
      bounds[i] = lower_bound(children[i], children[i].centre - objective_.origin());
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return bounds[a] < bounds[b]; });
    for (const std::size_t i : order)
      if (!best_.excludes(bounds[i], children[i].place)) visit(children[i]);
  }

  /// The larger of F's minimum over the box of the controls, and the minimum over their convex hull
  /// of F's tangent plane at the centre: F is convex in space. The second is sharp where the
  /// surface is flat and the centre, a vertex, the closest point.
  [[nodiscard]] double lower_bound(const SurfaceSquare& square, const Vec3& shift) const {
    const Bounds box = squares_.hull_box(square);
    const double tangent = squares_.range(square, square.controls * objective_.gradient(shift))[0];
    return std::max(objective_.minimum(shift + box.lower, shift + box.upper),
                    objective_.value(shift) + tangent);
  }

  const SurfaceSquares& squares_;
  DistanceObjective objective_;
  ClosestSoFar best_;
};

/// A query in the tree's units, not so far away that it overflows: beyond 2^900 times the surface's
/// size only its direction matters.
Vec3 scaled_query(const Vec3& q, int exponent) {
  int own = 0;
  std::frexp(q.cwiseAbs().maxCoeff(), &own);
  return scaled(q, std::min(-exponent, 900 - own));
}

bool is_finite(const Vec3& q) {
  return std::isfinite(q[0]) && std::isfinite(q[1]) && std::isfinite(q[2]);
}

ClosestHit search(const SurfaceTree& tree, const Vec3& q) {
  const Search search(tree, scaled_query(q, tree.exponent()));
  const ClosestSoFar& best = search.best();
  ClosestHit hit;
  hit.face = best.place().face;
  hit.corner = best.place().corner;
  hit.uv = best.uv();
  hit.point = scaled(search.objective().origin() + best.y(), tree.exponent());
  hit.distance = search.objective().is_far() ? (q - hit.point).stableNorm()
                                             : std::ldexp(best.y().norm(), tree.exponent());
  return hit;
}

}  // namespace

ClosestHit closest_point(const SurfaceTree& tree, const Vec3& q) {
  if (!is_finite(q))
    throw InputError("query ({}, {}, {}) is no point; finite numbers are right", q[0], q[1], q[2]);
  return search(tree, q);
}

std::vector<ClosestHit> closest_points(const SurfaceTree& tree, std::span<const Vec3> queries) {
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (!is_finite(queries[i]))
      throw InputError("query {}: ({}, {}, {}) is no point; finite numbers are right", i,
                       queries[i][0], queries[i][1], queries[i][2]);
  std::vector<ClosestHit> hits(queries.size());
  for_each_block(
      static_cast<std::int64_t>(queries.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        check_interrupt();
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          hits[i] = search(tree, queries[i]);
      });
  return hits;
}

}  // namespace limes
