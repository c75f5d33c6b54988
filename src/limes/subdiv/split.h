#pragma once

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/scheme.h"

namespace limes {

// Quadrisection: every face becomes one quad per corner.
//
// Numbering, level by level: old vertices keep their ids, then one vertex per edge (edges in order
// of first appearance in (face, corner) order), then one per face. The child at corner i of a face
// is (v_i, e_i, f, e_{i-1}) and has the id of the halfedge at that corner, so ancestry is
// arithmetic: the parent of child c is the face of halfedge c, and for quads c / 4.

struct QuadrisectionIds {
  int num_vertices;  ///< of the parent
  int num_edges;     ///< of the parent

  [[nodiscard]] VertexId of_vertex(VertexId v) const { return v; }
  [[nodiscard]] VertexId of_edge(EdgeId e) const { return VertexId(num_vertices + e.value); }
  [[nodiscard]] VertexId of_face(FaceId f) const {
    return VertexId(num_vertices + num_edges + f.value);
  }
};

[[nodiscard]] inline QuadrisectionIds quadrisection_ids(const Adjacency& parent) {
  return {parent.topology().num_vertices(), parent.num_edges()};
}

/// Child face at the corner where h starts.
[[nodiscard]] inline FaceId quadrisection_child(HalfedgeId h) {
  return FaceId(h.value);
}

/// @throws InputError if the child would have more than 2^31 - 1 corners or vertices
[[nodiscard]] Topology quadrisect(const Adjacency& parent);

// Split of triangles: every triangle becomes four. Vertices are numbered as above, without those of
// faces. The child of face f at corner i is (v_i, e_i, e_{i-1}) and has the id 4 f + i; the child in
// the middle is (e_0, e_1, e_2), 4 f + 3.

/// What `split` makes of a mesh.
/// @throws InputError like quadrisect()
[[nodiscard]] Topology split_topology(const Adjacency& parent, Split split);
[[nodiscard]] std::int64_t num_split_vertices(const Adjacency& parent, Split split);
[[nodiscard]] std::int64_t num_split_faces(const Topology& parent, Split split);

/// The faces that a face becomes after some steps: [begin, end).
struct FaceRange {
  std::int64_t begin, end;
};
[[nodiscard]] FaceRange descendants(const Topology& control, FaceId f, Split split, int levels);
/// Marks of faces, one per face, handed down to their descendants.
[[nodiscard]] std::vector<bool> descendants(const Topology& control,
                                            const std::vector<bool>& marked, Split split,
                                            int levels);

/// Parameters in a quad of a point of one of its descendants.
/// @param uv    in the descendant, in [0, 1]^2; (0, 0) is its first corner, u runs along its first edge
/// @param path  which child was taken on each level, as digits to the base of 4, the first one highest
[[nodiscard]] Vec2 in_ancestor(Vec2 uv, std::int64_t path, int levels);

/// The sharpness that is left one level down.
[[nodiscard]] Features split_features(const Adjacency& parent, const Features& features,
                                      Split split);

}  // namespace limes
