#include "limes/report/colour_map.h"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

/// Lightness is linear. The hue runs from violet (300) through blue and green to yellow (105); the
/// chroma is a parabola below what sRGB has along this way (least, 0.104, at cyan), so nothing is
/// cut off and nothing has a kink.
Colour sequential_colour(double t) {
  const double lightness = 0.27 + 0.65 * t;
  const double hue = 300 - 195 * std::pow(t, 1.15);
  const double chroma = 0.1 + 0.2 * (t - 0.45) * (t - 0.45);
  return to_srgb({lightness, chroma, hue});
}

/// One arm per sign. The lightness is a hyperbola in the distance from the middle: even along the
/// arms, without a kink (a false line) at the neutral value. The chroma stays within sRGB, too.
Colour diverging_colour(double t) {
  constexpr double roundness = 0.08;
  const double s = 2 * t - 1;
  const double distance = (std::sqrt(s * s + roundness * roundness) - roundness) /
                          (std::sqrt(1 + roundness * roundness) - roundness);
  const double lightness = 0.965 - 0.565 * distance;
  const double chroma = 0.172 * std::sin(2.1 * distance);
  return to_srgb({lightness, chroma, s < 0 ? 262.0 : 27.0});
}

}  // namespace

ColourMap::ColourMap(Colour (*formula)(double)) {
  for (int i = 0; i < size; ++i)
    table_[static_cast<std::size_t>(i)] = formula(static_cast<double>(i) / (size - 1));
}

const ColourMap& ColourMap::sequential() {
  static const ColourMap map(sequential_colour);
  return map;
}

const ColourMap& ColourMap::diverging() {
  static const ColourMap map(diverging_colour);
  return map;
}

const Colour& ColourMap::operator()(double t) const {
  if (std::isnan(t)) return palette::no_data;
  return table_[static_cast<std::size_t>(std::clamp(t, 0.0, 1.0) * (size - 1) + 0.5)];
}

double ColourScale::normalised(double value) const {
  if (std::isnan(value)) return value;
  return high > low ? (value - low) / (high - low) : 0.5;
}

Colour ColourScale::at_normalised(double t) const {
  if (bands > 0 && !std::isnan(t))
    t = (std::clamp(std::floor(t * bands), 0.0, bands - 1.0) + 0.5) / bands;
  return (*map)(t);
}

Range range_of(std::span<const double> values) {
  return robust_range_of(values, 0);
}

Range robust_range_of(std::span<const double> values, double outliers) {
  std::vector<double> finite;
  finite.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double x) { return std::isfinite(x); });
  if (finite.empty()) return {};
  const auto skipped = static_cast<std::ptrdiff_t>(outliers * static_cast<double>(finite.size()));
  const auto pick = [&](std::ptrdiff_t rank) {
    std::nth_element(finite.begin(), finite.begin() + rank, finite.end());
    return finite[static_cast<std::size_t>(rank)];
  };
  const double low = pick(skipped);
  return {low, pick(static_cast<std::ptrdiff_t>(finite.size()) - 1 - skipped)};
}

ColourScale scale_for(const Range& range) {
  if (range.low < 0 && range.high > 0) return diverging_scale(range);
  if (range.high - range.low <= 1e-9 * std::max(std::abs(range.low), std::abs(range.high))) {
    const double middle = range.low + (range.high - range.low) / 2;
    return {.map = &ColourMap::sequential(), .low = middle, .high = middle};
  }
  return {.map = &ColourMap::sequential(), .low = range.low, .high = range.high};
}

ColourScale diverging_scale(const Range& range) {
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  return {.map = &ColourMap::diverging(), .low = -magnitude, .high = magnitude};
}

}  // namespace limes
