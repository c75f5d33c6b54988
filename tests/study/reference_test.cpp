#include <gtest/gtest.h>

#include "study/annulus.h"
#include "study/solved.h"

namespace limes {
namespace {

// Lame: inner pressure 1, E = 1, nu = 0.3 [timoshenko_goodier]: plane stress u(a) = 1.9666..,
// u(b) = 1.3333.., sigma_tt(a) = 5/3; plane strain u(a) = 1.90666.., u(b) = 1.213333..
TEST(Lame, ThickRingUnderInnerPressure) {
  const std::string text = R"(
[material]
young = 1.0
poisson = 0.3
[model]
kind = "KIND"
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "y == 0"
fix = ["uy"]
[[load]]
where = "x^2 + y^2 < 1.01"
pressure = 1.0
[[probe]]
name = "inner"
at = [1, 0, 0]
[[probe]]
name = "outer"
at = [2, 0, 0]
)";
  const auto run = [&](const std::string& kind) {
    std::string with = text;
    with.replace(with.find("KIND"), 4, kind);
    return solve(with, testing::annulus(48, 16));
  };
  const Solved stress = run("plane-stress");
  EXPECT_NEAR(stress.probes[0].state.u.x(), 1.966666667, 2e-6);
  EXPECT_NEAR(stress.probes[1].state.u.x(), 1.333333333, 2e-6);
  EXPECT_NEAR(stress.probes[0].state.stress(1), 5.0 / 3.0, 2e-4);
  EXPECT_NEAR(stress.probes[0].state.stress(0), -1.0, 2e-4);
  EXPECT_NEAR(stress.solution.strain_energy, 4 * 1.544616388, 2e-5);
  const Solved strain = run("plane-strain");
  EXPECT_NEAR(strain.probes[0].state.u.x(), 1.906666667, 2e-6);
  EXPECT_NEAR(strain.probes[1].state.u.x(), 1.213333333, 2e-6);
  EXPECT_NEAR(strain.solution.strain_energy, 4 * 1.497492498, 2e-5);
}

// Cook's membrane, E = 1, nu = 1/3, F = 1, plane stress; values of an independent finite-element
// program, degree 6, 41,720 unknowns. The corner at the top left is singular:
// the error of the energy falls with h^1.3 or so, whatever the degree.
TEST(Cook, MembraneConvergesToTheReference) {
  const std::string text = R"(
[material]
young = 1.0
poisson = 0.33333333333333333
[model]
kind = "plane-stress"
[[support]]
where = "x == 0"
fix = ["ux", "uy"]
[[load]]
where = "x == 48"
force_per_length = [0, 0.0625]
[[probe]]
name = "middle"
at = [48, 52, 0]
[[probe]]
name = "corner"
at = [48, 60, 0]
)";
  const Solved s = solve(text, testing::grid(96, 96, [](const Vec2& p) {
                           return Vec2(48 * p.x(), 44 * p.x() + p.y() * (44 - 28 * p.x()));
                         }));
  EXPECT_NEAR(s.probes[0].state.u.y(), 23.96774, 0.02);
  EXPECT_NEAR(s.probes[1].state.u.y(), 25.1893, 0.02);
  EXPECT_NEAR(s.solution.strain_energy, 12.02080, 0.01);
  EXPECT_NEAR(s.solution.reactions[0].force(1), -1.0, 1e-9);
}

}  // namespace
}  // namespace limes
