#include <gtest/gtest.h>

#include "convergence/manufactured.h"
#include "convergence/plane_meshes.h"

namespace limes {
namespace {

using testing::RateTable;

// u = sin(2.1 x + .4) cos(1.7 y - .3): its Hessian vanishes at no extraordinary vertex and its second
// normal derivative on no boundary.
double u(const Vec2& x) {
  return std::sin(2.1 * x.x() + .4) * std::cos(1.7 * x.y() - .3);
}
Vec2 grad_u(const Vec2& x) {
  return {2.1 * std::cos(2.1 * x.x() + .4) * std::cos(1.7 * x.y() - .3),
          -1.7 * std::sin(2.1 * x.x() + .4) * std::sin(1.7 * x.y() - .3)};
}

/// H1 projection of u onto the space, and its errors.
RateTable::Row project(const SubdivisionSpace& space) {
  VectorX f = assemble_vector(space, 1, [&](int e, VectorX& fe) {
    const ElementTable& table = space.table(space.elements()[std::size_t(e)].shape);
    ElementPoints p;
    to_physical(table, space.control_points(e), p);
    fe = VectorX::Zero(table.N.cols());
    for (Eigen::Index i = 0; i < p.x.rows(); ++i) {
      const Vec2 x = p.x.row(i).head<2>().transpose();
      const double dA = std::abs(p.J(i)) * table.weight(i);
      fe += dA * (u(x) * table.N.row(i) + grad_u(x).x() * p.Nx.row(i) + grad_u(x).y() * p.Ny.row(i))
                     .transpose();
    }
  });
  const VectorX c = DirectSolver(laplace_matrix(space, 1.0)).solve(f);
  double L2 = 0, H1 = 0;
  testing::for_each_element(
      space, [&](int e, const ElementTable& table, const ElementPoints& p, const VectorX& dA) {
        const auto dofs = space.dofs(e);
        VectorX ce(static_cast<Eigen::Index>(dofs.size()));
        for (std::size_t a = 0; a < dofs.size(); ++a)
          ce(Eigen::Index(a)) = c(dofs[a]);
        for (Eigen::Index i = 0; i < dA.size(); ++i) {
          const Vec2 x = p.x.row(i).head<2>().transpose();
          const double d = table.N.row(i).dot(ce) - u(x);
          const Vec2 g(p.Nx.row(i).dot(ce) - grad_u(x).x(), p.Ny.row(i).dot(ce) - grad_u(x).y());
          L2 += dA(i) * d * d;
          H1 += dA(i) * g.squaredNorm();
        }
      });
  return {space.num_dofs(), std::sqrt(L2), std::sqrt(H1)};
}

RateTable rates(const Mesh& mesh, int first, int last, const SpaceOptions& options) {
  RateTable table;
  for (int level = first; level <= last; ++level)
    table.rows.push_back(project(testing::space_on(mesh, level, options)));
  return table;
}

/// Rates of uniform refinement with an extraordinary vertex of valence n: 3 r and 2 r with
/// r = log2(1 / lambda), lambda the subdominant eigenvalue, at most 4 and 3; a regular vertex has
/// those of cubic splines.
struct Expected {
  double L2, H1;
};
Expected expected_rates(int n) {
  if (n == 4) return {4.0, 3.0};
  const double c = std::cos(2 * std::numbers::pi / n);
  const double r = -std::log2((c + 5 + std::sqrt((c + 9) * (c + 1))) / 16);
  return {std::min(4.0, 3 * r), std::min(3.0, 2 * r)};
}

class ScalarProjection : public ::testing::TestWithParam<int> {};

TEST_P(ScalarProjection, HasTheRatesOfTheSubdominantEigenvalue) {
  const int n = GetParam();
  const RateTable t = rates(testing::regular_polygon(n), 4, 6,
                            {.ghosts = true, .quadrature = {.points = 3, .depth = 10}});
  std::cout << t;
  const Expected e = expected_rates(n);
  const double tolerance = n == 3 ? 0.15 : 0.1;
  EXPECT_NEAR(t.rate_L2(), e.L2, tolerance);
  EXPECT_NEAR(t.rate_H1(), e.H1, tolerance);
}

INSTANTIATE_TEST_SUITE_P(Valence, ScalarProjection, ::testing::Values(3, 4, 5, 6, 8),
                         [](const auto& i) { return "n" + std::to_string(i.param); });

TEST(Boundary, FreeGhostsReachFullOrder) {
  const RateTable t = rates(testing::regular_polygon(4), 3, 6, {.ghosts = true, .quadrature = {}});
  std::cout << t;
  EXPECT_NEAR(t.rate_L2(), 4.0, 0.1);
  EXPECT_NEAR(t.rate_H1(), 3.0, 0.1);
}

TEST(Boundary, PhantomsCapTheOrder) {
  const RateTable t = rates(testing::regular_polygon(4), 3, 6, {.ghosts = false, .quadrature = {}});
  std::cout << t;
  EXPECT_NEAR(t.rate_L2(), 2.5, 0.1);
  EXPECT_NEAR(t.rate_H1(), 1.5, 0.1);
}

}  // namespace
}  // namespace limes
