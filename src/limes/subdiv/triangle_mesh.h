#pragma once

#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"

namespace limes {

/// A triangle mesh that changes under the stellar operators: edge split, face split, their inverses
/// (welds), and the edge flip. Every operator costs as much as the ring it touches and keeps a
/// surface a surface.
///
/// The halfedge 3 f + i starts at corner i of face f. An operator rewrites the faces it touches, so
/// halfedges of these faces mean something else afterwards; all others keep their meaning. A vertex
/// or face that a weld removed leaves a gap in the numbers, which topology() closes.
class TriangleMesh {
 public:
  /// @throws InputError if a face is no triangle
  explicit TriangleMesh(const Adjacency& start);

  [[nodiscard]] int num_vertices() const { return num_vertices_; }  ///< with gaps
  [[nodiscard]] int num_faces() const { return static_cast<int>(corners_.size()) / 3; }  ///< too
  [[nodiscard]] bool has_face(FaceId f) const { return corners_[HalfedgeId(3 * f.value)].valid(); }

  [[nodiscard]] HalfedgeId halfedge(FaceId f, int corner) const {
    return HalfedgeId(3 * f.value + corner);
  }
  [[nodiscard]] FaceId face(HalfedgeId h) const { return FaceId(h.value / 3); }
  [[nodiscard]] HalfedgeId next(HalfedgeId h) const {
    return HalfedgeId(h.value % 3 == 2 ? h.value - 2 : h.value + 1);
  }
  [[nodiscard]] HalfedgeId prev(HalfedgeId h) const {
    return HalfedgeId(h.value % 3 == 0 ? h.value + 2 : h.value - 1);
  }
  /// The same edge seen from the other face; invalid on the boundary.
  [[nodiscard]] HalfedgeId twin(HalfedgeId h) const { return twins_[h]; }
  [[nodiscard]] VertexId from(HalfedgeId h) const { return corners_[h]; }
  [[nodiscard]] VertexId to(HalfedgeId h) const { return corners_[next(h)]; }
  /// Third corner of the face of h.
  [[nodiscard]] VertexId opposite(HalfedgeId h) const { return corners_[prev(h)]; }
  /// Outgoing halfedges of the start of h, counter-clockwise from h, or from the boundary if there
  /// is one.
  [[nodiscard]] std::vector<HalfedgeId> ring(HalfedgeId outgoing) const;

  /// Puts a new vertex s on the edge a-b of h: the face (a, b, c) becomes (a, s, c), with a new face
  /// (s, b, c); the face on the other side likewise, as seen from there.
  /// @return s, which is num_vertices() from before
  VertexId split_edge(HalfedgeId h);

  /// Puts a new vertex s into the face (a, b, c): it becomes (a, b, s), with new faces (b, c, s) and
  /// (c, a, s).
  VertexId split_face(FaceId f);

  /// Whether flip() would leave a surface: the edge has two faces, and no edge joins their third
  /// corners yet.
  [[nodiscard]] bool can_flip(HalfedgeId h) const;
  /// Replaces the edge a-b between (a, b, c) and (b, a, d) by c-d: the faces become (c, d, b) and
  /// (d, c, a). Precondition: can_flip(h).
  void flip(HalfedgeId h);

  /// Whether h starts at a vertex that split_edge() could have put on an edge to to(h), and that edge
  /// can be there again.
  [[nodiscard]] bool can_weld_edge(HalfedgeId h) const;
  /// Inverse of split_edge(): removes the start of h. Precondition: can_weld_edge(h).
  void weld_edge(HalfedgeId h);

  /// Whether h starts at a vertex that split_face() could have made, and its face can be there again.
  [[nodiscard]] bool can_weld_face(HalfedgeId h) const;
  /// Inverse of split_face(): removes the start of h. Precondition: can_weld_face(h).
  void weld_face(HalfedgeId h);

  /// The mesh as it is now. Without welds vertices and faces keep their numbers; after them the gaps
  /// are closed, in order.
  [[nodiscard]] Topology topology() const;

 private:
  [[nodiscard]] bool are_joined(VertexId other, HalfedgeId outgoing) const;
  FaceId add_face();
  void set_face(FaceId f, VertexId a, VertexId b, VertexId c);
  void remove_faces(std::span<const HalfedgeId> halfedges);
  void link(HalfedgeId h, HalfedgeId twin);
  void bisect_face(HalfedgeId h, FaceId added, VertexId middle);
  void join_bisected(HalfedgeId first, HalfedgeId second, FaceId joined);

  int num_vertices_;
  std::vector<VertexId> removed_;  // vertices
  IdArray<HalfedgeId, VertexId> corners_;
  IdArray<HalfedgeId, HalfedgeId> twins_;
};

}  // namespace limes
