#pragma once

#include <array>

#include "limes/core/types.h"

namespace bench {

/// Derivatives at a point from values around it, exact but for rounding where the surface is
/// bicubic within 2 h of it: 5 x 5 values, fourth-order differences.
/// Returns xu, xv, xuu, xuv, xvv.
template <class Position>
std::array<limes::Vec3, 5> differences(const Position& position, const limes::Vec2& uv, double h) {
  const std::array<double, 5> first{1.0 / 12, -8.0 / 12, 0, 8.0 / 12, -1.0 / 12};
  const std::array<double, 5> second{-1.0 / 12, 16.0 / 12, -30.0 / 12, 16.0 / 12, -1.0 / 12};
  std::array<limes::Vec3, 5> out;
  out.fill(limes::Vec3::Zero());
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < 5; ++j) {
      const limes::Vec3 x =
          position(uv + h * limes::Vec2(static_cast<double>(i) - 2, static_cast<double>(j) - 2));
      if (j == 2) out[0] += first[i] / h * x;
      if (i == 2) out[1] += first[j] / h * x;
      if (j == 2) out[2] += second[i] / (h * h) * x;
      out[3] += first[i] * first[j] / (h * h) * x;
      if (i == 2) out[4] += second[j] / (h * h) * x;
    }
  }
  return out;
}

}  // namespace bench
