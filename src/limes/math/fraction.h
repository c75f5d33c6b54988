#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace limes {

struct Fraction {
  std::int64_t numerator, denominator;
  friend bool operator==(const Fraction&, const Fraction&) = default;
};

/// How a number is recognised as a fraction. With the defaults a number that is none is taken for one
/// once in 10^5 times.
struct FractionOptions {
  std::int64_t most_denominator = 65536;
  double tolerance = 4e-15;  ///< relative to 1, or to the number if that is larger
};

/// The first convergent of the continued fraction of x that is x but for rounding, or nothing.
[[nodiscard]] std::optional<Fraction> as_fraction(double x, const FractionOptions& options = {});

/// The least denominator that all the numbers have in common; nothing if one is no fraction or the
/// denominator is larger than most_denominator.
[[nodiscard]] std::optional<std::int64_t> common_denominator(std::span<const double> numbers,
                                                             const FractionOptions& options = {});

}  // namespace limes
