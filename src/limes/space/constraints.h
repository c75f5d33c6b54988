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

  [[nodiscard]] int num_free() const { return static_cast<int>(T.cols()); }
};

/// Eliminates one degree of freedom per independent constraint, always the one with the largest
/// weight. Constraints that follow from earlier ones are recognised and left out.
/// @param tolerance  relative to a row's largest weight: what is smaller after substitution is 0
[[nodiscard]] Elimination eliminate(int num_dofs, const std::vector<ConstraintRow>& rows,
                                    double tolerance = 1e-6);

}  // namespace limes
