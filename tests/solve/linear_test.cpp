#include "limes/solve/linear.h"

#include <gtest/gtest.h>

#include "limes/core/error.h"

namespace limes {
namespace {

/// Second differences on n points; with free ends the matrix is singular: constants.
SparseMatrix chain(int n, bool held) {
  std::vector<Triplet> entries;
  for (int i = 0; i + 1 < n; ++i) {
    entries.insert(entries.end(),
                   {{i, i, 1.0}, {i + 1, i + 1, 1.0}, {i, i + 1, -1.0}, {i + 1, i, -1.0}});
  }
  if (held) entries.insert(entries.end(), {{0, 0, 1.0}, {n - 1, n - 1, 1.0}});
  SparseMatrix K(n, n);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

TEST(DirectSolver, SolvesAChain) {
  // -u'' = 1 between u_{-1} = u_n = 0: u_i = (i + 1) (n - i) / 2
  const int n = 200;
  const MatrixX u = DirectSolver(chain(n, true)).solve(VectorX::Ones(n));
  for (int i = 0; i < n; ++i)
    EXPECT_NEAR(u(i, 0), (i + 1.0) * (n - i) / 2, 1e-9);
}

TEST(DirectSolver, SolvesSeveralRightHandSides) {
  const int n = 50;
  const SparseMatrix K = chain(n, true);
  const MatrixX f = MatrixX::Random(n, 3);
  const DirectSolver solver(K);
  const MatrixX u = solver.solve(f);
  EXPECT_LT((K * u - f).norm(), 1e-11 * f.norm());
  EXPECT_LT(solver.relative_residual(u, f), 1e-12);
}

TEST(DirectSolver, TakesASingularMatrixIfThereIsASolution) {
  const int n = 60;
  VectorX f = VectorX::Zero(n);
  f(0) = 1;
  f(n - 1) = -1;
  const MatrixX u = DirectSolver(chain(n, false)).solve(f);
  for (int i = 0; i + 1 < n; ++i)
    EXPECT_NEAR(u(i, 0) - u(i + 1, 0), 1.0, 1e-9);
}

TEST(DirectSolver, SaysThatThereIsNone) {
  EXPECT_THROW((void)DirectSolver(chain(60, false)).solve(VectorX::Ones(60)), SolverError);
}

TEST(DirectSolver, RefusesAnIndefiniteMatrix) {
  SparseMatrix K = chain(10, true);
  K.coeffRef(3, 3) = -5;
  EXPECT_THROW(DirectSolver solver(K), SolverError);
}

}  // namespace
}  // namespace limes
