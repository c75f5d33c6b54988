#pragma once

#include "limes/core/id_array.h"
#include "limes/mesh/topology.h"

namespace limes {

/// Who lies next to whom in a topology: twins, edges and the start of every vertex ring.
/// Keeps a reference to the topology, which must outlive it.
///
/// Faces are taken as counter-clockwise. Around a vertex, ring_next goes counter-clockwise; the ring
/// of a boundary vertex starts at the boundary, that of an interior vertex at its first face, so the
/// order of a ring does not depend on how it was reached.
class Adjacency {
 public:
  enum class Check {
    surface,  ///< everything below
    edges     ///< edges only: for a refined surface, or a piece of one, whose rim may touch itself
  };

  /// @throws InputError if an edge has more than two faces or two faces of the same orientation,
  ///         if a face uses a vertex twice, or if the faces at a vertex do not form one fan; names
  ///         the faces
  explicit Adjacency(const Topology& topology, Check check = Check::surface);

  [[nodiscard]] const Topology& topology() const { return *topology_; }
  [[nodiscard]] int num_edges() const { return first_halfedge_.size(); }

  [[nodiscard]] FaceId face(HalfedgeId h) const {
    return face_size_ ? FaceId(h.value / face_size_) : face_of_[h];
  }
  /// Corner of its face at which h starts.
  [[nodiscard]] int corner_index(HalfedgeId h) const {
    return h.value - topology_->halfedge(face(h), 0).value;
  }
  [[nodiscard]] HalfedgeId next(HalfedgeId h) const;
  [[nodiscard]] HalfedgeId prev(HalfedgeId h) const;
  [[nodiscard]] VertexId from(HalfedgeId h) const { return topology_->corner(h); }
  [[nodiscard]] VertexId to(HalfedgeId h) const { return topology_->corner(next(h)); }
  /// The same edge seen from the other face; invalid on the boundary.
  [[nodiscard]] HalfedgeId twin(HalfedgeId h) const { return twin_[h]; }

  /// Edges are numbered by first appearance in (face, corner) order.
  [[nodiscard]] EdgeId edge(HalfedgeId h) const { return edge_[h]; }
  [[nodiscard]] HalfedgeId halfedge(EdgeId e) const { return first_halfedge_[e]; }
  [[nodiscard]] bool is_boundary(EdgeId e) const { return !twin_[first_halfedge_[e]].valid(); }

  /// First outgoing halfedge of the ring of v; invalid if no face uses v.
  [[nodiscard]] HalfedgeId ring_start(VertexId v) const { return ring_start_[v]; }
  /// Next outgoing halfedge counter-clockwise; invalid when the ring ends at the boundary.
  [[nodiscard]] HalfedgeId ring_next(HalfedgeId outgoing) const { return twin(prev(outgoing)); }
  [[nodiscard]] bool is_boundary(VertexId v) const {
    return ring_start_[v].valid() && !twin_[ring_start_[v]].valid();
  }
  /// Number of faces in the ring that starts at ring_start(v).
  [[nodiscard]] int num_ring_faces(VertexId v) const;
  /// Number of edges at v: the ring's faces, plus one on the boundary.
  [[nodiscard]] int valence(VertexId v) const {
    return num_ring_faces(v) + (is_boundary(v) ? 1 : 0);
  }

 private:
  void require_one_ring_per_vertex() const;

  const Topology* topology_;
  int face_size_;                        // 0 when faces differ
  IdArray<HalfedgeId, FaceId> face_of_;  // only when faces differ
  IdArray<HalfedgeId, HalfedgeId> twin_;
  IdArray<HalfedgeId, EdgeId> edge_;
  IdArray<EdgeId, HalfedgeId> first_halfedge_;
  IdArray<VertexId, HalfedgeId> ring_start_;
};

/// First halfedge of the edge between a and b, or an invalid one. Both ends are searched in turn: what
/// it costs is the smaller of the two valences, and the creases of a mesh with one large fan take
/// linear time.
[[nodiscard]] HalfedgeId find_edge(const Adjacency& adjacency, VertexId a, VertexId b);

/// Face of every halfedge.
[[nodiscard]] IdArray<HalfedgeId, FaceId> faces_of_halfedges(const Topology& topology);

/// Halfedges sorted into the edges they lie on, whatever the mesh: group g is
/// halfedges[offsets[g], offsets[g + 1]), ascending; groups are ordered by their (lower, higher)
/// vertex. Works on broken meshes; validation and Adjacency are built on it.
struct EdgeGroups {
  std::vector<HalfedgeId> halfedges;
  std::vector<int> offsets;
};
[[nodiscard]] EdgeGroups group_by_edge(const Topology& topology);

}  // namespace limes
