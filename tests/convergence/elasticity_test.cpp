#include <gtest/gtest.h>

#include "convergence/manufactured.h"
#include "convergence/plane_meshes.h"
#include "limes/fem/load.h"
#include "limes/space/constraints.h"

namespace limes {
namespace {

using testing::RateTable;

// A displacement whose second normal derivative vanishes on no boundary, its strain and its body
// force; plane stress, E = 2, nu = 0.3. Loads are the strong form: body force and boundary traction.
struct Exact {
  Mat3 C = plane_elasticity_matrix({.young = 2, .poisson = 0.3}, PlaneAssumption::stress);

  static Vec2 u(const Vec3& x) {
    return {std::sin(1.3 * x.x() + .4) * std::cos(1.1 * x.y() - .3),
            std::exp(.5 * x.x()) * std::sin(1.7 * x.y() + .2)};
  }
  static Mat2 gradient(const Vec3& x) {
    const double s = 1.3 * x.x() + .4, t = 1.1 * x.y() - .3, r = 1.7 * x.y() + .2;
    const double e = std::exp(.5 * x.x());
    Mat2 g;
    g << 1.3 * std::cos(s) * std::cos(t), -1.1 * std::sin(s) * std::sin(t), .5 * e * std::sin(r),
        1.7 * e * std::cos(r);
    return g;
  }
  [[nodiscard]] Vec3 stress(const Vec3& x) const {
    const Mat2 g = gradient(x);
    return C * Vec3(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
  }
  [[nodiscard]] Vec2 body_force(const Vec3& x) const {  // - div sigma, from second derivatives
    const double s = 1.3 * x.x() + .4, t = 1.1 * x.y() - .3, r = 1.7 * x.y() + .2;
    const double e = std::exp(.5 * x.x());
    const double uxx = -1.69 * std::sin(s) * std::cos(t), uyy = -1.21 * std::sin(s) * std::cos(t);
    const double uxy = -1.43 * std::cos(s) * std::sin(t);
    const double vxx = .25 * e * std::sin(r), vyy = -2.89 * e * std::sin(r);
    const double vxy = .85 * e * std::cos(r);
    return {-(C(0, 0) * uxx + C(0, 1) * vxy + C(2, 2) * (uyy + vxy)),
            -(C(2, 2) * (uxy + vxx) + C(1, 0) * uxy + C(1, 1) * vyy)};
  }
  [[nodiscard]] Vec2 traction(const Vec3& x, const Vec2& n) const {
    const Vec3 s = stress(x);
    return {s(0) * n.x() + s(2) * n.y(), s(2) * n.x() + s(1) * n.y()};
  }
};

std::vector<HalfedgeId> boundary_of(const SubdivisionSpace& space) {
  const Adjacency& a = space.geometry().adjacency();
  std::vector<HalfedgeId> sides;
  for (int e = 0; e < a.num_edges(); ++e)
    if (a.is_boundary(EdgeId(e))) sides.push_back(a.halfedge(EdgeId(e)));
  return sides;
}

/// Solves the pure traction problem; the rigid motion is fixed at three unknowns and taken out of
/// the error by subtracting its best fit.
RateTable::Row solve(const SubdivisionSpace& space) {
  const Exact exact;
  const ElementStiffness C(space.elements().size(), exact.C);
  const SparseMatrix K = elasticity_matrix(space, C);
  VectorX f = body_load(space, std::vector<bool>(space.elements().size(), true),
                        [&](const Vec3& x) { return exact.body_force(x); });
  f += side_load(space, boundary_of(space),
                 [&](const Vec3& x, const Vec2& n) { return exact.traction(x, n); });
  const int last = 2 * (space.num_dofs() - 1);
  const Elimination fix = eliminate(2 * space.num_dofs(), {{{0, 1.0}}, {{1, 1.0}}, {{last, 1.0}}});
  const VectorX u =
      fix.T * DirectSolver(fix.T.transpose() * K * fix.T).solve(fix.T.transpose() * f);

  // Differences at all points, then the rigid motion that fits them best.
  std::vector<Vec3> x;
  std::vector<Vec2> d;
  std::vector<double> w;
  double H1 = 0;
  testing::for_each_element(
      space, [&](int e, const ElementTable& table, const ElementPoints& p, const VectorX& dA) {
        const auto ue = element_field(space, e, u);
        const auto strain = strains(p, ue);
        for (Eigen::Index i = 0; i < dA.size(); ++i) {
          const Vec3 at = p.x.row(i).transpose();
          const Mat2 g = Exact::gradient(at);
          const Vec3 de = strain.row(i).transpose() - Vec3(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
          H1 += dA(i) * de.squaredNorm();
          x.push_back(at);
          d.push_back((table.N.row(i) * ue).transpose() - Exact::u(at));
          w.push_back(dA(i));
        }
      });
  Mat3 M = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  const auto mode = [&](std::size_t i) {
    Eigen::Matrix<double, 2, 3> m;
    m << 1, 0, -x[i].y(), 0, 1, x[i].x();
    return m;
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    M += w[i] * mode(i).transpose() * mode(i);
    b += w[i] * mode(i).transpose() * d[i];
  }
  const Vec3 rigid = M.ldlt().solve(b);
  double L2 = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    L2 += w[i] * (d[i] - mode(i) * rigid).squaredNorm();
  return {2 * space.num_dofs(), std::sqrt(L2), std::sqrt(H1)};
}

RateTable rates(const Mesh& mesh, int first, int last, const SpaceOptions& options) {
  RateTable table;
  for (int level = first; level <= last; ++level)
    table.rows.push_back(solve(testing::space_on(mesh, level, options)));
  std::cout << table;
  return table;
}

Mesh curved_grid() {
  return testing::grid(2, 2, [](const Vec2& p) {
    return Vec2(p.x() + .1 * p.y() * p.y(), 1.2 * p.y() + .15 * p.x() * p.x());
  });
}

TEST(Elasticity, FreeGhostsReachFullOrder) {
  const RateTable t = rates(curved_grid(), 2, 5, {.ghosts = true, .quadrature = {}});
  EXPECT_NEAR(t.rate_L2(), 4.0, 0.1);
  EXPECT_NEAR(t.rate_H1(), 3.0, 0.1);
}

TEST(Elasticity, PhantomsCapTheOrder) {
  const RateTable t = rates(curved_grid(), 2, 5, {.ghosts = false, .quadrature = {}});
  EXPECT_NEAR(t.rate_L2(), 2.5, 0.1);
  EXPECT_NEAR(t.rate_H1(), 1.5, 0.1);
}

class ElasticityAtExtraordinaryVertex : public ::testing::TestWithParam<int> {};

TEST_P(ElasticityAtExtraordinaryVertex, HasTheRatesOfTheSubdominantEigenvalue) {
  const int n = GetParam();
  const double c = std::cos(2 * std::numbers::pi / n);
  const double r = -std::log2((c + 5 + std::sqrt((c + 9) * (c + 1))) / 16);
  const RateTable t = rates(testing::regular_polygon(n, Vec2(.13, .07)), 4, 6,
                            {.ghosts = true, .quadrature = {.points = 3, .depth = 10}});
  const double tolerance = n == 3 ? 0.15 : 0.1;
  EXPECT_NEAR(t.rate_L2(), std::min(4.0, 3 * r), tolerance);
  EXPECT_NEAR(t.rate_H1(), std::min(3.0, 2 * r), tolerance);
}

INSTANTIATE_TEST_SUITE_P(Valence, ElasticityAtExtraordinaryVertex, ::testing::Values(3, 5, 6, 8),
                         [](const auto& i) { return "n" + std::to_string(i.param); });

}  // namespace
}  // namespace limes
