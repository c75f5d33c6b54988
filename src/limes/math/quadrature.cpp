#include "limes/math/quadrature.h"

#include <cmath>
#include <numbers>

#include "limes/core/error.h"

namespace limes {
namespace {

struct Legendre {
  double value, derivative;
};

/// P_n and its derivative by the three-term recurrence, |x| < 1.
Legendre legendre(int n, double x) {
  double previous = 1.0;
  double current = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2.0 * k - 1.0) * x * current - (k - 1.0) * previous) / k;
    previous = current;
    current = next;
  }
  return {current, n * (x * current - previous) / (x * x - 1.0)};
}

}  // namespace

QuadratureRule gauss_rule(int n) {
  LIMES_ASSERT(n >= 1 && n <= 64);
  const auto size = static_cast<std::size_t>(n);
  QuadratureRule rule{std::vector<double>(size), std::vector<double>(size)};
  for (std::size_t i = 0; i < (size + 1) / 2; ++i) {
    // Newton from an estimate of the i-th root; converges in a few steps for every n here.
    double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (n + 0.5));
    for (int step = 0; step < 20; ++step) {
      const Legendre p = legendre(n, x);
      const double change = p.value / p.derivative;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    if (2 * i + 1 == size) x = 0.0;
    const double d = legendre(n, x).derivative;
    const double w = 1.0 / ((1.0 - x * x) * d * d);
    rule.point[i] = 0.5 * (1.0 - x);
    rule.point[size - 1 - i] = 0.5 * (1.0 + x);
    rule.weight[i] = rule.weight[size - 1 - i] = w;
  }
  return rule;
}

}  // namespace limes
