#pragma once

#include <memory>
#include <string_view>

#include "limes/core/types.h"

namespace limes {

/// Cholesky factorisation of a sparse symmetric positive definite matrix: CHOLMOD supernodal where
/// limes was built with it, Eigen's simplicial LDLT otherwise. Same input, same bits for any number
/// of threads.
class DirectSolver {
 public:
  /// @throws SolverError if the matrix is not positive definite to rounding
  explicit DirectSolver(const SparseMatrix& K);
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) noexcept;
  ~DirectSolver();

  /// K x = f for one or several right-hand sides; one step of iterative refinement.
  [[nodiscard]] MatrixX solve(const MatrixX& f) const;
  /// |K x - f| / |f| of the last solve, the largest over the right-hand sides.
  [[nodiscard]] double relative_residual(const MatrixX& x, const MatrixX& f) const;

  /// Name of the method, for reports.
  [[nodiscard]] static std::string_view name();

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace limes
