#include "limes/space/constraints.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <random>

#include "convergence/plane_meshes.h"
#include "limes/space/boundary_trace.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

/// m x n unit squares, each cut into two triangles; inner vertices moved.
Mesh triangles(int m, int n) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-0.1, 0.1);
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i) {
      const bool inside = 0 < i && i < m && 0 < j && j < n;
      const double dx = move(random), dy = move(random);
      mesh.points.push_back(inside ? Vec3(i + dx, j + dy, 0) : Vec3(i, j, 0));
    }
  const auto vertex = [&](int i, int j) { return VertexId(j * (m + 1) + i); };
  std::vector<VertexId> corners;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i)
      corners.insert(corners.end(), {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                     vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  mesh.topology = Topology((m + 1) * (n + 1), 3, std::move(corners));
  return mesh;
}

/// Regions are squares of the given side, alternately of two materials. All borders run through
/// vertices of valence 6, and beside each there is one of valence 3.
SubdivisionSpace irregular_borders(int m, int n, int side) {
  const Scheme& scheme = find_scheme("catmull-clark");
  const BoundaryRule boundary = BoundaryRule::edges_and_corners;
  std::vector<int> regions;
  for (int f = 0; f < 2 * m * n; ++f)  // three quads each
    regions.insert(regions.end(), 3, ((f / 2) % m / side + f / 2 / m / side) % 2);
  return {refine(triangles(m, n), scheme, {.levels = 1, .boundary = boundary}), scheme, boundary,
          regions, SpaceOptions()};
}

VectorX random_vector(Eigen::Index size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  VectorX out(size);
  for (double& x : out)
    x = value(random);
  return out;
}

MatrixX dense(int num_dofs, const std::vector<ConstraintRow>& rows) {
  MatrixX M = MatrixX::Zero(Eigen::Index(rows.size()), num_dofs);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [dof, weight] : rows[i])
      M(Eigen::Index(i), dof) += weight;
  return M;
}

double value(const ConstraintRow& row, const VectorX& u) {
  double sum = 0;
  for (const auto& [dof, weight] : row)
    sum += weight * u(dof);
  return sum;
}

double largest_weight(const Elimination& e) {
  double largest = 0;
  for (Eigen::Index i = 0; i < e.T.nonZeros(); ++i)
    largest = std::max(largest, std::abs(e.T.valuePtr()[i]));
  return largest;
}

/// Difference of a field and what T makes of its free values.
double not_reproduced(const Elimination& e, const MatrixX& field) {
  MatrixX free(e.num_free(), field.cols());
  for (int i = 0; i < e.num_free(); ++i)
    free.row(i) = field.row(e.unknown(i));
  return (e.T * free - field).cwiseAbs().maxCoeff();
}

void expect_fulfilled(const std::vector<ConstraintRow>& rows, const Elimination& e, double bound) {
  const VectorX u = e.T * random_vector(e.num_free());
  for (const ConstraintRow& row : rows)
    EXPECT_NEAR(value(row, u), 0, bound * u.cwiseAbs().maxCoeff());
}

TEST(Eliminate, CountsConditions) {
  // 40 independent rows among 400 on 300 dofs: combinations of three neighbours in a chain
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0.5, 1);
  std::vector<ConstraintRow> basis, rows;
  for (int i = 0; i < 40; ++i) {
    basis.emplace_back();
    for (int k = 0; k < 10; ++k)
      basis.back().emplace_back(7 * i + k, number(random));
  }
  for (int i = 0; i < 400; ++i) {
    rows.emplace_back();
    for (int k = 0; k < 3; ++k)
      for (const auto& [dof, weight] : basis[std::size_t((7 * i + k) % 40)])
        rows.back().emplace_back(dof, (1 + i % 5) * weight * (k == 1 ? -1.5 : 1));
  }
  for (const int block : {1, 10, 100, 1000}) {
    const Elimination e = eliminate(300, rows, block);
    EXPECT_EQ(e.num_free(), 260) << block;
    expect_fulfilled(basis, e, 1e-12);
    for (int i = 0; i < e.num_free(); ++i)
      EXPECT_EQ(e.free_number[std::size_t(e.unknown(i))], i);
  }
}

TEST(Eliminate, RowsThatSayNothing) {
  EXPECT_EQ(eliminate(3, {}).num_free(), 3);
  EXPECT_EQ(eliminate(3, {{}, {{1, 0.0}}, {{2, 1.0}, {2, -1.0}}}).num_free(), 3);
  EXPECT_EQ(eliminate(3, {{{2, 1e-9}}, {}, {{2, 1.0}}}).num_free(), 2);
  EXPECT_EQ(eliminate(2, {{{0, 1.0}, {1, 1.0}}, {{0, 1.0}, {1, -1.0}}}).num_free(), 0);
}

TEST(Eliminate, DeterminesTheLargestWeight) {
  const Elimination e = eliminate(4, {{{0, 1e-5}, {1, 2.0}}, {{1, 1.0}, {2, 1e-5}, {3, 1.0}}});
  EXPECT_LE(largest_weight(e), 1.0);
  EXPECT_EQ(e.num_free(), 2);
}

// However many rows are treated at once, there are as many conditions as singular values.
TEST(Eliminate, FindsTheRankAtAnyBlock) {
  const SubdivisionSpace space = irregular_borders(6, 6, 2);
  const std::vector<ConstraintRow> rows = continuity(space);
  const Eigen::BDCSVD<MatrixX> svd(dense(space.num_dofs(), rows));
  const auto rank = (svd.singularValues().array() > 1e-5).count();
  const auto far_from_rank =
      (svd.singularValues().array() > 1e-7).count() - (svd.singularValues().array() > 1e-3).count();
  EXPECT_EQ(far_from_rank, 0);
  for (const int block : {1, 20, 100, 100'000}) {
    const Elimination e = eliminate(space.num_dofs(), rows, block);
    EXPECT_EQ(space.num_dofs() - e.num_free(), rank) << block;
    EXPECT_LE(largest_weight(e), 2) << block;
    EXPECT_LT(not_reproduced(e, space.position_coefficients()), 1e-13) << block;
    expect_fulfilled(rows, e, 1e-9);
    const MatrixX TT = MatrixX(e.T.transpose() * e.T);
    const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(TT, Eigen::EigenvaluesOnly);
    EXPECT_LT(eigen.eigenvalues().maxCoeff(), 50 * eigen.eigenvalues().minCoeff()) << block;
  }
}

// One border, more than 5,000 unknowns that hang together.
TEST(Eliminate, LongBorderKeepsAffineFields) {
  const int length = 300;
  const SubdivisionSpace space = irregular_borders(4, length, 2);
  const std::vector<ConstraintRow> rows = continuity(space);
  const Elimination e = eliminate(space.num_dofs(), rows);
  const MatrixX x = space.position_coefficients() / length;
  EXPECT_LT(not_reproduced(e, x), 1e-13);
  EXPECT_LE(largest_weight(e), 2);
  expect_fulfilled(rows, e, 1e-9);

  // The number of conditions grows with the border: what one square more adds is the same everywhere.
  std::vector<int> conditions;
  for (const int n : {10, 20, 30}) {
    const SubdivisionSpace shorter = irregular_borders(4, n, 2);
    const Elimination s = eliminate(shorter.num_dofs(), continuity(shorter), 100'000);
    conditions.push_back(shorter.num_dofs() - s.num_free());
  }
  const int step = conditions[1] - conditions[0];
  EXPECT_EQ(conditions[2] - conditions[1], step);
  EXPECT_EQ(space.num_dofs() - e.num_free(), conditions[0] + (length - 10) / 10 * step);
}

// Values held in a whole area: the front is as wide as the area.
TEST(Eliminate, Areas) {
  const int n = 60;
  const Mesh mesh = testing::grid(n, n, [](const Vec2& p) { return p; });
  const SubdivisionSpace space(mesh, find_scheme("catmull-clark"), BoundaryRule::edges_and_corners,
                               {}, SpaceOptions());
  std::vector<ConstraintRow> rows;
  for (int v = 0; v < mesh.topology.num_vertices(); ++v)
    if (v % (n + 1) < n / 2) rows.push_back(value_at_vertex(space, VertexId(v)));
  const Elimination e = eliminate(space.num_dofs(), rows);
  EXPECT_EQ(space.num_dofs() - e.num_free(), int(rows.size()));
  EXPECT_LE(largest_weight(e), 1.001);
  expect_fulfilled(rows, e, 1e-13);
}

TEST(Eliminate, SameBytesAgain) {
  const SubdivisionSpace space = irregular_borders(4, 40, 2);
  const std::vector<ConstraintRow> rows = continuity(space);
  const Elimination a = eliminate(space.num_dofs(), rows);
  const Elimination b = eliminate(space.num_dofs(), rows);
  ASSERT_EQ(a.T.nonZeros(), b.T.nonZeros());
  EXPECT_TRUE(std::equal(a.T.valuePtr(), a.T.valuePtr() + a.T.nonZeros(), b.T.valuePtr()));
  EXPECT_EQ(a.dof_of_free, b.dof_of_free);
}

}  // namespace
}  // namespace limes
