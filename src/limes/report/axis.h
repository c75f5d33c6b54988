#pragma once

#include "limes/report/plot.h"
#include "limes/report/ticks.h"

namespace limes {

/// One axis: values to shares of its length.
class Axis {
 public:
  Axis() = default;
  /// From the least to the greatest value with some room around; a single value gets a range, too.
  Axis(AxisScale scale, double least, double greatest);

  [[nodiscard]] bool shows(double value) const;
  /// 0 at the low end, 1 at the high end.
  [[nodiscard]] double at(double value) const;
  /// The inverse of at().
  [[nodiscard]] double value(double share) const;
  /// The same axis, longer at its low end by a share of its length.
  [[nodiscard]] Axis grown(double share) const;

  [[nodiscard]] Ticks ticks(int most) const;
  /// Fine grid lines of a logarithmic axis: 2 to 9 times powers of ten.
  [[nodiscard]] std::vector<double> minor() const;

  [[nodiscard]] AxisScale scale() const { return scale_; }

 private:
  [[nodiscard]] double coordinate(double value) const;

  AxisScale scale_ = AxisScale::linear;
  double low_ = 0, high_ = 1;  // coordinates: values or their decimal logarithms
};

}  // namespace limes
