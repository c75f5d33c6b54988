#pragma once

// OKLab coordinates of drawn pixels, by the matrices in Ottosson's "A perceptual color space for image
// processing" (2020), to measure pictures; the library only goes the other way.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "limes/core/types.h"
#include "limes/report/colour_map.h"

namespace limes::testing {

inline Vec3 oklab_of(std::span<const std::uint8_t> rgb) {
  const auto linear = [&](std::size_t i) {
    const double c = rgb[i] / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const Vec3 light(linear(0), linear(1), linear(2));
  Mat3 cones, lab;
  cones << 0.4122214708, 0.5363325363, 0.0514459929,  //
      0.2119034982, 0.6806995451, 0.1073969566,       //
      0.0883024619, 0.2817188376, 0.6299787005;
  lab << 0.2104542553, 0.7936177850, -0.0040720468,  //
      1.9779984951, -2.4285922050, 0.4505937099,     //
      0.0259040371, 0.7827717662, -0.8086757660;
  return lab * (cones * light).array().pow(1.0 / 3).matrix();
}

/// What a reader takes a colour for: the value of the bar whose colour looks most alike, and how far that is.
struct Reading {
  double value = 0, distance = 1e9;
};

class BarReader {
 public:
  explicit BarReader(const ColourScale& scale) : scale_(scale) {
    for (std::size_t i = 0; i < bar_.size(); ++i)
      bar_[i] = oklab_of(to_bytes(scale(value(i))));
  }

  [[nodiscard]] Reading operator()(std::span<const std::uint8_t> rgb) const {
    const Vec3 seen = oklab_of(rgb);
    Reading out;
    for (std::size_t i = 0; i < bar_.size(); ++i) {
      const double distance = (bar_[i] - seen).norm();
      if (distance < out.distance) out = {value(i), distance};
    }
    return out;
  }

 private:
  [[nodiscard]] double value(std::size_t i) const {
    return scale_.low + (scale_.high - scale_.low) * static_cast<double>(i) /
                            static_cast<double>(bar_.size() - 1);
  }

  ColourScale scale_;
  std::array<Vec3, 501> bar_;
};

/// Degrees.
inline double hue_of(const Vec3& lab) {
  return std::atan2(lab.z(), lab.y()) * 180 / 3.14159265358979323846;
}

}  // namespace limes::testing
