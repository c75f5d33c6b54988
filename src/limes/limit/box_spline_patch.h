#pragma once

#include <optional>

#include "limes/limit/regular_patch.h"

namespace limes {

/// The twelve box spline control points of the ring's triangle, if its limit under Loop's scheme is
/// one polynomial. That is so if each corner is (a) an interior vertex of valence 6 without sharp
/// edges, (b) on a boundary or infinitely sharp crease with three faces on this side, the triangle
/// any of them, or (c) a corner with this triangle alone between two such edges.
///
/// Points beyond a sharp edge (a, b) of a triangle (a, b, c) are a + b - c, and at a corner v with
/// sharp edges to a and b also 2 v - a and 2 v - b: with these the weights of a boundary are those of
/// the interior (docs/theory/loop.md).
[[nodiscard]] std::optional<PatchGrid> box_spline_patch(const Ring& ring);

}  // namespace limes
