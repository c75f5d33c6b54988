#include "limes/report/axis.h"

#include <cmath>

namespace limes {
namespace {

constexpr double room = 0.06;  // of the axis at either end

}  // namespace

double Axis::coordinate(double value) const {
  return scale_ == AxisScale::logarithmic ? std::log10(value) : value;
}

Axis::Axis(AxisScale scale, double least, double greatest) : scale_(scale) {
  low_ = coordinate(least);
  high_ = coordinate(greatest);
  const double size = std::max(std::abs(low_), std::abs(high_));
  if (!(high_ - low_ > 1e-9 * size)) {
    const double half = scale == AxisScale::logarithmic ? 0.5 : size > 0 ? 0.1 * size : 1;
    low_ -= half;
    high_ += half;
  }
  const double extra = room * (high_ - low_);
  low_ -= extra;
  high_ += extra;
}

bool Axis::shows(double value) const {
  return std::isfinite(value) && (scale_ == AxisScale::linear || value > 0);
}

double Axis::at(double value) const {
  return (coordinate(value) - low_) / (high_ - low_);
}

double Axis::value(double share) const {
  const double c = low_ + share * (high_ - low_);
  return scale_ == AxisScale::logarithmic ? std::pow(10.0, c) : c;
}

Axis Axis::grown(double share) const {
  Axis result = *this;
  result.low_ -= share * (high_ - low_);
  return result;
}

Ticks Axis::ticks(int most) const {
  return scale_ == AxisScale::logarithmic ? log_ticks(value(0), value(1), most)
                                          : linear_ticks(low_, high_, most);
}

std::vector<double> Axis::minor() const {
  std::vector<double> result;
  if (scale_ == AxisScale::linear || high_ - low_ > 8) return result;
  for (int e = static_cast<int>(std::floor(low_)); e <= static_cast<int>(std::floor(high_)); ++e) {
    for (int digit = 2; digit <= 9; ++digit) {
      const double c = e + std::log10(digit);
      if (c > low_ && c < high_) result.push_back(std::pow(10.0, c));
    }
  }
  return result;
}

}  // namespace limes
