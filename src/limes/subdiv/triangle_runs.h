#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "limes/subdiv/triangle_numbering.h"

namespace limes {

/// The order of a control triangle's vertices in its runs, by which of its sides it owns: what
/// TriangleNumbering says, as indices that loops can use.
class TriangleRuns {
 public:
  TriangleRuns(const TriangleNumbering& numbering, OwnedTriangleSides owned);

  [[nodiscard]] int num_edges(int birth) const { return step(birth).num_edges; }
  /// Where the vertices of all runs lie in the finest TriangleGrid, counted in doubles: runs of birth
  /// 1 .. depth.
  [[nodiscard]] const std::vector<std::uint16_t>& offsets() const { return offsets_; }
  /// Number within the run of the edge that starts at a corner of a cell of the grid of step birth - 1,
  /// by 3 cell + corner; 0 for edges on sides of other owners.
  [[nodiscard]] const std::vector<std::int32_t>& edge_ranks(int birth) const {
    return step(birth).edge_ranks;
  }
  /// Edges along a side, from corner `side` on: where their vertices are among the corners of the
  /// finer cells, three times each, and their numbers within the run.
  struct SideVertex {
    std::array<std::uint16_t, 3> places;
    std::uint16_t rank;
  };
  [[nodiscard]] const std::vector<SideVertex>& side_vertices(int birth, int side) const {
    return step(birth).side_vertices[static_cast<std::size_t>(side)];
  }

 private:
  struct Step {
    int num_edges = 0;
    std::vector<std::int32_t> edge_ranks;
    std::array<std::vector<SideVertex>, 3> side_vertices;
  };
  [[nodiscard]] const Step& step(int birth) const {
    return steps_[static_cast<std::size_t>(birth - 1)];
  }

  std::vector<Step> steps_;  // by birth - 1
  std::vector<std::uint16_t> offsets_;
};

}  // namespace limes
