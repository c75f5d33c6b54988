#pragma once

#include <vector>

#include "limes/adapt/smoothing.h"
#include "limes/mesh/seams.h"
#include "limes/problem/problem.h"

namespace limes {

/// Vertices that the selections of a problem (of materials, loads, supports) end at, and which must stay
/// so that these mean the same afterwards: selected ones with a neighbour that is not; on a border
/// neighbours along it count. A selection of nothing holds nothing here; the model refuses it.
[[nodiscard]] IdArray<VertexId, char> held_by_selections(const Problem& problem, const Mesh& mesh);

/// Optimises the shapes of elements with vertices that slide on their exact surfaces: those inside a part
/// on its surface, those on a border or seam along it if it has a [[curve]] or more than one surface, else
/// they stay. So do corners: vertices on something that a neighbour along the border is not on; and what
/// held_by_selections() says. A vertex that hangs follows the ends of its side, and these stay if it must.
/// @param areas     that the faces should have, > 0; only their ratios count
/// @param surfaces  of each vertex what it lies on; those of tied vertices are the same
/// @param hanging   vertices inside sides, none on a seam
/// @pre all faces are quads
SmoothingResult improve_shapes(const Problem& problem, Mesh& mesh, const std::vector<double>& areas,
                               const std::vector<std::vector<const GeometrySettings*>>& surfaces,
                               const std::vector<TiedEdge>& tied, int sweeps,
                               std::span<const HangingVertex> hanging = {});

}  // namespace limes
