#pragma once

#include <cstdint>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/scheme.h"

namespace limes {

// Splits other than quadrisection (split.h): where children come from is stored, not computed.

/// What a new vertex is made from.
struct ChildVertex {
  enum class Kind : std::uint8_t { vertex, edge, face, corner };
  Kind kind;
  std::int8_t part;   ///< which of several that one element makes
  std::int32_t from;  ///< id of the parent's vertex, edge, face or halfedge (corner)
};

struct ExplicitSplit {
  Topology topology;
  std::vector<ChildVertex> vertices;
  std::vector<FaceId> parents;  ///< of each child face, a face that it covers or touches
};

/// One step of a split that is not quadrisection.
///
/// dual: vertices by halfedge, one in every face near every corner; faces: one in every face, then one
/// across every interior edge, then one around every interior vertex. Halves of edges and vertices at
/// the boundary have none.
///
/// mid_edge: vertices by edge; faces: one in every face, then one around every interior vertex. Faces
/// with all corners on the boundary are left out, with the edges that only they have.
///
/// sqrt3: the old vertices, then one per face; child i of face f, 3 f + i, lies on side i. Every second
/// step cuts the boundary edges into three instead of giving their faces a vertex: two vertices per
/// boundary edge, in order of edges, follow the old ones.
///
/// four_eight: the first step puts a vertex into every face, numbered after the old ones, and makes a
/// triangle of it and each side, in order of corners. Every later one puts a vertex into the edge
/// opposite the first corner of every triangle, (c, a, b) becomes (s, c, a) and (s, b, c) in its place;
/// new vertices by ascending (lower, higher) end.
///
/// @throws InputError for what the split cannot be made of, naming the place, or too many vertices
[[nodiscard]] ExplicitSplit explicit_split(const Adjacency& parent, const Features& features,
                                           Split split);

}  // namespace limes
