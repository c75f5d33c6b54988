#pragma once

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Features after several steps of quadrisection of a mesh whose faces are all quads, or all
/// triangles: split_features() (split.h) again and again, without the meshes in between.
/// Precondition: no semi-sharp edges with Chaikin's method
[[nodiscard]] Features refined_features(const Adjacency& control, const Features& features,
                                        Split split, int depth);

}  // namespace limes
