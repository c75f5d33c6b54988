#pragma once

#include <array>

#include "limes/subdiv/point4.h"
#include "limes/subdiv/triangle_numbering.h"

namespace limes {

/// The points of one control triangle at one step of refinement, with a margin of one: the vertices of
/// the faces around it as if all were regular.
///
///      o o
///      o + o              n = 2 cells a side; + vertices (i, j), 0 <= i, j and i + j <= n
///      o + + o            o margin: i or j is -1, or i + j = n + 1
///      o + + + o
///        o o o o          sheared: i to the right, j upwards, see TriangleNumbering
///
/// Lines are as far apart in all grids, so that places differ by constants. On the grid one step
/// finer vertex (i, j) is (2 i, 2 j).
class TriangleGrid {
 public:
  static constexpr int max_cells = 1 << TriangleNumbering::max_depth;
  static constexpr int stride = max_cells + 3;
  static constexpr int num_places = stride * stride;
  [[nodiscard]] static constexpr int place(int i, int j) { return (j + 1) * stride + i + 1; }

  void resize(int cells) { n_ = cells; }
  [[nodiscard]] int cells() const { return n_; }

  [[nodiscard]] const Point4* points() const { return points_.data(); }
  [[nodiscard]] Point4* points() { return points_.data(); }
  [[nodiscard]] const Point4& point(int i, int j) const {
    return points_[static_cast<std::size_t>(place(i, j))];
  }
  [[nodiscard]] Point4& point(int i, int j) {
    return points_[static_cast<std::size_t>(place(i, j))];
  }

 private:
  int n_ = 0;
  std::array<Point4, num_places> points_;
};

}  // namespace limes
