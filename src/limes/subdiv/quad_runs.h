#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "limes/subdiv/quad_numbering.h"

namespace limes {

/// The order of a control quad's vertices in its runs, by which of its sides it owns: what
/// QuadNumbering says, as indices that loops can use.
class QuadRuns {
 public:
  QuadRuns(const QuadNumbering& numbering, OwnedSides owned);

  /// Vertices of the edge run of a birth; the face run has one per cell.
  [[nodiscard]] int num_edges(int birth) const { return step(birth).num_edges; }
  /// Where the vertices of all runs lie in the finest QuadGrid, counted in doubles: runs of birth
  /// 1 .. depth, edges then faces.
  [[nodiscard]] const std::vector<std::uint16_t>& offsets() const { return offsets_; }
  /// Number within the edge run of the edge that starts at a corner of a cell of the grid of step
  /// birth - 1, by 4 cell + corner; 0 for edges on sides of other owners.
  [[nodiscard]] const std::vector<std::int32_t>& edge_ranks(int birth) const {
    return step(birth).edge_ranks;
  }
  /// Edges along a side, from corner `side` on: where their vertices are among the corners of the
  /// finer cells, twice each.
  struct SideVertex {
    std::uint16_t first, second;
  };
  [[nodiscard]] const SideVertex* side_vertices(int birth, int side) const {
    return step(birth).side_vertices[static_cast<std::size_t>(side)].data();
  }
  /// And their numbers within the edge run.
  [[nodiscard]] const std::uint16_t* side_ranks(int birth, int side) const {
    return step(birth).side_ranks[static_cast<std::size_t>(side)].data();
  }

 private:
  template <class T>
  using BySide = std::array<std::array<T, 1 << (QuadNumbering::max_depth - 1)>, 4>;
  struct Step {
    int num_edges = 0;
    std::vector<std::int32_t> edge_ranks;
    BySide<SideVertex> side_vertices{};
    BySide<std::uint16_t> side_ranks{};
  };
  [[nodiscard]] const Step& step(int birth) const {
    return steps_[static_cast<std::size_t>(birth - 1)];
  }

  std::vector<Step> steps_;  // by birth - 1
  std::vector<std::uint16_t> offsets_;
};

}  // namespace limes
