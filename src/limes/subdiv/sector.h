#pragma once

#include "limes/subdiv/neighbourhood.h"
#include "limes/subdiv/stencil.h"

namespace limes {

// Boundary stencils by sector [biermann_2000], for Catmull-Clark: the surface at a boundary vertex
// with k faces covers an angle alpha, pi where the boundary is smooth. With theta = alpha / k the
// inner edges there use gamma = 3/8 - 1/4 cos theta, so that the edges of a plane sector of equal
// angles are an eigenvector for 1/2. At a concave corner (alpha > pi) another eigenvector has a larger
// eigenvalue, and the surface folds: there the new vertices around the corner are drawn to the plane
// sector, by as much as brings that eigenvalue to 1/4.

/// Whether the stencil of an edge changes: it lies inside and has one end on the boundary, or both of
/// which one is a corner.
[[nodiscard]] bool has_sector(const EdgeNeighbourhood& edge);

/// The row of such an edge, into a cleared stencil.
void add_sector_edge(const EdgeNeighbourhood& edge, Stencil& out);

/// Draws the row of a face's new vertex to the plane sector of a concave corner among the face's
/// corners. Precondition: the neighbourhood is a wide one.
void flatten_face(const FaceNeighbourhood& face, Stencil& row);

}  // namespace limes
