#include "limes/limit/patch_ray.h"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

/// (a, b) of a patch in units of its own parameters: J^-1 (a, b) with the mean derivative J.
struct Preconditioned {
  Eigen::Matrix<double, 16, 2> x;
  Vec2 tolerance;       ///< what the tolerance in (a, b) becomes
  double nonlinearity;  ///< largest absolute row sum of (derivative - identity)
};

/// Nothing if J is singular to rounding.
std::optional<Preconditioned> precondition(const BezierPatch& patch, double tolerance) {
  Mat2 J = Mat2::Zero();
  for (int k = 0; k < 4; ++k) {
    J.col(0) += 0.25 * (patch.row(4 * k + 3) - patch.row(4 * k)).head<2>().transpose();
    J.col(1) += 0.25 * (patch.row(12 + k) - patch.row(k)).head<2>().transpose();
  }
  const double determinant = J.determinant();
  if (!(std::abs(determinant) > 1e-10 * J.col(0).norm() * J.col(1).norm())) return {};
  const Mat2 inverse = J.inverse();
  Preconditioned p;
  p.x = patch.leftCols<2>() * inverse.transpose();
  p.tolerance = tolerance * inverse.rowwise().norm();
  Vec2 largest_u = Vec2::Zero(), largest_v = Vec2::Zero();
  for (int line = 0; line < 4; ++line)
    for (int k = 0; k < 3; ++k) {
      const int u = 4 * line + k, v = 4 * k + line;
      const Vec2 du = 3.0 * (p.x.row(u + 1) - p.x.row(u)).transpose() - Vec2(1, 0);
      const Vec2 dv = 3.0 * (p.x.row(v + 4) - p.x.row(v)).transpose() - Vec2(0, 1);
      largest_u = largest_u.cwiseMax(du.cwiseAbs());
      largest_v = largest_v.cwiseMax(dv.cwiseAbs());
    }
  p.nonlinearity = (largest_u + largest_v).maxCoeff();
  return p;
}

RayHit::Side side_at(const PatchJet& jet) {
  // The third direction is that of the ray: the component of the normal along it.
  const double along = jet.xu.x() * jet.xv.y() - jet.xu.y() * jet.xv.x();
  if (std::abs(along) <= 1e-12 * jet.xu.norm() * jet.xv.norm()) return RayHit::Side::edge_on;
  return along < 0 ? RayHit::Side::front : RayHit::Side::back;
}

Bounds hull_box(const BezierPatch& patch) {
  Bounds box;
  box.lower = patch.colwise().minCoeff().transpose();
  box.upper = patch.colwise().maxCoeff().transpose();
  return box;
}

/// Part of a patch: (s, t) = lower + size (u, v) with its own (u, v) in the unit square.
struct Part {
  BezierPatch patch;
  Vec2 lower, size;
};

class Search {
 public:
  Search(const SquarePlace& place, FirstSoFar& first) : place_(place), first_(first) {}

  void run(const Part& part) {
    const auto p = precondition(part.patch, first_.tolerance());
    if (p) {
      for (const int i : {0, 1})
        if (p->x.col(i).minCoeff() > p->tolerance[i] || p->x.col(i).maxCoeff() < -p->tolerance[i])
          return;
      if (p->nonlinearity <= 0.25) return find_single_root(part);
    }
    const Vec2 extent = extents(part.patch);
    if (extent.sum() <= 0.5 * first_.tolerance()) return offer(part, {0.5, 0.5});
    split(part, extent.x() >= extent.y() ? 0 : 1);
  }

 private:
  /// Newton's method, kept in the square. The map (u, v) -> (a, b) is injective here, and every step
  /// brings the iterate closer to its root by a third at least, if there is one
  /// (docs/theory/closest-point.md).
  void find_single_root(const Part& part) {
    constexpr int max_steps = 100;
    Vec2 uv(0.5, 0.5);
    for (int k = 0; k < max_steps; ++k) {
      const PatchJet jet = evaluate(part.patch, uv);
      Mat2 J;
      J << jet.xu.head<2>(), jet.xv.head<2>();
      const Vec2 next =
          (uv - J.inverse() * jet.x.head<2>()).cwiseMax(Vec2::Zero()).cwiseMin(Vec2::Ones());
      const double step = (next - uv).cwiseAbs().maxCoeff();
      uv = next;
      if (step < 1e-9) break;  // quadratic: 1e-18 is left
    }
    offer(part, uv);
  }

  void offer(const Part& part, const Vec2& uv) {
    const PatchJet jet = evaluate(part.patch, uv);
    if (jet.x.head<2>().norm() > 2.0 * first_.tolerance()) return;
    first_.offer(jet.x.z(), place_, place_.uv(part.lower + part.size.cwiseProduct(uv)), jet.x,
                 side_at(jet));
  }

  void split(const Part& part, int direction) {
    const auto patches = halves(part.patch, direction);
    std::array<Part, 2> parts{Part{patches[0], part.lower, part.size},
                              Part{patches[1], part.lower, part.size}};
    for (Part& half : parts)
      half.size[direction] *= 0.5;
    parts[1].lower[direction] += parts[1].size[direction];
    const bool in_order = patches[0].col(2).minCoeff() <= patches[1].col(2).minCoeff();
    for (const std::size_t k : {std::size_t{in_order ? 0U : 1U}, std::size_t{in_order ? 1U : 0U}})
      if (!misses(hull_box(parts[k].patch), place_, first_)) run(parts[k]);
  }

  const SquarePlace& place_;
  FirstSoFar& first_;
};

}  // namespace

bool misses(const Bounds& box, const SquarePlace& place, const FirstSoFar& first) {
  const double tolerance = first.tolerance();
  for (const int axis : {0, 1})
    if (box.lower[axis] > tolerance || box.upper[axis] < -tolerance) return true;
  return box.upper[2] < first.smallest() || first.excludes(box.lower[2], place);
}

void FirstSoFar::offer(double t, const SquarePlace& place, const Vec2& uv, const Vec3& x,
                       RayHit::Side side) {
  if (t < smallest() || t > largest()) return;
  if (found()) {
    const bool same = place.face == place_.face && place.corner == place_.corner;
    if (!goes_before(place) && t >= (same ? t_ : t_ - tolerance_)) return;
  }
  t_ = t;
  place_ = place;
  uv_ = uv;
  x_ = x;
  side_ = side;
}

void search_patch(const BezierPatch& patch, const SquarePlace& place, FirstSoFar& first) {
  if (!misses(hull_box(patch), place, first))
    Search(place, first).run({patch, Vec2::Zero(), Vec2::Ones()});
}

}  // namespace limes
