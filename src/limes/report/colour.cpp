#include "limes/report/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limes {
namespace {

using Rgb = std::array<double, 3>;

/// OKLab to linear RGB with the sRGB primaries, by the matrices of the 2020 article.
Rgb to_linear(const OkLch& colour) {
  const double angle = colour.hue * std::numbers::pi / 180;
  const double a = colour.chroma * std::cos(angle);
  const double b = colour.chroma * std::sin(angle);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(colour.lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(colour.lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(colour.lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool fits(const Rgb& linear) {
  constexpr double slack = 1e-4;
  return std::all_of(linear.begin(), linear.end(),
                     [](double x) { return x >= -slack && x <= 1 + slack; });
}

/// The transfer function of sRGB, IEC 61966-2-1.
float encode(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

}  // namespace

std::array<std::uint8_t, 3> to_bytes(const Colour& colour) {
  const auto byte = [](float x) {
    return static_cast<std::uint8_t>(std::clamp(x, 0.0F, 1.0F) * 255 + 0.5F);
  };
  return {byte(colour.r), byte(colour.g), byte(colour.b)};
}

std::string to_css(const Colour& colour) {
  const auto [r, g, b] = to_bytes(colour);
  return fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
}

Colour mix(const Colour& a, const Colour& b, float t) {
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

Colour to_srgb(const OkLch& colour) {
  OkLch fitting = colour;
  if (!fits(to_linear(fitting))) {
    double low = 0;
    double high = colour.chroma;
    for (int step = 0; step < 40; ++step) {
      fitting.chroma = (low + high) / 2;
      (fits(to_linear(fitting)) ? low : high) = fitting.chroma;
    }
    fitting.chroma = low;
  }
  const Rgb linear = to_linear(fitting);
  return {encode(linear[0]), encode(linear[1]), encode(linear[2])};
}

}  // namespace limes
