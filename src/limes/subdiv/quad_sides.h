#pragma once

#include <array>

namespace limes {

/// Position on a grid.
struct GridPoint {
  int i, j;
  friend GridPoint operator+(GridPoint a, GridPoint b) { return {a.i + b.i, a.j + b.j}; }
  friend GridPoint operator-(GridPoint a, GridPoint b) { return {a.i - b.i, a.j - b.j}; }
  friend GridPoint operator*(int k, GridPoint a) { return {k * a.i, k * a.j}; }
};

/// A side of a grid of n x n cells, from corner `side` to the next, counter-clockwise.
class QuadSide {
 public:
  QuadSide(int side, int n) : side_(static_cast<std::size_t>(side)), n_(n) {}

  [[nodiscard]] GridPoint direction() const { return directions[side_]; }
  /// From the side into the grid: the direction turned left.
  [[nodiscard]] GridPoint inward() const { return directions[(side_ + 1) % 4]; }
  [[nodiscard]] GridPoint node(int along) const {
    constexpr std::array<GridPoint, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    return n_ * corners[side_] + along * directions[side_];
  }

 private:
  static constexpr std::array<GridPoint, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::size_t side_;
  int n_;
};

}  // namespace limes
