#pragma once

#include <string>

#include "limes/curve/curve_scheme.h"

namespace limes::app {

/// The symbol of a scheme, sum a_k z^k, lowest power first: "(z^-1 + 3 + 3 z + z^2) / 4". Decimals where the
/// coefficients have no common denominator up to 2^20.
[[nodiscard]] std::string symbol_text(const CurveMask& mask);

}  // namespace limes::app
