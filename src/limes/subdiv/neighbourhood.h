#pragma once

#include <array>
#include <span>
#include <vector>

#include "limes/subdiv/features.h"
#include "limes/subdiv/open_net.h"

namespace limes {

/// The ring of a vertex as the wide rules of faces and edges see it, counter-clockwise; on the
/// boundary from its first edge to its last.
struct Spokes {
  VertexId centre;
  bool boundary;
  bool corner;   ///< an infinitely sharp boundary vertex
  double angle;  ///< of the surface at a boundary vertex, in radians; pi where not a corner
  int first;     ///< the edge that leads to the asking edge or face
  std::span<const VertexId> ends;       ///< other end of each edge
  std::span<const VertexId> diagonals;  ///< of the face after each edge: the corner after the next,
                                        ///< which in a quad is the one opposite the centre

  [[nodiscard]] int size() const { return static_cast<int>(ends.size()); }
  /// The edge k places after the first, counted around. Precondition: not on the boundary.
  [[nodiscard]] VertexId end(int k) const { return ends[turned(k)]; }
  [[nodiscard]] VertexId diagonal(int k) const { return diagonals[turned(k)]; }

 private:
  [[nodiscard]] std::size_t turned(int k) const {
    return static_cast<std::size_t>((((first + k) % size()) + size()) % size());
  }
};

/// What a rule sees of a face.
struct FaceNeighbourhood {
  FaceId face;
  std::span<const VertexId> corners;
  std::span<const Spokes> rings;  ///< of the corners, from the side after it; wide schemes only
  std::span<const CurveEdge> curves = {};  ///< of the sides; on open nets with curves only
};

/// What a rule sees of an edge.
struct EdgeNeighbourhood {
  std::array<VertexId, 2> ends;
  std::array<FaceId, 2> faces;  ///< only the first on the boundary
  std::array<int, 2> face_sizes;
  int num_faces;
  std::array<VertexId, 2> opposite;  ///< third corners of the faces that are triangles
  float sharpness;
  bool child_sharp;                  ///< both halves are still sharp on the next level
  int part = 0;                      ///< which of several new vertices, see ChildVertex
  std::array<Spokes, 2> rings = {};  ///< of the ends, from this edge; wide schemes only
  CurveEdge curve = {};              ///< on open nets
};

/// What a rule sees of a vertex: its ring, counter-clockwise. On the boundary the ring starts with
/// the first boundary edge and has one edge more than faces; face i lies between edges i and i + 1.
struct VertexNeighbourhood {
  VertexId vertex;
  std::span<const VertexId> neighbours;  ///< other end of each edge
  std::span<const FaceId> faces;
  float sharpness;
  float child_sharpness;
  std::span<const float> edge_sharpness;
  std::span<const float> child_edge_sharpness;
};

/// Collects neighbourhoods of one mesh. The spans it returns are valid until the next call; each
/// thread uses its own.
class NeighbourhoodWalk {
 public:
  /// All must outlive the walk. With an open net, rings are taken from there.
  NeighbourhoodWalk(const Adjacency& adjacency, const Features& features,
                    const Sharpness& sharpness, const OpenNet* open_net = nullptr)
      : adjacency_(&adjacency), features_(&features), sharpness_(&sharpness), open_net_(open_net) {}

  [[nodiscard]] FaceNeighbourhood face(FaceId f) const {
    return {f, adjacency_->topology().face(f), {}};
  }
  [[nodiscard]] EdgeNeighbourhood edge(EdgeId e);
  /// The same with rings and curves.
  [[nodiscard]] FaceNeighbourhood wide_face(FaceId f);
  [[nodiscard]] EdgeNeighbourhood wide_edge(EdgeId e);
  /// Precondition: v has a face.
  [[nodiscard]] VertexNeighbourhood vertex(VertexId v);

  /// Sharpness on the next level of the half of edge(h) that touches its start.
  [[nodiscard]] float child_sharpness_at_start(HalfedgeId h);

 private:
  void collect_ring(VertexId v);
  void collect_child_sharpness();
  /// Ring number i of a wide neighbourhood: that of the start of h, from h on.
  void collect_spokes(std::size_t i, HalfedgeId h);

  const Adjacency* adjacency_;
  const Features* features_;
  const Sharpness* sharpness_;
  const OpenNet* open_net_;
  std::vector<VertexId> neighbours_;
  std::vector<FaceId> faces_;
  std::vector<EdgeId> edges_;
  std::vector<float> edge_sharpness_;
  std::vector<float> child_edge_sharpness_;
  struct SpokeIds {
    std::vector<VertexId> ends, diagonals;
  };
  std::vector<SpokeIds> spoke_ids_;
  std::vector<Spokes> spokes_;
  std::vector<CurveEdge> curves_;
};

}  // namespace limes
