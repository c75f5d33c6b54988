#pragma once

#include <array>
#include <vector>

#include "limes/study/shell_model.h"

namespace limes {

/// Whether the faces on both sides of an inner edge are one smooth piece of one material.
[[nodiscard]] bool is_smooth_across(const ShellModel& model, HalfedgeId h);

/// Edges of the mesh as pairs of vertices, each once.
struct PieceEdges {
  std::vector<std::array<int, 2>> inside;   ///< of a smooth piece
  std::vector<std::array<int, 2>> borders;  ///< boundary, seams, kinks, changes of the material
};
[[nodiscard]] PieceEdges edges_of_pieces(const ShellModel& model);

}  // namespace limes
