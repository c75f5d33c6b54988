#pragma once

#include <array>

#include "limes/core/types.h"

namespace limes {

/// Values of the four uniform cubic B-splines that live on [0, 1], and their derivatives.
struct CubicBSpline {
  std::array<double, 4> value, first, second;
};

/// @param t  in [0, 1]
[[nodiscard]] inline CubicBSpline cubic_bspline(double t) {
  const double s = 1.0 - t;
  const double t2 = t * t;
  const double s2 = s * s;
  return {{s2 * s / 6.0, (3.0 * t2 * (t - 2.0) + 4.0) / 6.0, (3.0 * s2 * (s - 2.0) + 4.0) / 6.0,
           t2 * t / 6.0},
          {-s2 / 2.0, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), t2 / 2.0},
          {s, 3.0 * t - 2.0, 3.0 * s - 2.0, t}};
}

}  // namespace limes
