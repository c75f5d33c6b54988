#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace limes {

/// Which of a control quad's four sides it owns: bit s is set where it is the first face at the edge
/// of side s. The vertices on a side are numbered with the face that owns it.
using OwnedSides = unsigned;

/// Where the numbering of quadrisection (split.h), applied `depth` times, puts the vertices of one
/// control quad among many. They have integer coordinates on the finest grid, side = 2^depth:
///
///     corner 3 = (0, side)            corner 2 = (side, side)
///            +--------- side 2 ---------+
///     side 3 |   i runs to the right,   | side 1
///            |   j runs upwards         |
///            +--------- side 0 ---------+
///     corner 0 = (0, 0)               corner 1 = (side, 0)
///
/// The vertices born at step b = 1..depth, one per edge and one per face of the grid of step b - 1,
/// form two runs of consecutive numbers within each control quad. The runs and their order are those
/// of the general code on a mesh of a single quad; edges on sides that another face owns are left out.
class QuadNumbering {
 public:
  struct Node {
    std::uint8_t i, j;  ///< on the finest grid
  };
  struct EdgeNode {
    Node node;             ///< the middle of the edge
    std::int8_t side;      ///< side it lies on, or -1
    std::uint8_t step;     ///< position along that side, from corner `side` on
    std::uint16_t corner;  ///< where the edge starts in its first cell: 4 cell + corner
  };

  static constexpr int max_depth = 5;

  /// @param depth  number of steps, 1 <= depth <= max_depth
  explicit QuadNumbering(int depth);

  [[nodiscard]] int depth() const { return depth_; }
  [[nodiscard]] int side() const { return 1 << depth_; }

  /// Edges of the grid of step birth - 1, in order.
  [[nodiscard]] const std::vector<EdgeNode>& edges(int birth) const { return step(birth).edges; }
  /// Middles of the cells of that grid, in order.
  [[nodiscard]] const std::vector<Node>& faces(int birth) const { return step(birth).faces; }
  /// Edge that starts at a corner of a cell of that grid, by 4 cell + corner.
  [[nodiscard]] const std::vector<std::uint16_t>& edge_at_corner(int birth) const {
    return step(birth).edge_at_corner;
  }

 private:
  struct Step {
    std::vector<EdgeNode> edges;
    std::vector<Node> faces;
    std::vector<std::uint16_t> edge_at_corner;
  };
  [[nodiscard]] const Step& step(int birth) const {
    return steps_[static_cast<std::size_t>(birth - 1)];
  }

  int depth_;
  std::vector<Step> steps_;  // by birth - 1
};

}  // namespace limes
