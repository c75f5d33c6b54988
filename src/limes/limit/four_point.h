#pragma once

#include "limes/core/types.h"

namespace limes {

/// A row of weights on six neighbouring points f_{-2} ... f_3 of a curve; its span is from f_0 to f_1.
using SixWeights = Eigen::Matrix<double, 1, 6>;

/// Limit of the four-point scheme [dyn_1987] at t: exact up to rounding for every double t, from the
/// halves and quarters of the span that its binary digits name.
/// @param t      in [0, 1]
/// @param omega  1/16 reproduces cubics
[[nodiscard]] SixWeights four_point_value(double t, double omega);

/// Its derivative in t. Precondition: 0 <= omega < (sqrt 5 - 1) / 8, where the limit is C1.
[[nodiscard]] SixWeights four_point_derivative(double t, double omega);

}  // namespace limes
