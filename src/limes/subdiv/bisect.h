#pragma once

#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"

namespace limes {

/// Where a child of a bisected face starts.
enum class FirstCorner {
  kept,   ///< (a, b, c) split on a-b becomes (a, s, c) and (s, b, c)
  newest  ///< (s, c, a) and (s, b, c): the edge to split next lies opposite the first corner
};

/// One binary step of a triangle mesh: the chosen edges get a vertex in their middle, joined to the
/// opposite corners. Old vertices keep their numbers, the new ones follow in the order of the edges;
/// the children of a face stand in its place.
struct Bisection {
  Topology child;
  IdArray<EdgeId, VertexId> middle;     ///< of each edge of the parent; invalid: not split
  IdArray<FaceId, FaceId> parent_face;  ///< of each face of the child
  int num_unsplit = 0;                  ///< faces that stayed as they were
};

/// Precondition: no face has two of the edges.
/// @throws InputError if a face is no triangle, if two faces have the same corners, or if the child
///         would have too many faces to number
[[nodiscard]] Bisection bisect(const Adjacency& parent, std::span<const EdgeId> edges,
                               FirstCorner first_corner);

}  // namespace limes
