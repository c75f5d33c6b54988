#include "limes/limit/distance_polynomial.h"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

using Matrix4 = Eigen::Matrix4d;
using Products = Eigen::Matrix<double, 8, 7>;

constexpr std::array<double, 4> binomial3{1, 3, 3, 1};
constexpr std::array<double, 7> binomial6{1, 6, 15, 20, 15, 6, 1};

/// Coefficients in the basis u^i (1 - u)^(3 - i) v^j (1 - v)^(3 - j), in which multiplying is a
/// convolution.
const Matrix4& cubic_scale() {
  static const Matrix4 scale = [] {
    Matrix4 s;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        s(i, j) = binomial3[static_cast<std::size_t>(i)] * binomial3[static_cast<std::size_t>(j)];
    return s;
  }();
  return scale;
}

const Products& sextic_scale() {
  static const Products scale = [] {
    Products s = Products::Zero();
    for (int k = 0; k < 7; ++k)
      for (int l = 0; l < 7; ++l)
        s(k, l) =
            1.0 / (binomial6[static_cast<std::size_t>(k)] * binomial6[static_cast<std::size_t>(l)]);
    return s;
  }();
  return scale;
}

/// sum += a b, polynomials of u.
void add_product(const Eigen::Vector4d& a, const Eigen::Vector4d& b, double* sum) {
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
      sum[i + k] += a[i] * b[k];
}

}  // namespace

DistancePolynomial::DistancePolynomial(const BezierPatch& patch, const Vec3& shift,
                                       const DistanceObjective& objective) {
  c_.setZero();
  for (Eigen::Index d = 0; d < 3; ++d) {
    const Matrix4 y = Eigen::Map<const Matrix4>(patch.col(d).data()).array() + shift[d];
    const Matrix4 p = y.cwiseProduct(cubic_scale());
    // half of alpha y y; pairs of different lines count twice
    for (Eigen::Index j = 0; j < 4; ++j) {
      add_product(0.5 * objective.alpha() * p.col(j), p.col(j), c_.col(2 * j).data());
      for (Eigen::Index l = j + 1; l < 4; ++l)
        add_product(objective.alpha() * p.col(j), p.col(l), c_.col(j + l).data());
    }
    if (objective.w()[d] == 0) continue;
    for (Eigen::Index j = 0; j < 4; ++j)  // w y times one
      for (Eigen::Index l = 0; l < 4; ++l)
        add_product(objective.w()[d] * p.col(j), cubic_scale().col(l), c_.col(j + l).data());
  }
  c_ = c_.cwiseProduct(sextic_scale());
  const auto values = c_.topRows<7>();
  const double smallest = values.minCoeff(&column_, &line_);
  const double rounding = 2e-15 * std::max(std::abs(smallest), values.maxCoeff());
  lower_bound_ = std::max(objective.least(), smallest - rounding);
}

DistancePolynomial::Derivatives DistancePolynomial::derivatives() const {
  using U = Eigen::Matrix<double, 6, 7>;
  using V = Eigen::Matrix<double, 7, 6>;
  const auto c = c_.topRows<7>();
  const U du = 6.0 * (c.bottomRows<6>() - c.topRows<6>());
  const V dv = 6.0 * (c.rightCols<6>() - c.leftCols<6>());
  const double uu = 5.0 * (du.bottomRows<5>() - du.topRows<5>()).minCoeff();
  const double vv = 5.0 * (dv.rightCols<5>() - dv.leftCols<5>()).minCoeff();
  const double uv = 6.0 * (du.rightCols<6>() - du.leftCols<6>()).cwiseAbs().maxCoeff();
  Derivatives d;
  d.least = {du.minCoeff(), dv.minCoeff()};
  d.largest = {du.maxCoeff(), dv.maxCoeff()};
  d.least_second = {uu, vv};
  // [[F_uu, F_uv], [F_uv, F_vv]] exceeds [[uu, F_uv], [F_uv, vv]] by a positive matrix
  d.least_curvature = 0.5 * (uu + vv) - std::sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv);
  return d;
}

}  // namespace limes
