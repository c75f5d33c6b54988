#pragma once

#include <cstdint>

#include "limes/curve/curve_scheme.h"
#include "limes/curve/polyline.h"

namespace limes {

/// One step of a scheme on a control polygon.
///
/// Closed: n points become 2 n; with a primal scheme old point i becomes number 2 i.
///
/// Open, primal: n points become 2 n - 1. Beyond an end the polygon goes on as its reflection in the end
/// point, P(-k) = 2 P(0) - P(k). So ends stay where they are and are points of the limit; for cubic B-splines
/// that is the boundary curve of catmull-clark, for four-point the phantom 2 b - c of a breakpoint.
///
/// Open, dual: only points that need nothing beyond the ends, 2 n - degree. The limit is the uniform
/// B-spline on its own domain; Chaikin's begins and ends in the middle of a side, like a surface
/// of doo-sabin.
///
/// @throws InputError if the polygon has too few points
[[nodiscard]] Polyline refine(const Polyline& coarse, const CurveScheme& scheme);

/// Number of points after some steps.
[[nodiscard]] double refined_size(std::size_t num_points, bool closed, const CurveScheme& scheme,
                                  int levels);

}  // namespace limes
