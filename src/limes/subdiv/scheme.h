#pragma once

#include <string_view>

#include "limes/subdiv/neighbourhood.h"
#include "limes/subdiv/stencil.h"

namespace limes {

/// Which faces a scheme can start from.
enum class FaceKind { polygons, quads, triangles };

/// How topology splits, see split.h.
enum class Split {
  quads,     ///< every face into one quad per corner
  triangles  ///< every triangle into four
};

/// What a regular face's limit is.
enum class LimitPatch {
  none,       ///< not polynomial
  bilinear,   ///< of the face's own corners
  bicubic,    ///< uniform cubic B-spline of the 16 control points around the face
  box_spline  ///< quartic box spline of the 12 control points around a triangle; not evaluated yet
};

/// A subdivision scheme: how topology splits, and for each new vertex the weights of the old ones.
/// A rule sees a neighbourhood, never a mesh; it writes a cleared stencil. The schemes are rows of
/// all_schemes (schemes.h).
struct Scheme {
  std::string_view name;
  std::string_view summary;  ///< one line for people
  FaceKind faces;
  Split split;
  bool linear;           ///< refinement is a matrix, the same for positions and any other field
  bool needs_positions;  ///< topology of the next level depends on positions
  LimitPatch patch;
  int reach;  ///< rings of faces around a face that its limit depends on

  void (*face_rule)(const FaceNeighbourhood&, Stencil&);  ///< null: faces have no new vertex
  void (*edge_rule)(const EdgeNeighbourhood&, const Features&, Stencil&);
  void (*vertex_rule)(const VertexNeighbourhood&, Stencil&);
};

/// Whether LimitBasis evaluates the limits of a scheme.
[[nodiscard]] inline bool has_exact_limit(const Scheme& scheme) {
  return scheme.patch == LimitPatch::bilinear || scheme.patch == LimitPatch::bicubic;
}

}  // namespace limes
