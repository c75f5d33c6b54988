#pragma once

#include <array>

#include "limes/subdiv/quad_sides.h"

namespace limes {

/// The six directions of a triangular grid, counter-clockwise: from (i, j) to its neighbours.
///
///        d2   d1
///      d3   +   d0        d0 = (1, 0), d1 = (0, 1), d2 = d1 - d0
///        d4   d5
inline GridPoint triangle_direction(int k) {
  constexpr std::array<GridPoint, 6> directions{
      {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
  return directions[static_cast<std::size_t>(((k % 6) + 6) % 6)];
}

/// A side of a triangular grid of n cells a side, from corner `side` to the next, counter-clockwise.
class TriangleSide {
 public:
  TriangleSide(int side, int n) : side_(side), n_(n) {}

  /// Number of its direction: even.
  [[nodiscard]] int direction() const { return 2 * side_; }
  [[nodiscard]] GridPoint node(int along) const {
    constexpr std::array<GridPoint, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
    return n_ * corners[static_cast<std::size_t>(side_)] + along * triangle_direction(direction());
  }

 private:
  int side_;
  int n_;
};

}  // namespace limes
