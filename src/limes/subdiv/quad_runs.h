#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "limes/subdiv/quad_numbering.h"

namespace limes {

/// The order in which a control quad writes its vertices, by which of its sides it owns: what
/// QuadNumbering says, as indices into the grids of the last two steps.
struct QuadRuns {
  /// A vertex of the last grid but one that moves: its place, and the face point at its lower left.
  struct OldVertex {
    std::uint16_t vertex, face;
  };
  /// A new vertex on an edge of that grid: the edge's ends, and the face points beside it.
  struct NewEdge {
    std::uint16_t a, b, f, g;
  };
  std::vector<OldVertex> old_vertices;  ///< runs of birth 1 .. depth - 1, edges then faces
  std::vector<NewEdge> new_edges;       ///< run of birth depth
  std::vector<std::uint16_t> new_faces;

  /// Place on the finest grid, without margin, (side + 1) j + i, of all vertices but the corners:
  /// runs of birth 1 .. depth, edges then faces.
  std::vector<std::uint16_t> places;

  /// Number within its run of the edge vertex at `step` along a side that the quad owns.
  [[nodiscard]] int side_rank(int birth, int side, int step) const {
    return side_rank_[static_cast<std::size_t>(side)]
                     [static_cast<std::size_t>((1 << (birth - 1)) - 1 + step)];
  }

  QuadRuns(const QuadNumbering& numbering, OwnedSides owned);

 private:
  std::array<std::array<std::uint16_t, 1 << QuadNumbering::max_depth>, 4> side_rank_{};
};

}  // namespace limes
