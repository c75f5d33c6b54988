#include "limes/limit/patch_minimum.h"

#include <algorithm>
#include <cmath>

#include "limes/limit/distance_polynomial.h"

namespace limes {
namespace {

/// A point of a patch with F's derivatives there.
struct PatchPoint {
  Vec2 uv, gradient;
  Vec3 y;
  double F, rounding;  ///< rounding: error of F
  Mat2 hessian, gauss_newton;
};

PatchPoint point_at(const BezierPatch& patch, const Vec3& shift, const DistanceObjective& objective,
                    const Vec2& uv) {
  const PatchJet jet = evaluate(patch, uv);
  PatchPoint p;
  p.uv = uv;
  p.y = jet.x + shift;
  p.F = objective.value(p.y);
  const Vec3 n = objective.gradient(p.y);
  p.rounding = 1e-15 * n.norm() * (jet.x.norm() + shift.norm());
  p.gradient = {n.dot(jet.xu), n.dot(jet.xv)};
  const double a = objective.alpha();
  const double mixed = a * jet.xu.dot(jet.xv);
  p.gauss_newton << a * jet.xu.squaredNorm(), mixed, mixed, a * jet.xv.squaredNorm();
  const double twist = n.dot(jet.xuv);
  p.hessian << n.dot(jet.xuu), twist, twist, n.dot(jet.xvv);
  p.hessian += p.gauss_newton;
  return p;
}

bool is_positive(const Mat2& H) {
  return H(0, 0) > 0 && H(1, 1) > 0 && H.determinant() > 1e-8 * H(0, 0) * H(1, 1);
}

/// The point of the unit square where the model gradient . d + d . H d / 2 is smallest, d = x - uv;
/// H is positive. Inside if Newton's step ends there, else the best of the four sides' minima.
Vec2 model_minimum(const Vec2& uv, const Vec2& gradient, const Mat2& H) {
  const Vec2 inside = uv - H.inverse() * gradient;
  if (inside.minCoeff() >= 0 && inside.maxCoeff() <= 1) return inside;
  Vec2 best = uv;
  double smallest = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 2; ++side) {
    for (const double end : {0.0, 1.0}) {
      Vec2 d;
      d[side] = end - uv[side];
      const int free = 1 - side;
      const double step = -(gradient[free] + H(free, side) * d[side]) / H(free, free);
      const double x = std::clamp(uv[free] + step, 0.0, 1.0);
      d[free] = x - uv[free];
      const double model = gradient.dot(d) + 0.5 * d.dot(H * d);
      if (!(model < smallest)) continue;
      smallest = model;
      best[side] = end;
      best[free] = x;
    }
  }
  return best;
}

/// Where the model of F in the unit square is smallest: Newton's where it has a minimum, else the
/// one of Gauss and Newton. A coordinate that its side holds back stays there.
Vec2 model_minimum(const PatchPoint& p, bool& is_newton) {
  std::array<bool, 2> held;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    held[i] = (p.uv[k] == 0 && p.gradient[k] > 0) || (p.uv[k] == 1 && p.gradient[k] < 0);
  }
  if (held[0] && held[1]) return p.uv;
  if (held[0] || held[1]) {
    const int free = held[0] ? 1 : 0;
    is_newton = p.hessian(free, free) > 0;
    const double h = is_newton ? p.hessian(free, free) : p.gauss_newton(free, free);
    Vec2 next = p.uv;
    if (h > 0) next[free] = std::clamp(p.uv[free] - p.gradient[free] / h, 0.0, 1.0);
    return next;
  }
  is_newton = is_positive(p.hessian);
  if (is_newton) return model_minimum(p.uv, p.gradient, p.hessian);
  Mat2 H = p.gauss_newton;
  if (!is_positive(H)) H.diagonal().array() += 1e-6 * H.trace();
  return is_positive(H) ? model_minimum(p.uv, p.gradient, H) : p.uv;
}

/// Newton's method in the unit square from a start; F never grows beyond rounding.
PatchPoint newton(const BezierPatch& patch, const Vec3& shift, const DistanceObjective& objective,
                  const Vec2& start) {
  constexpr int max_steps = 30;
  PatchPoint at = point_at(patch, shift, objective, start);
  for (int k = 0; k < max_steps; ++k) {
    const double highest = at.F + 8.0 * at.rounding;
    bool is_newton = true;
    Vec2 step = model_minimum(at, is_newton) - at.uv;
    const double length = step.cwiseAbs().maxCoeff();
    if (length == 0) return at;
    PatchPoint next = point_at(patch, shift, objective, at.uv + step);
    for (int quarter = 0; quarter < 6 && !(next.F <= highest); ++quarter) {
      step *= 0.25;
      next = point_at(patch, shift, objective, at.uv + step);
    }
    if (!(next.F <= highest)) return at;
    at = next;
    if (length < (is_newton ? 1e-9 : 1e-15)) return at;  // Newton is quadratic: 1e-18 is left
  }
  return at;
}

/// Whether F's minimum lies on the side i = 0 (or 1) that p is on: F grows from there everywhere.
bool is_on_least_side(const PatchPoint& p, const DistancePolynomial::Derivatives& d, int i) {
  return (p.uv[i] == 0 && d.least[i] >= 0) || (p.uv[i] == 1 && d.largest[i] <= 0);
}

/// A lower bound of F on the unit square from a point of it and bounds of the derivatives:
/// F(x) >= F + gradient . (x - uv) + mu |x - uv|^2 / 2 with mu, the least second derivative; along
/// a side if it is known to hold the minimum.
double bound_from(const PatchPoint& p, const DistancePolynomial::Derivatives& d) {
  const std::array<bool, 2> fixed{is_on_least_side(p, d, 0), is_on_least_side(p, d, 1)};
  double down = 0, squared = 0;  // of the gradient where it points into the square
  double mu = d.least_curvature, longest = 2;
  for (int i = 0; i < 2; ++i) {
    if (fixed[static_cast<std::size_t>(i)]) {
      mu = d.least_second[1 - i];
      longest = 1;
      continue;
    }
    const double g = p.gradient[i];
    const double room = g > 0 ? p.uv[i] : 1.0 - p.uv[i];
    down += std::abs(g) * room;
    if (room > 0) squared += g * g;
  }
  if (fixed[0] && fixed[1]) return p.F;
  return mu > 0 ? p.F - std::min(down, 0.5 * squared / mu) : p.F - down + 0.5 * longest * mu;
}

/// How many sides hold a point: across them F would go on to fall, and by more than rounding.
int num_holding_sides(const PatchPoint& p) {
  int held = 0;
  for (int i = 0; i < 2; ++i) {
    const double step = p.gradient[i] / p.gauss_newton(i, i);
    if ((p.uv[i] == 0 && step > 1e-12) || (p.uv[i] == 1 && step < -1e-12)) ++held;
  }
  return held;
}

/// Part of a patch: (s, t) = lower + size (u, v) with its own (u, v) in the unit square.
struct Part {
  BezierPatch patch;
  Vec2 lower, size;
};

class Search {
 public:
  Search(const Vec3& shift, const SquarePlace& place, const DistanceObjective& objective,
         ClosestSoFar& best)
      : shift_(shift), place_(place), objective_(objective), best_(best) {}

  void run(const Part& part, const DistancePolynomial& polynomial) {
    const PatchPoint p = newton(part.patch, shift_, objective_, polynomial.lowest());
    best_.offer(p.y, place_, place_.uv(part.lower + part.size.cwiseProduct(p.uv)),
                num_holding_sides(p));
    if (polynomial.lower_bound() >= best_.smallest()) return;
    if (bound_from(p, polynomial.derivatives()) >= best_.smallest()) return;
    if (tangent_bound(p, part.patch) >= best_.smallest()) return;
    const Vec2 extent = extents(part.patch);
    if (extent.sum() <= objective_.tolerance()) return;
    split(part, extent.x() >= extent.y() ? 0 : 1);
  }

 private:
  /// F is convex in space: it lies above its tangent plane at p, also on the hull of the patch.
  /// Sharp where the patch is flat, or folded together into a line.
  [[nodiscard]] double tangent_bound(const PatchPoint& p, const BezierPatch& patch) const {
    const Vec3 n = objective_.gradient(p.y);
    return p.F + (patch * n).minCoeff() - n.dot(p.y - shift_);
  }

  void split(const Part& part, int direction) {
    const auto patches = halves(part.patch, direction);
    std::array<Part, 2> parts{Part{patches[0], part.lower, part.size},
                              Part{patches[1], part.lower, part.size}};
    for (Part& half : parts)
      half.size[direction] *= 0.5;
    parts[1].lower[direction] += parts[1].size[direction];
    const std::array<DistancePolynomial, 2> polynomials{
        DistancePolynomial(patches[0], shift_, objective_),
        DistancePolynomial(patches[1], shift_, objective_)};
    const std::size_t first = polynomials[0].lower_bound() <= polynomials[1].lower_bound() ? 0 : 1;
    for (const std::size_t k : {first, 1 - first})
      if (!best_.excludes(polynomials[k].lower_bound(), place_)) run(parts[k], polynomials[k]);
  }

  const Vec3& shift_;
  const SquarePlace& place_;
  const DistanceObjective& objective_;
  ClosestSoFar& best_;
};

}  // namespace

void ClosestSoFar::offer(const Vec3& y, const SquarePlace& place, const Vec2& uv, int held) {
  const double value = objective_->value(y);
  if (value > largest_) return;
  if (value >= better_) {  // equal
    const bool earlier = held == held_ && goes_before(place);
    if (!earlier && held >= held_) return;
  }
  held_ = held;
  value_ = value;
  smallest_ = objective_->closer(value, objective_->tolerance());
  better_ = objective_->closer(value, tie_);
  largest_ = objective_->closer(value, -tie_);
  place_ = place;
  uv_ = uv;
  y_ = y;
}

void search_patch(const BezierPatch& patch, const Vec3& shift, const SquarePlace& place,
                  const DistanceObjective& objective, ClosestSoFar& best) {
  // F is convex in space: it lies above its tangent plane at any point, say the patch's middle.
  const Vec3 middle =
      0.25 * (patch.row(5) + patch.row(6) + patch.row(9) + patch.row(10)).transpose();
  const Vec3 n = objective.gradient(shift + middle);
  const double plane = objective.value(shift + middle) + (patch * n).minCoeff() - n.dot(middle);
  if (best.excludes(plane, place)) return;
  const DistancePolynomial polynomial(patch, shift, objective);
  if (best.excludes(polynomial.lower_bound(), place)) return;
  Search(shift, place, objective, best).run({patch, Vec2::Zero(), Vec2::Ones()}, polynomial);
}

}  // namespace limes
