#pragma once

#include <optional>

#include "limes/core/types.h"
#include "limes/limit/ring.h"

namespace limes {

/// Two rows (2, num_controls) that give tangent vectors t0, t1 at corner 0 of a self-similar ring,
/// with t0 x t1 along the normal of counter-clockwise faces; nothing where no tangent plane exists
/// in general: a crease or boundary vertex with five (Loop: seven) or more faces on one side, a corner
/// with three (four) or more.
/// @param patch  tells Catmull-Clark (bicubic) from Loop (box_spline)
/// @param A      the ring's refinement onto its child 0, (num_controls, num_controls)
[[nodiscard]] std::optional<Eigen::Matrix<double, 2, Eigen::Dynamic>> corner_tangents(
    const Ring& ring, LimitPatch patch, const SparseMatrix& A);

}  // namespace limes
