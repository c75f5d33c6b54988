#pragma once

#include <vector>

#include "limes/adapt/smoothing.h"
#include "limes/mesh/seams.h"
#include "limes/study/problem.h"

namespace limes {

/// Optimises the shapes of elements with vertices that slide on their exact surfaces: those inside a part
/// on its surface, those on a border or seam along it if it has a [[curve]] or more than one surface, else
/// they stay. So do corners: vertices on something that a neighbour along the border is not on.
/// @param areas     that the faces should have, > 0; only their ratios count
/// @param surfaces  of each vertex what it lies on; those of tied vertices are the same
/// @pre all faces are quads
SmoothingResult improve_shapes(Mesh& mesh, const std::vector<double>& areas,
                               const std::vector<std::vector<const GeometrySettings*>>& surfaces,
                               const std::vector<TiedEdge>& tied, int sweeps);

}  // namespace limes
