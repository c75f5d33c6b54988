#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"

namespace limes {

/// Where a face of a locally refined mesh comes from: the control face, and which child was taken on each
/// level, as digits of one number, the first one highest: to the base of 4 in a Forest, of 2 in a
/// BisectionForest (but for the first, which is a side of the control face).
struct FaceAncestry {
  FaceId root;
  int level;
  std::int64_t path;
  friend bool operator==(const FaceAncestry&, const FaceAncestry&) = default;
};

/// The mesh that is refined, with its adjacency.
struct ControlMesh {
  explicit ControlMesh(const Mesh& control) : mesh(control), adjacency(mesh.topology) {}
  ControlMesh(const ControlMesh&) = delete;
  ControlMesh& operator=(const ControlMesh&) = delete;

  Mesh mesh;
  Adjacency adjacency;
};

/// A mesh refined in places, however it splits faces: trees on the faces of a control mesh. A leaf is a
/// face that is not split. Faces and vertices have ids of its own, which stay valid; vertices of the
/// control mesh keep theirs.
class LocalRefinement {
 public:
  virtual ~LocalRefinement() = default;

  /// Splits leaves, and others as they ask for it.
  /// @return number of faces split. Leaves that were split meanwhile count once.
  /// @throws InputError beyond the deepest level; nothing is changed then. Interrupted, between levels
  virtual int refine(std::span<const FaceId> leaves) = 0;
  /// Takes back splits all of whose children are marked leaves, where their neighbours allow it.
  /// @return number of splits taken back
  virtual int coarsen(std::span<const FaceId> leaves) = 0;

  [[nodiscard]] virtual const Mesh& control() const = 0;
  /// All leaves: trees in order of the control faces, children in order.
  [[nodiscard]] std::vector<FaceId> leaves() const;
  /// Their ids follow each other.
  struct Children {
    FaceId first = {};
    int count = 0;  ///< 0: a leaf
  };
  [[nodiscard]] virtual Children children(FaceId f) const = 0;
  [[nodiscard]] virtual FaceAncestry ancestry(FaceId f) const = 0;
  [[nodiscard]] virtual std::span<const VertexId> corners(FaceId f) const = 0;

  [[nodiscard]] virtual int num_vertices() const = 0;  ///< that were ever made
  /// On the limit surface.
  [[nodiscard]] virtual const Vec3& position(VertexId v) const = 0;
  [[nodiscard]] virtual float edge_sharpness(VertexId a, VertexId b) const = 0;
  [[nodiscard]] virtual float vertex_sharpness(int level, VertexId v) const = 0;

 protected:
  LocalRefinement() = default;
  LocalRefinement(const LocalRefinement&) = default;
  LocalRefinement(LocalRefinement&&) = default;
  LocalRefinement& operator=(const LocalRefinement&) = default;
  LocalRefinement& operator=(LocalRefinement&&) = default;
};

}  // namespace limes
