#pragma once

#include <string>
#include <vector>

namespace limes {

/// Where an axis or a colour bar is labelled, and how.
struct Ticks {
  std::vector<double> values;       ///< ascending
  std::vector<std::string> labels;  ///< one per value, with the sign U+2212 and canvas markup
  int exponent = 0;                 ///< labels are values / 10^exponent; to be said once, beside

  /// "×10^{5}", empty if the exponent is 0.
  [[nodiscard]] std::string factor() const;
};

/// Multiples of 1, 2 or 5 times a power of ten inside [low, high], at most `most` of them (>= 2).
/// All labels have the same number of digits after the point.
[[nodiscard]] Ticks linear_ticks(double low, double high, int most);

/// Powers of ten inside [low, high], low > 0, every k-th if there were more than `most`; within
/// less than two decades also 2 and 5 times a power of ten. Labels "10^{-3}", or "0.01" if
/// all of them are short that way.
[[nodiscard]] Ticks log_ticks(double low, double high, int most);

/// A number for people: `digits` significant ones, no trailing zeros, U+2212 as sign, and
/// "1.2×10^{-7}" (canvas markup) when far from 1.
[[nodiscard]] std::string format_readable(double value, int digits = 4);

}  // namespace limes
