#pragma once

#include "limes/subdiv/neighbourhood.h"
#include "limes/subdiv/stencil.h"

namespace limes {

/// A scheme's rule at a vertex without sharp edges, its weights times `scale`.
using SmoothVertexRule = void (*)(const VertexNeighbourhood&, double scale, Stencil&);

/// The rule of a vertex by what meets there: the scheme's own where it is smooth or a dart, the cubic
/// B-spline along a crease, none at a corner; blended with the next level's where sharpness ends in
/// this step. [derose_1998] as OpenSubdiv defines it, the same for all schemes whose creases and
/// boundaries are cubic B-splines.
void add_vertex_rule(const VertexNeighbourhood& v, SmoothVertexRule smooth, Stencil& out);

}  // namespace limes
