#pragma once

#include <utility>
#include <vector>

#include "limes/core/types.h"

namespace limes {

/// Homogeneous linear conditions on degrees of freedom, row by row: sum of weight * u[dof] = 0.
using ConstraintRow = std::vector<std::pair<int, double>>;

/// The vectors that fulfil a set of constraints: u = T free, columns of T independent.
struct Elimination {
  SparseMatrix T;  ///< (num_dofs, num_free)
  /// Number of each unconstrained dof among the free ones, -1 for those the constraints determine.
  std::vector<int> free_number;

  std::vector<int> dof_of_free;  ///< the other way around

  [[nodiscard]] int num_free() const { return static_cast<int>(T.cols()); }
  [[nodiscard]] int unknown(int free) const { return dof_of_free[static_cast<std::size_t>(free)]; }
};

/// Eliminates one degree of freedom per independent constraint, by frontal QR with column pivoting
/// along rows that share dofs; rows that follow from others are recognised and left out. Vectors that
/// fulfil all rows are in the range of T to rounding. The factors of T are 1 or not much larger.
/// @param rows   of any scale; a dof may occur twice in a row, its weights add up
/// @param block  number of dofs that enter at once: a matter of speed
[[nodiscard]] Elimination eliminate(int num_dofs, const std::vector<ConstraintRow>& rows,
                                    int block = 100);

}  // namespace limes
