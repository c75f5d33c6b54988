#include <fmt/format.h>
#include <gtest/gtest.h>

#include "convergence/cells.h"
#include "limes/study/plane_solution.h"

namespace limes {
namespace {

/// Published values for E = 1, nu = 0.3, computed with an independent finite-element program on
/// curved elements of degree 5 (see data/SOURCES.md).
struct Published {
  friend void PrintTo(const Published& p, std::ostream* out) { *out << p.name; }
  const char* name;
  bool disc;
  double contrast;
  ModelKind kind;
  double C1111, C1122, C1212;
  double tolerance = 5e-6;  ///< five digits
};

Problem cell_problem(const Published& p) {
  Problem problem;
  problem.file = "cell.toml";
  problem.mesh.file = "cell.obj";
  problem.materials.push_back({.where = {}, .young = 1, .poisson = .3, .thickness = 1});
  if (p.disc)
    problem.materials.push_back(
        {.where = "group:disc", .young = p.contrast, .poisson = .3, .thickness = 1});
  problem.model.kind = p.kind;
  problem.periodic = PeriodicSettings{};
  problem.periodic->gradient << 1, .05, .05, 1;
  return problem;
}

class Homogenisation : public ::testing::TestWithParam<Published> {};

TEST_P(Homogenisation, ConvergesToThePublishedStiffness) {
  const Published& p = GetParam();
  double error = 0;
  int unknowns = 0;
  for (const int n : {32, 64, 128}) {
    const int layers = n / 4;
    const PlaneModel model =
        build_model(cell_problem(p), testing::CircleCell(n, layers, p.disc).mesh());
    const PlaneSolution s = solve_periodic(model);
    const Mat3& C = s.homogenised->stiffness;
    unknowns = s.num_unknowns;
    error = std::max({std::abs(C(0, 0) / p.C1111 - 1), std::abs(C(0, 1) / p.C1122 - 1),
                      std::abs(C(2, 2) / p.C1212 - 1)});
    fmt::print(
        "{:22s} n {:3d} {:6d} unknowns  C1111 {:.8f} C1122 {:.8f} C1212 {:.8f}  error {:.1e}\n",
        p.name, n, unknowns, C(0, 0), C(0, 1), C(2, 2), error);
    EXPECT_NEAR(C(1, 1), C(0, 0), 1e-9);
    EXPECT_NEAR(C(0, 2), 0, 1e-9);
    EXPECT_NEAR(s.homogenised->stress.dot(s.homogenised->strain) / 2, s.strain_energy, 1e-12);
  }
  EXPECT_LT(unknowns, 20000);
  EXPECT_LT(error, p.tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    Cells, Homogenisation,
    ::testing::Values(Published{"hole_strain", false, 0, ModelKind::plane_strain, .76988846,
                                .26622568, .19467437},
                      Published{"hole_stress", false, 0, ModelKind::plane_stress, .66397800,
                                .17694471, .18560887},
                      Published{"stiff_strain", true, 10, ModelKind::plane_strain, 1.76111459,
                                .71317944, .49052188},
                      Published{"stiff_stress", true, 10, ModelKind::plane_stress, 1.45157465,
                                .41987922, .48789618},
                      Published{"soft_strain", true, .1, ModelKind::plane_strain, .88342288,
                                .33634594, .23617122},
                      Published{"soft_stress", true, .1, ModelKind::plane_stress, .74375102,
                                .20819419, .23069025}),
    [](const auto& i) { return i.param.name; });

}  // namespace
}  // namespace limes
