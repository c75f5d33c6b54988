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
constexpr int most_gradients = 100;
constexpr int patience = 4;  // steps without a smaller residual; it need not fall in each
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

  /// Solves with the shifted matrix. @throws std::bad_alloc
  [[nodiscard]] MatrixX apply(const MatrixX& f) {
    MatrixX x = method.solve(f);
    check_memory();
    return x;
  }
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
  MatrixX x = refined(f);
  if (relative_residual(x, f) > worst_residual)
    for (Eigen::Index k = 0; k < f.cols(); ++k)
      x.col(k) = conjugate_gradients(f.col(k), x.col(k));
  const double residual = relative_residual(x, f);
  if (!std::isfinite(residual))
    throw SolverError(
        "the solution of the linear system ({} unknowns) is not finite; check the units", f.rows());
  if (!(residual <= std::max(worst_residual, rounding_floor(x, f))))
    throw SolverError("the linear system ({} unknowns) has no solution: relative residual {:.1e}",
                      f.rows(), residual);
  return x;
}

MatrixX DirectSolver::refined(const MatrixX& f) const {
  MatrixX x = factor_->apply(f);
  double residual = relative_residual(x, f);
  for (int step = 0; step < most_refinements && residual > good_residual; ++step) {
    MatrixX next = x + factor_->apply(f - factor_->K * x);
    const double next_residual = relative_residual(next, f);
    if (!(next_residual < residual)) break;
    x = std::move(next);
    residual = next_residual;
  }
  return x;
}

VectorX DirectSolver::conjugate_gradients(const VectorX& f, VectorX x) const {
  const Columns& K = factor_->K;
  VectorX best = x;
  VectorX r = f - K * x;
  VectorX z = factor_->apply(r);
  VectorX p = z;
  double least = r.norm();
  double rz = r.dot(z);
  for (int step = 0, idle = 0; step < most_gradients && idle < patience; ++step, ++idle) {
    const VectorX q = K * p;
    const double pq = p.dot(q);
    if (!(pq > 0 && rz > 0)) break;
    x += rz / pq * p;
    r = f - K * x;  // not by recurrence: near the rounding floor that would drift away from it
    z = factor_->apply(r);
    const double next = r.dot(z);
    p = z + next / rz * p;
    rz = next;
    if (r.norm() < least) {
      least = r.norm();
      best = x;
      idle = 0;
    }
  }
  return best;
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
