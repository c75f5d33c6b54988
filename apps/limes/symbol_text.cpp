#include "symbol_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "limes/math/fraction.h"

namespace limes::app {
namespace {

std::string power_text(int exponent) {
  if (exponent == 0) return {};
  return exponent == 1 ? "z" : fmt::format("z^{}", exponent);
}

/// "3 z^2"; a coefficient 1 is left out before a power.
std::string term_text(double size, int exponent) {
  const std::string power = power_text(exponent);
  if (power.empty()) return fmt::format("{}", size);
  return size == 1 ? power : fmt::format("{} {}", size, power);
}

}  // namespace

std::string symbol_text(const CurveMask& mask) {
  const auto denominator = common_denominator(mask.weights, {.most_denominator = 1 << 20});
  std::string terms;
  for (std::size_t i = 0; i < mask.weights.size(); ++i) {
    double coefficient = mask.weights[i];
    if (denominator) coefficient = std::round(coefficient * static_cast<double>(*denominator));
    if (coefficient == 0) continue;
    if (terms.empty())
      terms = coefficient < 0 ? "-" : "";
    else
      terms += coefficient < 0 ? " - " : " + ";
    terms += term_text(std::abs(coefficient), mask.first + static_cast<int>(i));
  }
  if (denominator.value_or(1) == 1) return terms;
  return fmt::format("({}) / {}", terms, *denominator);
}

}  // namespace limes::app
