#pragma once

#include "limes/adapt/smoothing.h"

namespace limes {

/// Lets the vertices of a refined mesh slide on the surface that a finer refinement shows, as its quads
/// cut into triangles: each within the faces around it, those of the boundary and of tagged creases not
/// at all.
///
/// @param mesh   all quads; may be moved while sliding
/// @param stays  of each vertex whether it stays as well; with an interpolatory scheme those of the
///               control mesh
/// @param fine   the same `steps` quadrisections later; kept by reference
/// @pre children of face f are the faces from f 4^steps on
[[nodiscard]] Sliding sliding_on_refinement(const Mesh& mesh, const Mesh& fine, int steps,
                                            IdArray<VertexId, char> stays);

}  // namespace limes
