#pragma once

#include "limes/subdiv/forest.h"

namespace limes {

/// The forest with every leaf split `levels` times more: leaves meet as they did, each with 2^levels sides
/// instead of one. The descendants of leaf i are the 4^levels leaves from 4^levels i on.
/// @throws InputError if a leaf is too deep to be split so often
[[nodiscard]] Forest split_leaves(Forest forest, int levels);

}  // namespace limes
