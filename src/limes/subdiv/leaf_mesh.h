#pragma once

#include <array>
#include <initializer_list>
#include <vector>

#include "limes/subdiv/local_refinement.h"

namespace limes {

/// Faces that leaves were cut into, with vertices of the refinement.
class LeafPieces {
 public:
  void add(FaceId leaf, std::span<const VertexId> corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    offsets_.push_back(static_cast<int>(corners_.size()));
    leaves_.push_back(leaf);
  }
  void add(FaceId leaf, std::initializer_list<VertexId> corners) {
    add(leaf, std::span(corners.begin(), corners.size()));
  }
  [[nodiscard]] const std::vector<VertexId>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<int>& offsets() const { return offsets_; }
  [[nodiscard]] const std::vector<FaceId>& leaves() const { return leaves_; }

 private:
  std::vector<VertexId> corners_;
  std::vector<int> offsets_{0};
  std::vector<FaceId> leaves_;
};

/// A vertex inside a side of a leaf. Fields that are linear along sides are continuous where the
/// value at the vertex is the mean of those at the ends.
struct HangingVertex {
  VertexId vertex;
  std::array<VertexId, 2> ends;
  friend bool operator==(const HangingVertex&, const HangingVertex&) = default;
};

/// The leaves of a locally refined mesh as a mesh. Vertices of the control mesh come first and keep
/// their ids, then the others by first appearance; faces follow the leaves. Creases, corners, holes,
/// groups and parts come along, and so does ancestry, as face fields `root`, `level` and `path`
/// (FaceAncestry).
struct ForestMesh {
  Mesh mesh;
  std::vector<FaceId> leaves;          ///< of each face, the leaf it lies in
  std::vector<VertexId> nodes;         ///< of each vertex, its number in the forest
  std::vector<HangingVertex> hanging;  ///< ascending; with Closure::hanging only
};

/// The mesh of some pieces, which cover the leaves in their order. None of its vertices hangs.
[[nodiscard]] ForestMesh leaf_mesh(const LocalRefinement& refined, const LeafPieces& pieces);

}  // namespace limes
