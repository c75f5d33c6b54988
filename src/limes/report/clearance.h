#pragma once

#include <span>
#include <vector>

#include "limes/core/types.h"

namespace limes {

/// Whether a closed convex outline keeps `space` away from all curves, given by their points, and holds
/// no part of one.
[[nodiscard]] bool is_clear(const std::vector<std::vector<Vec2>>& curves,
                            std::span<const Vec2> outline, double space);

}  // namespace limes
