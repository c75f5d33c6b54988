#pragma once

#include <vector>

#include "limes/core/types.h"

namespace bench {

/// The eigenvectors of a real square matrix with real eigenvalues, or why there are too few.
struct Eigenbasis {
  /// An eigenvalue with fewer eigenvectors than its multiplicity: a Jordan block.
  struct Defect {
    double eigenvalue;
    int multiplicity;
    int num_vectors;
  };
  limes::VectorX values;  ///< descending; equal ones side by side
  limes::MatrixX right;   ///< a column per eigenvalue; fewer if there are defects
  limes::MatrixX left;    ///< inverse of right; empty if there are defects
  std::vector<Defect> defects;
};

/// Eigenvalues closer than 1e-4 count as one, which an eigenvalue of a Jordan block, computed
/// numerically, falls into: the mean of such a group is exact to rounding where its members are
/// not. The eigenvectors of a group are the kernel of A - lambda 1, by singular values.
/// @throws limes::InputError for eigenvalues that are not real
[[nodiscard]] Eigenbasis eigenbasis(const limes::MatrixX& A);

}  // namespace bench
