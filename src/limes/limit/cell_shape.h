#pragma once

#include <vector>

#include "limes/core/types.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// The polynomial cells that a scheme's surface is cut into: bicubic on the unit square, or quartic
/// on the triangle u, v >= 0, u + v <= 1.
struct CellShape {
  int degree;
  std::vector<Vec2> nodes;  ///< of interpolation, sorted by v, then u
  MatrixX to_bernstein;     ///< Bernstein coefficients from values at the nodes, in the same order

  /// Where cells are compared with the surface: between the nodes, and close to the borders, where
  /// the polynomial near an extraordinary vertex is worst.
  std::vector<Vec2> samples;
  MatrixX sample_weights;  ///< of the nodes in the polynomial's value at each sample, one a row

  /// Number of node (i, j) / degree; i + j <= degree on a triangle.
  [[nodiscard]] int node(int i, int j) const {
    return triangle ? j * (2 * degree + 3 - j) / 2 + i : j * (degree + 1) + i;
  }
  [[nodiscard]] int num_nodes() const { return static_cast<int>(nodes.size()); }
  bool triangle;
};

[[nodiscard]] const CellShape& cell_shape(Split split);

}  // namespace limes
