#include "limes/math/fraction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limes {

std::optional<Fraction> as_fraction(double x, const FractionOptions& options) {
  const double tolerance = options.tolerance * std::max(1.0, std::abs(x));
  if (!(std::abs(x) < 1e9)) return std::nullopt;
  // Convergents p/q and the ones before.
  std::int64_t p = 1, q = 0, p_before = 0, q_before = 1;
  for (double rest = x;;) {
    const double whole = std::floor(rest);
    // Beyond it, the next denominator is too large anyway.
    if (std::abs(whole) > 1e9) return std::nullopt;
    const auto digit = static_cast<std::int64_t>(whole);
    const std::int64_t p_next = digit * p + p_before, q_next = digit * q + q_before;
    if (q_next > options.most_denominator) return std::nullopt;
    p_before = p, q_before = q, p = p_next, q = q_next;
    if (std::abs(x - static_cast<double>(p) / static_cast<double>(q)) <= tolerance)
      return Fraction{p, q};
    if (rest == whole) return std::nullopt;
    rest = 1.0 / (rest - whole);
  }
}

std::optional<std::int64_t> common_denominator(std::span<const double> numbers,
                                               const FractionOptions& options) {
  std::int64_t common = 1;
  for (const double x : numbers) {
    const auto fraction = as_fraction(x, options);
    if (!fraction) return std::nullopt;
    common = std::lcm(common, fraction->denominator);
    if (common > options.most_denominator) return std::nullopt;
  }
  return common;
}

}  // namespace limes
