#pragma once

#include <array>
#include <span>
#include <vector>

#include "limes/report/colour.h"

namespace limes {

/// Colours for numbers between 0 and 1. The maps are our own, given by formulas in OKLab, so that
/// equal steps of the value look like equal steps, also in grey and for the colour-blind.
class ColourMap {
 public:
  static constexpr int size = 256;

  /// Dark violet over blue and green to light yellow; lightness rises evenly.
  static const ColourMap& sequential();
  /// Blue over near-white to red; both arms darken evenly and alike.
  static const ColourMap& diverging();

  /// Below 0 and above 1 the end colours; NaN: palette::no_data.
  [[nodiscard]] const Colour& operator()(double t) const;
  [[nodiscard]] std::span<const Colour> table() const { return table_; }

 private:
  explicit ColourMap(Colour (*formula)(double));
  std::array<Colour, size> table_;
};

/// A map and the values at its ends.
struct ColourScale {
  const ColourMap* map = &ColourMap::sequential();
  double low = 0;
  double high = 1;
  int bands = 0;                       ///< > 0: this many steps instead of a smooth change
  std::vector<double> iso_lines = {};  ///< values drawn as thin lines

  /// 0 at low, 1 at high; 1/2 if both are equal.
  [[nodiscard]] double normalised(double value) const;
  [[nodiscard]] Colour at_normalised(double t) const;
  [[nodiscard]] Colour operator()(double value) const { return at_normalised(normalised(value)); }
};

struct Range {
  double low = 0;
  double high = 0;
};

/// Least and greatest finite value; {0, 0} if there is none.
[[nodiscard]] Range range_of(std::span<const double> values);
/// Without the `outliers` share of the values at either end: single peaks (a corner, a point load)
/// do not bleach the rest of the picture.
[[nodiscard]] Range robust_range_of(std::span<const double> values, double outliers);

/// A scale over the range: diverging and symmetric about 0 if both signs occur, else sequential. A range
/// that only rounding makes wide (1e-9 of its values) is one value.
[[nodiscard]] ColourScale scale_for(const Range& range);
/// Diverging, from -m to m, where m is the larger magnitude of the range.
[[nodiscard]] ColourScale diverging_scale(const Range& range);

}  // namespace limes
