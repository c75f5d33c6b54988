#pragma once

#include <span>
#include <vector>

#include "limes/subdiv/forest.h"

namespace limes {

/// Sides of a leaf that are split: bit i is the side from corner i to corner i + 1.
using SideMask = unsigned;

/// For every leaf the sides on which its neighbour is split.
[[nodiscard]] std::vector<SideMask> sides_of_split_neighbours(const Forest& forest,
                                                              std::span<const FaceId> leaves);

/// Adds the sides that must be split besides, so that all leaves can be cut into quads: afterwards
/// every mask has an even number of sides. Precondition: SplitUnit::families.
void add_sides_for_quads(const Forest& forest, std::span<const FaceId> leaves,
                         std::vector<SideMask>& masks);

}  // namespace limes
