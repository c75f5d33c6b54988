#pragma once

#include <optional>
#include <string>

#include "limes/spectrum/spectrum.h"

namespace limes::app {

/// "3/8" where a weight of a rule is a fraction with a denominator up to 65536.
[[nodiscard]] std::optional<std::string> weight_fraction(double weight);
/// The same, else a decimal.
[[nodiscard]] std::string weight_text(double weight);

/// Of a weight that comes from an eigenvector: up to 4096, to 1e-12.
[[nodiscard]] std::optional<std::string> limit_fraction(double weight);

/// The masks of one valence, orbit by orbit: tangents turn with the sector s as
/// cos(2 pi s / n + phase). Empty if there are none.
[[nodiscard]] std::string mask_table(const Spectrum& s, int num_sectors);

}  // namespace limes::app
