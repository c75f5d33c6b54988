#pragma once

#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"

namespace limes {

/// Edges between each vertex and the middle, counted along faces; most + 1 for all that lie further out.
[[nodiscard]] IdArray<VertexId, int> rings_around(const Topology& mesh, VertexId middle, int most);

/// The pattern of a triangle mesh around an interior vertex: the faces of so many rings, how they hang
/// together, and which of their edges a step will split. Two codes are the same if and only if a
/// renumbering that keeps the middle, its orientation and the marked edges turns one pattern into the
/// other; a mirror image is another pattern. Faces that hang on the others by a corner only do not
/// count.
/// @param to_split  at most one edge of every face
/// Precondition: middle is not on the boundary.
[[nodiscard]] std::vector<int> pattern_code(const Adjacency& mesh, VertexId middle,
                                            const std::vector<EdgeId>& to_split, int rings);

}  // namespace limes
