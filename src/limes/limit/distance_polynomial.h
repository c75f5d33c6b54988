#pragma once

#include "limes/limit/distance_objective.h"

namespace limes {

/// F along a bicubic patch: a polynomial of degree 6 in u and in v, by its 7 x 7 Bernstein
/// coefficients. The smallest of them is a lower bound of F; their second differences bound the
/// second derivatives.
class DistancePolynomial {
 public:
  DistancePolynomial(const BezierPatch& patch, const Vec3& shift,
                     const DistanceObjective& objective);

  /// At most F on the whole patch, rounding included.
  [[nodiscard]] double lower_bound() const { return lower_bound_; }
  /// Where the polygon of coefficients is lowest.
  [[nodiscard]] Vec2 lowest() const {
    return {static_cast<double>(column_) / 6.0, static_cast<double>(line_) / 6.0};
  }
  /// Bounds of F's derivatives on the patch.
  struct Derivatives {
    Vec2 least, largest;     ///< F_u, F_v
    Vec2 least_second;       ///< F_uu, F_vv
    double least_curvature;  ///< of the eigenvalues of the second derivatives
  };
  [[nodiscard]] Derivatives derivatives() const;

 private:
  // Coefficient (k in u, l in v) is c_(k, l); the eighth row fills up a register.
  Eigen::Matrix<double, 8, 7> c_;
  double lower_bound_;
  Eigen::Index column_ = 0, line_ = 0;
};

}  // namespace limes
