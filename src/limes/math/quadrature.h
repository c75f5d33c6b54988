#pragma once

#include <vector>

namespace limes {

/// Points and weights on [0, 1].
struct QuadratureRule {
  std::vector<double> point, weight;
};

/// Gauss-Legendre rule with n points, exact for polynomials of degree 2 n - 1.
/// Precondition: 1 <= n <= 64.
[[nodiscard]] QuadratureRule gauss_rule(int n);

}  // namespace limes
