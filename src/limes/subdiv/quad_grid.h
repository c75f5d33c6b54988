#pragma once

#include <array>

#include "limes/subdiv/quad_kernel.h"

namespace limes {

/// The points of one control quad at one step of refinement, with a margin of one: the vertices of
/// the faces around it as if all were regular.
///
///      o   o   o   o   o
///        +---+---+---+          n = 3 cells a side; + vertices (i, j), 0 <= i, j <= n
///      o | · | · | · | o        o margin; · new face points, one per cell, margin cells included
///        +---+---+---+
///           . . .
///
/// Vertex (i, j) lies at (j + 1) stride + i + 1, the face point of the cell between (i, j) and
/// (i + 1, j + 1) at (j + 1) (n + 2) + i + 1; i and j start at -1.
class QuadGrid {
 public:
  static constexpr int max_cells = 1 << (QuadNumbering::max_depth - 1);

  void resize(int cells) { n_ = cells; }
  [[nodiscard]] int cells() const { return n_; }
  [[nodiscard]] int stride() const { return n_ + 3; }
  [[nodiscard]] int vertex_index(int i, int j) const { return (j + 1) * stride() + i + 1; }
  [[nodiscard]] int face_stride() const { return n_ + 2; }
  [[nodiscard]] int face_index(int i, int j) const { return (j + 1) * face_stride() + i + 1; }

  [[nodiscard]] const Point4* vertices() const { return vertices_.data(); }
  [[nodiscard]] Point4& vertex(int index) { return vertices_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const Point4& vertex(int index) const {
    return vertices_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const Point4* faces() const { return faces_.data(); }

  /// New face points of all cells.
  void make_face_points(const QuadKernel& kernel, const RegularMasks& m) {
    kernel.make_face_points(m, n_, vertices_.data(), faces_.data());
  }
  /// All points of the grid one step finer, margin included. Precondition: face points are made.
  void refine(const QuadKernel& kernel, const RegularMasks& m, QuadGrid& fine) const {
    fine.resize(2 * n_);
    kernel.refine(m, n_, vertices_.data(), faces_.data(), fine.vertices_.data());
  }

 private:
  int n_ = 0;
  std::array<Point4, (max_cells + 3) * (max_cells + 3)> vertices_;
  std::array<Point4, (max_cells + 2) * (max_cells + 2)> faces_;
};

}  // namespace limes
