#pragma once

#include <vector>

#include "limes/mesh/adjacency.h"

namespace limes::app {

/// Faces with a vertex on the boundary: those that BoundaryRule::none drops, by face.
[[nodiscard]] std::vector<bool> boundary_faces(const Adjacency& adjacency);

/// The marks of faces handed down to their children after some quadrisections.
[[nodiscard]] std::vector<bool> children_of_marked(const Topology& topology,
                                                   const std::vector<bool>& marked, int levels);

}  // namespace limes::app
