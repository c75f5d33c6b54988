#pragma once

#include "limes/adapt/smoothing.h"

namespace limes {

/// Lets the vertices of a refined mesh slide on the surface that a finer refinement shows, as its quads
/// cut into triangles: each within the faces around it, those of the boundary, of tagged creases and
/// the first `num_fixed` not at all. With an interpolatory scheme and num_fixed the number of control
/// vertices, the surface that the control vertices define stays as it is.
///
/// @param mesh   all quads; may be moved while sliding
/// @param fine   the same `steps` quadrisections later; kept by reference
/// @pre children of face f are the faces from f 4^steps on
[[nodiscard]] Sliding sliding_on_refinement(const Mesh& mesh, const Mesh& fine, int steps,
                                            int num_fixed);

}  // namespace limes
