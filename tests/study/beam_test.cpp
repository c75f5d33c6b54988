#include <gtest/gtest.h>

#include "study/solved.h"

namespace limes {
namespace {

// A cantilever 150 times as long as high, nu = 0: tip displacement 4 F L^3 / (E t h^3) (Euler), shear
// adds 1e-4 of it.
TEST(Beam, SlenderCantilever) {
  const std::string text = R"(
[material]
young = 1e6
poisson = 0.0
[model]
kind = "plane-stress"
[[support]]
where = "x == 0"
fix = ["ux", "uy"]
[[load]]
where = "x == 150"
force_per_length = [0, 1e-3]
[[probe]]
name = "tip"
at = [150, 0.5, 0]
)";
  const Solved s =
      solve(text, testing::grid(75, 1, [](const Vec2& p) { return Vec2(150 * p.x(), p.y()); }));
  EXPECT_NEAR(s.probes[0].state.u.y(), 4e-3 * 150 * 150 * 150 / 1e6, 3e-4 * 13.5);
}

/// Faces along the beam, refinements, and the relative error that is allowed.
struct Division {
  int faces, levels;
  double tolerance;
};
void PrintTo(const Division& d, std::ostream* out) {
  *out << d.faces << " faces, " << d.levels << " levels";
}

class VerySlenderBeam : public ::testing::TestWithParam<Division> {};

// 1000 times as long as high: the stiffness matrix has eigenvalues 1e13 apart and more. Rounding its
// entries alone changes the bending stiffness by parts of a thousand on the finest meshes (measured:
// 4e-3 there, with residuals in extended precision as well), which the tolerance allows for. Shear
// and discretisation are below 1e-4.
TEST_P(VerySlenderBeam, BendsAsEulerAndBernoulliSay) {
  const Division& d = GetParam();
  const std::string text = "levels = " + std::to_string(d.levels) + R"(
[material]
young = 12
poisson = 0
[model]
kind = "plane-stress"
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == 1000"
force_per_length = [0, -1e-9]
[[probe]]
name = "tip"
at = [1000, 0.5, 0]
)";
  const Solved s = solve(
      text, testing::grid(d.faces, 1, [](const Vec2& p) { return Vec2(1000 * p.x(), p.y()); }));
  const double expected = -1e-9 * 1e9 / 3;  // - F L^3 / (3 E I), E I = 1
  EXPECT_NEAR(s.probes[0].state.u.y(), expected, d.tolerance * std::abs(expected));
}

INSTANTIATE_TEST_SUITE_P(Divisions, VerySlenderBeam,
                         ::testing::Values(Division{25, 0, 5e-4}, Division{25, 2, 5e-3},
                                           Division{25, 3, 1e-2}, Division{100, 2, 5e-3},
                                           Division{100, 3, 1e-2}));

}  // namespace
}  // namespace limes
