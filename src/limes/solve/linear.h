#pragma once

#include <memory>
#include <string_view>

#include "limes/core/types.h"

namespace limes {

/// Cholesky factorisation of a sparse symmetric positive semidefinite matrix: CHOLMOD supernodal where
/// limes was built with it, Eigen's simplicial LDLT otherwise. Same input, same bits for any number
/// of threads.
///
/// Unknowns that no equation feels are harmless: the functions of a region next to a border can be
/// linearly dependent (at an extraordinary vertex of valence 3, see docs/theory/space.md). The factor
/// is that of K + 1e-12 diag(K); iterative refinement with K itself takes the shift out again. Where
/// K has eigenvalues below the shift, as for a beam 1000 times as long as high, refinement gains
/// little there; conjugate gradients with the factor as preconditioner then take a step for each of
/// these few.
class DirectSolver {
 public:
  /// @throws SolverError if the matrix is not positive semidefinite to rounding
  explicit DirectSolver(const SparseMatrix& K);
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) noexcept;
  ~DirectSolver();

  /// A solution of K x = f for one or several right-hand sides.
  /// @throws SolverError if there is none: the relative residual stays above 1e-8 and above
  ///         rounding_floor
  [[nodiscard]] MatrixX solve(const MatrixX& f) const;
  /// |K x - f| / |f|, the largest over the right-hand sides.
  [[nodiscard]] double relative_residual(const MatrixX& x, const MatrixX& f) const;
  /// What rounding the entries of x alone leaves of that: 4 eps |K| |x| / |f|, |K| the largest row sum;
  /// the largest over the right-hand sides. Large for slender models, whose forces nearly cancel.
  [[nodiscard]] double rounding_floor(const MatrixX& x, const MatrixX& f) const;

  /// Name of the method, for reports.
  [[nodiscard]] static std::string_view name();

 private:
  [[nodiscard]] MatrixX refined(const MatrixX& f) const;
  /// From x on, [hestenes_1952] eq. (3:1) with the factor as preconditioner, until the residual does not fall any more.
  [[nodiscard]] VectorX conjugate_gradients(const VectorX& f, VectorX x) const;

  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace limes
