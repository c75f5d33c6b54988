#pragma once

#include "limes/subdiv/refine.h"

namespace limes::app {

/// The refined mesh with its vertices moved to their limit positions.
/// @throws InputError if the scheme has no limit that can be evaluated
[[nodiscard]] Mesh limit_mesh(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options);

}  // namespace limes::app
