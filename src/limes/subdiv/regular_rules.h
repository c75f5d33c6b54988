#pragma once

#include <array>
#include <optional>

#include "limes/subdiv/scheme.h"

namespace limes {

// A scheme's rules where every face is a quad and every vertex has four edges, or every face is a
// triangle and every vertex has six: asked once from the scheme itself and then applied along grids.

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

/// The rules on triangles away from features: two ends and the third corners of two faces; itself and
/// six ends.
struct RegularTriangleMasks {
  double edge_ends, edge_opposite;
  double vertex_self, vertex_neighbours;
};

/// Nothing if the rules of the scheme are not of this form.
[[nodiscard]] std::optional<RegularTriangleMasks> regular_triangle_masks(const Scheme& scheme);

/// LineRules among triangles. The ids in the stencils are places: 0 is the vertex itself, 1 the next
/// one on the line, 2 to 6 the other neighbours counter-clockwise; 5 and 6 do not exist on a boundary.
struct TriangleLineRules {
  enum Place { self, next };
  Stencil edge;                   ///< of the edge from self to next
  std::array<Stencil, 3> vertex;  ///< of self, by the place less 1, modulo 3, where its ring starts
};

[[nodiscard]] TriangleLineRules triangle_line_rules(const Scheme& scheme, float sharpness,
                                                    bool boundary);

}  // namespace limes
