#pragma once

#include <span>
#include <vector>

#include "limes/core/types.h"
#include "limes/subdiv/features.h"

namespace limes {

/// What the ghost ring does at a boundary vertex.
enum class GhostType {
  side,        ///< 2 faces: one ghost beyond the vertex
  crease_end,  ///< the same, and a sharp edge runs on into the ghosts
  corner,      ///< 1 face, sharp: two ghosts beside it and one diagonally beyond
  reentrant,   ///< 3 faces, sharp: one ghost face between the two boundary edges
  standard     ///< not made regular; one ghost that no element feels
};

/// A boundary vertex with its two boundary halfedges (interior on the left).
struct BoundaryVertex {
  VertexId vertex;
  HalfedgeId in, out;  ///< the boundary halfedges that end and start here
  GhostType type = GhostType::standard;
  float sharpness = 0;  ///< of the vertex
};

/// The boundary of a mesh, vertex by vertex; what the ghosts do is decided for all of them together.
class BoundaryTypes {
 public:
  BoundaryTypes(const Adjacency& control, const Sharpness& sharpness, std::span<const Vec3> points);

  [[nodiscard]] const std::vector<BoundaryVertex>& vertices() const { return vertices_; }
  /// Index in vertices() of the one before or after along the boundary.
  [[nodiscard]] int previous(int i) const { return previous_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] int next(int i) const { return next_[static_cast<std::size_t>(i)]; }

  /// The boundary edge that leaves vertex i keeps the standard functions: it is a crease.
  [[nodiscard]] bool crease_after(int i) const;
  /// Both boundary edges at vertex i are creases.
  [[nodiscard]] bool fully_standard(int i) const {
    return crease_after(i) && crease_after(previous(i));
  }

 private:
  [[nodiscard]] const BoundaryVertex& at(int i) const {
    return vertices_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] bool is_standard(int i) const { return at(i).type == GhostType::standard; }
  void collect(const Adjacency& control);
  [[nodiscard]] GhostType type_alone(const Adjacency& control, const Sharpness& sharpness,
                                     const BoundaryVertex& b, std::span<const Vec3> points) const;
  void settle();

  std::vector<BoundaryVertex> vertices_;
  std::vector<int> previous_, next_;
};

}  // namespace limes
