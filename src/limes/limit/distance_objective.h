#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "limes/limit/bezier_patch.h"
#include "limes/limit/box_tree.h"

namespace limes {

/// What a search for the closest point to q minimises, as a function of the point x of space:
/// F(x) = y . (alpha / 2 y + w) with y = x - origin, which is
///
/// - |x - q|^2 for q near the surface (origin q, alpha 2, w 0),
/// - (|x - q|^2 - D^2) / (2 D) for q at a large distance D from the surface's middle c (origin c,
///   alpha 1 / D, w = (c - q) / D): the large number D^2 is left out, so that no digits are lost.
///   At infinite distance F is linear.
class DistanceObjective {
 public:
  /// @param size  of the surface; it bounds the error of the distance at the result by 1e-13 size
  DistanceObjective(const Vec3& q, const Vec3& centre, double size) : tolerance_(1e-13 * size) {
    const double D = (q - centre).stableNorm();
    is_far_ = D > 4.0 * size;
    if (!is_far_) {
      origin_ = q;
      return;
    }
    const Vec3 toward = q * 0x1p-4 - centre * 0x1p-4;  // finite
    origin_ = centre;
    w_ = -toward / toward.stableNorm();
    alpha_ = 1.0 / std::min(D, 1e300);
  }

  [[nodiscard]] const Vec3& origin() const { return origin_; }
  [[nodiscard]] double alpha() const { return alpha_; }
  [[nodiscard]] const Vec3& w() const { return w_; }
  [[nodiscard]] bool is_far() const { return is_far_; }
  /// What is 1e-13 of the surface's size: 0 for a surface that is one point.
  [[nodiscard]] double tolerance() const { return tolerance_; }

  /// A number below all values.
  [[nodiscard]] double least() const {
    return is_far_ ? -std::numeric_limits<double>::infinity() : 0.0;
  }
  /// @param y  relative to origin()
  [[nodiscard]] double value(const Vec3& y) const { return y.dot(0.5 * alpha_ * y + w_); }
  [[nodiscard]] Vec3 gradient(const Vec3& y) const { return alpha_ * y + w_; }

  /// F at a distance that is smaller by `length` than the one that belongs to F, at least the
  /// smallest F there is.
  [[nodiscard]] double closer(double F, double length) const {
    if (is_far_ || F == std::numeric_limits<double>::infinity()) return F - length;
    const double d = std::max(0.0, std::sqrt(F) - length);
    return d * d;
  }

  /// Minimum of F over a box. @param lower, upper  relative to origin()
  [[nodiscard]] double minimum(const Vec3& lower, const Vec3& upper) const {
    return value((-w_ / alpha_).cwiseMax(lower).cwiseMin(upper));
  }

  /// Minima of F over four boxes.
  [[nodiscard]] std::array<double, 4> minima(const BoxTree::Boxes4& boxes) const {
    std::array<double, 4> sum{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto d = static_cast<Eigen::Index>(axis);
      const double c = origin_[d], w = w_[d], a = 0.5 * alpha_, lowest = -w / alpha_;
      for (std::size_t k = 0; k < 4; ++k) {
        const double lower = boxes.lower[axis][k] - c, upper = boxes.upper[axis][k] - c;
        const double y = std::min(std::max(lowest, lower), upper);
        sum[k] += y * (a * y + w);
      }
    }
    return sum;
  }

 private:
  Vec3 origin_ = Vec3::Zero(), w_ = Vec3::Zero();
  double alpha_ = 2.0, tolerance_;
  bool is_far_ = false;
};

}  // namespace limes
