#pragma once

#include <cstdint>

#include "limes/mesh/mesh.h"
#include "limes/problem/problem.h"

namespace limes::app {

/// Refuses a problem before its mesh is refined, as require_feasible() does: by the elements that [mesh]
/// levels and [adapt] reference_levels make.
/// @throws InputError that begins with the key's place, saying how many levels are possible
void require_feasible(const Problem& problem, const Mesh& control, std::int64_t memory_limit);

}  // namespace limes::app
