#include "limes/solve/linear.h"

#include <Eigen/SparseCholesky>
#ifdef LIMES_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cmath>
#include <limits>
#include <new>

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
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

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
  double norm = 0;  // largest sum of a row
  Method method;

  /// CHOLMOD does not tell Eigen when memory ran out.
  void check_memory() {
#ifdef LIMES_WITH_CHOLMOD
    if (method.cholmod().status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (method.cholmod().status == CHOLMOD_TOO_LARGE)
      throw SolverError("the factor of {} unknowns has too many entries", K.rows());
#endif
  }
};

DirectSolver::DirectSolver(const SparseMatrix& K) : factor_(std::make_unique<Factor>()) {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  factor_->K = K;
  if (K.rows() == 0) return;
  const VectorX row_sums = K.cwiseAbs() * VectorX::Ones(K.cols());
  factor_->norm = row_sums.maxCoeff();
  if (!std::isfinite(factor_->norm) || !row_sums.allFinite())
    throw SolverError("the stiffness matrix is not finite; check the units");
#ifdef LIMES_WITH_CHOLMOD
  factor_->method.cholmod().print = 0;  // failures are reported by info(), not on the terminal
#endif
  factor_->method.compute(shifted(factor_->K));
  factor_->check_memory();
  if (factor_->method.info() != Eigen::Success)
    throw SolverError("the stiffness matrix ({} unknowns) is not positive semidefinite", K.rows());
}

DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;
DirectSolver::~DirectSolver() = default;

MatrixX DirectSolver::solve(const MatrixX& f) const {
  if (f.rows() == 0) return f;
  MatrixX x = factor_->method.solve(f);
  factor_->check_memory();
  double residual = relative_residual(x, f);
  for (int step = 0; step < most_refinements && residual > good_residual; ++step) {
    const MatrixX refined = x + factor_->method.solve(f - factor_->K * x);
    const double next = relative_residual(refined, f);
    if (!(next < residual)) break;
    x = refined;
    residual = next;
  }
  if (!(residual <= std::max(worst_residual, rounding_floor(x, f))))
    throw SolverError("the linear system ({} unknowns) has no solution: relative residual {:.1e}",
                      f.rows(), residual);
  return x;
}

double DirectSolver::relative_residual(const MatrixX& x, const MatrixX& f) const {
  double largest = 0;
  for (Eigen::Index k = 0; k < f.cols(); ++k) {
    const double scale = f.col(k).norm();
    const double r = (f.col(k) - factor_->K * x.col(k)).norm();
    const double relative = scale > 0 ? r / scale : r;
    if (!std::isfinite(relative)) return relative;
    largest = std::max(largest, relative);
  }
  return largest;
}

double DirectSolver::rounding_floor(const MatrixX& x, const MatrixX& f) const {
  double largest = 0;
  for (Eigen::Index k = 0; k < f.cols(); ++k) {
    const double scale = f.col(k).norm();
    if (scale > 0) largest = std::max(largest, rounding * factor_->norm * x.col(k).norm() / scale);
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
