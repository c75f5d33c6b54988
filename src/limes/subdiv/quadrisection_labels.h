#pragma once

#include <string>
#include <vector>

#include "limes/mesh/adjacency.h"

namespace limes {

/// What a vertex of a quadrisected mesh was made of.
enum class VertexOrigin : unsigned char { unknown, old_vertex, edge, face };

using VertexOrigins = IdArray<VertexId, VertexOrigin>;

/// Faces that hang together by edges, ascending; components are ordered by their first face.
[[nodiscard]] std::vector<std::vector<FaceId>> edge_components(const Adjacency& adjacency);

/// Labels of the vertices of a mesh of quads, found component by component.
class QuadrisectionLabels {
 public:
  explicit QuadrisectionLabels(const Adjacency& adjacency);

  /// Labels one component as a quadrisection in which corner `first_old` of its first face is an
  /// old vertex; forgets earlier labels of this component.
  /// @return empty, or why there is no such labelling: one sentence that names a vertex or face
  [[nodiscard]] std::string label(const std::vector<FaceId>& component, int first_old);

  [[nodiscard]] const VertexOrigins& origins() const { return origins_; }

 private:
  const Adjacency* adjacency_;
  VertexOrigins origins_;
  std::vector<bool> visited_;
};

/// The mesh that was quadrisected: the labelled faces put together again.
struct Unsplit {
  Topology topology;
  std::vector<VertexId> old_vertex;      ///< fine id by coarse vertex, ascending
  IdArray<FaceId, VertexId> face_point;  ///< by coarse face
  /// By coarse halfedge: the child face at its start, and the child's halfedge along its first half,
  /// which ends at the edge point.
  IdArray<HalfedgeId, FaceId> child;
  IdArray<HalfedgeId, HalfedgeId> half;
};

/// Coarse vertices and faces keep the order of the fine ones they come from; the first corner of a
/// coarse face is that of its first child. Vertices without faces count as old.
/// Precondition: all vertices of `faces` are labelled.
/// @param all_vertices  also those that none of the faces uses
[[nodiscard]] Unsplit unsplit(const Adjacency& adjacency, const VertexOrigins& origins,
                              const std::vector<FaceId>& faces, bool all_vertices);

}  // namespace limes
