#pragma once

#include <string_view>

#include "limes/subdiv/neighbourhood.h"
#include "limes/subdiv/stencil.h"

namespace limes {

/// Which faces a scheme can start from.
enum class FaceKind { polygons, quads, triangles };

/// How topology splits.
enum class Split {
  quads,         ///< every face into one quad per corner, see split.h
  triangles,     ///< every triangle into four, see split.h
  dual,          ///< a face for every face, edge and vertex, see explicit_split.h
  mid_edge,      ///< a face for every face and vertex, see explicit_split.h
  sqrt3,         ///< a triangle for every edge of every triangle, see explicit_split.h
  four_eight,    ///< first triangles around every face's middle, then halves, see explicit_split.h
  longest_edges  ///< halves of triangles, by their positions: quasi_four_eight.h
};

/// Whether children are numbered by arithmetic (split.h): every face falls into faces of its own.
[[nodiscard]] constexpr bool is_quadrisection(Split split) {
  return split == Split::quads || split == Split::triangles;
}

/// What a regular face's limit is.
enum class LimitPatch {
  none,       ///< not polynomial
  bilinear,   ///< of the face's own corners
  bicubic,    ///< uniform cubic B-spline of the 16 control points around the face
  box_spline  ///< quartic box spline of the 12 control points around a triangle
};

/// What a scheme does at the boundary of a surface.
enum class Boundary {
  creases,  ///< BoundaryRule: a crease, or faces that only support others
  own,      ///< a rule of its own, always the same
  shrinks,  ///< none: the surface ends before its boundary
  quasi,    ///< QuasiBoundary
  open_net  ///< curves of their own, also at creases; faces extrapolated beyond (open_net.h)
};

/// A subdivision scheme: how topology splits, and for each new vertex the weights of the old ones.
/// A rule sees a neighbourhood, never a mesh; it writes a cleared stencil. The schemes are rows of
/// all_schemes (schemes.h).
struct Scheme {
  std::string_view name;
  std::string_view summary;  ///< one line for people
  FaceKind faces;
  Split split;
  bool linear = true;  ///< refinement is a matrix, the same for positions and other fields
  bool needs_positions = false;  ///< topology of the next level depends on positions
  LimitPatch patch = LimitPatch::none;
  int reach;  ///< rings of faces around a face that its limit depends on
  Boundary boundary;
  bool creases = false;  ///< the rules know sharp edges and vertices; if not, they are refused
  bool wide = false;     ///< rules of faces and edges see the rings of the corners
  bool interpolatory = false;  ///< old vertices stay where they are, on the limit

  // Null where the split makes no vertex of this kind.
  void (*face_rule)(const FaceNeighbourhood&, const RuleOptions&, Stencil&) = nullptr;
  void (*edge_rule)(const EdgeNeighbourhood&, const RuleOptions&, Stencil&) = nullptr;
  void (*vertex_rule)(const VertexNeighbourhood&, const RuleOptions&, Stencil&) = nullptr;
  /// Of the new vertex that a face puts near its corner.
  void (*corner_rule)(const FaceNeighbourhood&, int corner, const RuleOptions&, Stencil&) = nullptr;
};

/// Whether LimitBasis evaluates the limits of a scheme.
[[nodiscard]] inline bool has_exact_limit(const Scheme& scheme) {
  return scheme.patch != LimitPatch::none;
}

/// Corners of the faces that the split makes, and of faces whose limit can be one patch.
[[nodiscard]] inline int regular_face_size(const Scheme& scheme) {
  return scheme.split == Split::triangles ? 3 : 4;
}

}  // namespace limes
