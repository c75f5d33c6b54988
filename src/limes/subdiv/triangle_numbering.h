#pragma once

#include <cstdint>
#include <vector>

namespace limes {

/// Which of a control triangle's three sides it owns: bit s is set where it is the first face at the
/// edge of side s. The vertices on a side are numbered with the face that owns it.
using OwnedTriangleSides = unsigned;

/// Where the numbering of quadrisection (split.h), applied `depth` times, puts the vertices of one
/// control triangle among many. They have integer coordinates on the finest grid, side = 2^depth:
///
///     corner 2 = (0, side)
///            |\.
///     side 2 |  \  side 1          j runs upwards
///            |    \.
///            +------+  corner 1 = (side, 0)
///     corner 0 = (0, 0)  side 0    i runs to the right
///
/// The vertices born at step b = 1..depth, one per edge of the grid of step b - 1, form a run of
/// consecutive numbers within each control triangle. Runs and their order are those of the general
/// code on a mesh of a single triangle; edges on sides that another face owns are left out.
class TriangleNumbering {
 public:
  struct EdgeNode {
    std::uint8_t i, j;     ///< the middle of the edge, on the finest grid
    std::int8_t side;      ///< side it lies on, or -1
    std::uint8_t step;     ///< position along that side, from corner `side` on
    std::uint16_t corner;  ///< where the edge starts in its first cell: 3 cell + corner
  };

  static constexpr int max_depth = 5;

  /// @param depth  number of steps, 1 <= depth <= max_depth
  explicit TriangleNumbering(int depth);

  [[nodiscard]] int depth() const { return depth_; }
  [[nodiscard]] int side() const { return 1 << depth_; }

  /// Edges of the grid of step birth - 1, in order.
  [[nodiscard]] const std::vector<EdgeNode>& edges(int birth) const { return step(birth).edges; }
  /// Edge that starts at a corner of a cell of that grid, by 3 cell + corner.
  [[nodiscard]] const std::vector<std::uint16_t>& edge_at_corner(int birth) const {
    return step(birth).edge_at_corner;
  }
  /// Axis (direction modulo 3, triangle_sides.h) on which the general code starts the ring of a vertex
  /// of that grid, as far as this triangle alone knows; by TriangleGrid::place(i, j).
  [[nodiscard]] const std::vector<std::uint8_t>& axes(int birth) const { return step(birth).axes; }

 private:
  struct Step {
    std::vector<EdgeNode> edges;
    std::vector<std::uint16_t> edge_at_corner;
    std::vector<std::uint8_t> axes;
  };
  [[nodiscard]] const Step& step(int birth) const {
    return steps_[static_cast<std::size_t>(birth - 1)];
  }

  int depth_;
  std::vector<Step> steps_;  // by birth - 1
};

}  // namespace limes
