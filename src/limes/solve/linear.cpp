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

constexpr double shift = 1e-12;       // relative to the diagonal
constexpr int most_refinements = 10;  // each gains some six digits where the shift is felt
constexpr double good_residual = 1e-14;
constexpr double worst_residual = 1e-8;

/// K with a slightly larger diagonal.
Columns shifted(const Columns& K) {
  Columns out = K;
  for (Eigen::Index i = 0; i < out.cols(); ++i)
    out.coeffRef(i, i) *= 1.0 + shift;
  return out;
}

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
  factor_->method.compute(shifted(factor_->K));
  if (factor_->method.info() != Eigen::Success)
    throw SolverError("the stiffness matrix ({} unknowns) is not positive semidefinite", K.rows());
}

DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;
DirectSolver::~DirectSolver() = default;

MatrixX DirectSolver::solve(const MatrixX& f) const {
  MatrixX x = factor_->method.solve(f);
  double residual = relative_residual(x, f);
  for (int step = 0; step < most_refinements && residual > good_residual; ++step) {
    const MatrixX refined = x + factor_->method.solve(f - factor_->K * x);
    const double next = relative_residual(refined, f);
    if (!(next < 0.5 * residual)) break;
    x = refined;
    residual = next;
  }
  if (!(residual <= worst_residual))
    throw SolverError("the linear system ({} unknowns) has no solution: relative residual {:.1e}",
                      f.rows(), residual);
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
