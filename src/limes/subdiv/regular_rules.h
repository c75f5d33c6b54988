#pragma once

#include <optional>

#include "limes/subdiv/scheme.h"

namespace limes {

// A scheme's rules where every face is a quad and every vertex has four edges, asked once from the
// scheme itself and then applied along grids.

/// The rules away from features, as groups of equal weights.
struct RegularMasks {
  double face;                                          ///< of each corner
  double edge_ends, edge_faces;                         ///< two ends, two new face points
  double vertex_self, vertex_neighbours, vertex_faces;  ///< itself, four ends, four face points
};

/// Nothing if the rules of the scheme are not of this form.
[[nodiscard]] std::optional<RegularMasks> regular_masks(const Scheme& scheme);

/// The rules on a line of edges of equal sharpness that runs straight through regular vertices, or
/// on a straight boundary. The ids in the stencils are those of LinePlace:
///
///          inner                 face 1   |   face 0
///   previous + next            ----------- + -----------     `outer` and faces 2, 3 do not exist
///          outer                 face 2   |   face 3         on a boundary
struct LineRules {
  enum Place { self, next, inner, previous, outer };
  Stencil edge;    ///< of the edge from self to next, between faces 0 and 3
  Stencil vertex;  ///< of self
};

[[nodiscard]] LineRules line_rules(const Scheme& scheme, float sharpness, bool boundary);

}  // namespace limes
