#pragma once

#include <array>
#include <optional>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/features.h"

namespace limes {

/// Moves between the first sides (i, j) -> (i + 1, j) of the faces of a grid of quads.
/// Precondition of every move: the face it leads to exists.
class GridWalk {
 public:
  explicit GridWalk(const Adjacency& mesh) : mesh_(&mesh) {}
  [[nodiscard]] HalfedgeId right(HalfedgeId h) const {
    return mesh_->next(mesh_->twin(mesh_->next(h)));
  }
  [[nodiscard]] HalfedgeId left(HalfedgeId h) const {
    return mesh_->prev(mesh_->twin(mesh_->prev(h)));
  }
  [[nodiscard]] HalfedgeId up(HalfedgeId h) const {
    return mesh_->twin(mesh_->next(mesh_->next(h)));
  }
  [[nodiscard]] HalfedgeId down(HalfedgeId h) const {
    return mesh_->next(mesh_->next(mesh_->twin(h)));
  }

 private:
  const Adjacency* mesh_;
};

/// The 6 x 6 vertices around a face: (i, j) is entry 6 (j + 2) + i + 2, (0, 0) the face's first
/// corner, i along its first side, j along its last.
using GridBlock = std::array<VertexId, 36>;

/// The block around a face if its inner 4 x 4 vertices have four faces each, all quads, and neither
/// they nor their edges are sharp: then a scheme that reaches two rings is a tensor product there.
[[nodiscard]] std::optional<GridBlock> grid_block(const Adjacency& mesh, const Sharpness& sharpness,
                                                  FaceId f);

/// Whether a vertex has four quads around it and no sharp edge.
[[nodiscard]] bool is_regular(const Adjacency& mesh, const Sharpness& sharpness, VertexId v);

}  // namespace limes
