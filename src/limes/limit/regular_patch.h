#pragma once

#include <optional>

#include "limes/core/types.h"
#include "limes/limit/ring.h"

namespace limes {

/// The control points of a patch as combinations of a ring's controls, one a row.
///
/// Bicubic, (16, num_controls): 4 x 4 uniform B-spline control points. Row 4 j + i is the point in
/// column i (along u) and line j (along v); the patch lies between columns and lines 1 and 2.
/// Box spline, (12, num_controls): in the order of box_spline_index.
using PatchGrid = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 16>;

/// The row of a patch's control point at corner 0.
[[nodiscard]] inline Eigen::Index corner_row(LimitPatch patch) {
  return patch == LimitPatch::box_spline ? 4 : 5;
}

/// The patch that is the limit of the ring's face, if that limit is one polynomial.
///
/// For Catmull-Clark that is a quad among quads whose every corner is (a) an interior vertex of
/// valence 4 without sharp edges, (b) on a boundary or infinitely sharp crease with one further face
/// on this side, or (c) a corner alone between two such edges. Points beyond a sharp edge are
/// 2 b - c ("phantoms", [barendrecht_2013] section 4, whose corner formula is misprinted: the right
/// one is the tensor product, 4 P6 - 2 P7 - 2 P10 + P11). For Loop see box_spline_patch.h.
[[nodiscard]] std::optional<PatchGrid> regular_patch(const Ring& ring, LimitPatch patch);

}  // namespace limes
