#pragma once

#include "limes/subdiv/forest_nodes.h"

namespace limes {

/// Limit positions for a forest (subdiv/forest.h) of a scheme that is not interpolatory.
/// Precondition: has_exact_limit(scheme).
[[nodiscard]] LimitsOf forest_limits(const Scheme& scheme);

}  // namespace limes
