#pragma once

#include <array>
#include <span>
#include <vector>

#include "limes/subdiv/features.h"

namespace limes {

/// What a rule sees of a face.
struct FaceNeighbourhood {
  FaceId face;
  std::span<const VertexId> corners;
};

/// What a rule sees of an edge.
struct EdgeNeighbourhood {
  std::array<VertexId, 2> ends;
  std::array<FaceId, 2> faces;  ///< only the first on the boundary
  std::array<int, 2> face_sizes;
  int num_faces;
  std::array<VertexId, 2> opposite;  ///< third corners of the faces that are triangles
  float sharpness;
  bool child_sharp;  ///< both halves are still sharp on the next level
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
  /// All three must outlive the walk.
  NeighbourhoodWalk(const Adjacency& adjacency, const Features& features,
                    const Sharpness& sharpness)
      : adjacency_(&adjacency), features_(&features), sharpness_(&sharpness) {}

  [[nodiscard]] FaceNeighbourhood face(FaceId f) const {
    return {f, adjacency_->topology().face(f)};
  }
  [[nodiscard]] EdgeNeighbourhood edge(EdgeId e);
  /// Precondition: v has a face.
  [[nodiscard]] VertexNeighbourhood vertex(VertexId v);

  /// Sharpness on the next level of the half of edge(h) that touches its start.
  [[nodiscard]] float child_sharpness_at_start(HalfedgeId h);

 private:
  void collect_ring(VertexId v);
  void collect_child_sharpness();

  const Adjacency* adjacency_;
  const Features* features_;
  const Sharpness* sharpness_;
  std::vector<VertexId> neighbours_;
  std::vector<FaceId> faces_;
  std::vector<EdgeId> edges_;
  std::vector<float> edge_sharpness_;
  std::vector<float> child_edge_sharpness_;
};

}  // namespace limes
