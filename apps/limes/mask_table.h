#pragma once

#include <string>

#include "limes/spectrum/spectrum.h"

namespace limes::app {

/// "3/8" where a weight of a rule is a fraction with a denominator up to 65536, else a decimal.
[[nodiscard]] std::string weight_text(double weight);

/// The masks of one valence, orbit by orbit: tangents turn with the sector s as
/// cos(2 pi s / n + phase). Empty if there are none.
[[nodiscard]] std::string mask_table(const Spectrum& s, int num_sectors);

}  // namespace limes::app
