#include "limes/solve/linear.h"

#include <Eigen/SparseCholesky>
#ifdef LIMES_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cmath>

#include "limes/core/error.h"

// Threads inside BLAS change the order of sums, and with it the last bits: one thread there.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace limes {
namespace {

using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
#ifdef LIMES_WITH_CHOLMOD
using Method = Eigen::CholmodSupernodalLLT<Columns, Eigen::Lower>;
#else
using Method = Eigen::SimplicialLDLT<Columns, Eigen::Lower>;
#endif

}  // namespace

struct DirectSolver::Factor {
  Columns K;
  Method method;
};

DirectSolver::DirectSolver(const SparseMatrix& K) : factor_(std::make_unique<Factor>()) {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  factor_->K = K;
#ifdef LIMES_WITH_CHOLMOD
  factor_->method.cholmod().print = 0;  // failures are reported by info(), not on the terminal
#endif
  factor_->method.compute(factor_->K);
  if (factor_->method.info() != Eigen::Success)
    throw SolverError("the stiffness matrix ({} unknowns) is not positive definite", K.rows());
#ifndef LIMES_WITH_CHOLMOD
  const auto d = factor_->method.vectorD();
  if (d.size() > 0 && !(d.minCoeff() > 1e-14 * d.maxCoeff()))
    throw SolverError("the stiffness matrix ({} unknowns) is not positive definite", K.rows());
#endif
}

DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;
DirectSolver::~DirectSolver() = default;

MatrixX DirectSolver::solve(const MatrixX& f) const {
  MatrixX x = factor_->method.solve(f);
  const MatrixX r = f - factor_->K * x;
  x += factor_->method.solve(r);
  if (!x.allFinite()) throw SolverError("the solution is not finite");
  return x;
}

double DirectSolver::relative_residual(const MatrixX& x, const MatrixX& f) const {
  double largest = 0;
  for (Eigen::Index k = 0; k < f.cols(); ++k) {
    const double scale = f.col(k).norm();
    const double r = (f.col(k) - factor_->K * x.col(k)).norm();
    largest = std::max(largest, scale > 0 ? r / scale : r);
  }
  return largest;
}

std::string_view DirectSolver::name() {
#ifdef LIMES_WITH_CHOLMOD
  return "CHOLMOD supernodal LLT";
#else
  return "Eigen simplicial LDLT";
#endif
}

}  // namespace limes
