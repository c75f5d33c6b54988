#pragma once

#include <string>
#include <vector>

#include "limes/spectrum/rules.h"

namespace limes::app {

/// Weights at the points of a lattice as a picture in text, "1/64 of" and whole numbers where they have
/// a common denominator up to 65536, else decimals. Columns are x, rows are y, upwards.
[[nodiscard]] std::string lattice_layout(const std::vector<RuleWeight>& weights);

/// Weights around a vertex or face, one line for those that are equal within an orbit.
[[nodiscard]] std::string star_layout(const std::vector<RuleWeight>& weights, int num_sectors);

}  // namespace limes::app
