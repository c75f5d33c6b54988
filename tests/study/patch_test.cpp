#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "study/solved.h"
#include "study/tension.h"

namespace limes {
namespace {

const std::string tension = testing::tension("1", "0.6");

/// A unit square of quads with inner vertices moved; and with a face in a ring of four others, which
/// makes vertices of valence 5 and 3: the group "core".
Mesh moved_grid() {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return p; });
  for (const int v : {6, 7, 8, 11, 12, 13, 16, 17, 18})
    mesh.points[VertexId(v)] += Vec3(.05 * std::sin(3. * v), .05 * std::cos(5. * v), 0);
  return mesh;
}
Mesh inset_grid() {
  Mesh mesh = moved_grid();
  std::vector<Vec3> x = mesh.points.vector();
  std::vector<int> quads;
  for (int f = 0; f < 16; ++f) {
    const auto c = mesh.topology.face(FaceId(f));
    if (f != 5) {
      for (const VertexId v : c)
        quads.push_back(v.value);
      continue;
    }
    const int first = int(x.size());
    Vec3 centre = Vec3::Zero();
    for (const VertexId v : c)
      centre += x[std::size_t(v.value)] / 4;
    for (const VertexId v : c)
      x.push_back(centre + .5 * (x[std::size_t(v.value)] - centre));
    for (int k = 0; k < 4; ++k)
      quads.insert(quads.end(), {c[std::size_t(k)].value, c[std::size_t((k + 1) % 4)].value,
                                 first + (k + 1) % 4, first + k});
    quads.insert(quads.end(), {first, first + 1, first + 2, first + 3});
  }
  Mesh out = testing::make_mesh(std::move(x), std::move(quads));
  out.groups.push_back({"core", {FaceId(9)}});
  return out;
}

class PatchTest : public ::testing::TestWithParam<int> {};

// Uniform tension is one of the field's functions on every mesh, also across a border between two
// materials that happen to be equal, and with the standard boundary. The quadrature is deep, because
// the square that is left over around an extraordinary vertex is not integrated exactly.
TEST_P(PatchTest, UniformTensionIsExact) {
  const int variant = GetParam();
  const std::string boundary = variant % 2 == 0 ? "free" : "phantom";
  Mesh mesh = variant < 2 ? moved_grid() : inset_grid();
  std::string materials = steel;
  if (variant >= 4)
    materials =
        "[[material]]\nyoung = 3.0\npoisson = 0.25\nthickness = 0.5\n"
        "[[material]]\nwhere = \"group:core\"\nyoung = 3.0\npoisson = 0.25\nthickness = 0.5\n";
  std::string text = materials + tension;
  text.replace(text.find("[model]"), 7,
               "[model]\nquadrature_depth = 30\nboundary = \"" + boundary + "\"");
  const Solved s = solve(text, std::move(mesh));
  // sigma = 0.6 / thickness, u = sigma / E x, v = - nu sigma / E y
  const PlaneState& end = s.probes[0].state;
  EXPECT_NEAR(s.probes[0].distance, 0, 1e-14);
  EXPECT_NEAR(end.u.x(), 0.4, 1e-12);
  EXPECT_NEAR(end.u.y(), -0.1, 1e-12);
  for (int e = 0; e < int(s.model.space->elements().size()); ++e)
    for (const PlaneState& p :
         states(s.model, s.solution, e,
                s.model.space->table(s.model.space->elements()[std::size_t(e)].shape))) {
      EXPECT_NEAR(p.stress(0), 1.2, 1e-10);
      EXPECT_NEAR(p.stress(1), 0, 1e-10);
      EXPECT_NEAR(p.stress(2), 0, 1e-10);
    }
  EXPECT_NEAR(s.solution.strain_energy, 0.5 * 0.6 * 0.4, 1e-12);
  EXPECT_NEAR(s.solution.reactions[0].force(0), -0.6, 1e-12);
  EXPECT_NEAR(s.solution.reactions[1].force(1), 0, 1e-12);
}

std::string patch_name(const ::testing::TestParamInfo<int>& info) {
  constexpr std::array names{"moved_free",    "moved_phantom", "inset_free",
                             "inset_phantom", "border_free",   "border_phantom"};
  return names[std::size_t(info.param)];
}
INSTANTIATE_TEST_SUITE_P(Meshes, PatchTest, ::testing::Range(0, 6), patch_name);

// A bar under its own weight, nu = 0: u is quadratic along the bar, so it is in the space with free
// ghosts on a regular grid, and not with the standard boundary, where u'' = 0 at the ends.
TEST(Bar, UnderItsOwnWeightIsExactWithFreeGhosts) {
  const std::string text = R"(
[material]
young = 2.0
poisson = 0.0
[model]
kind = "plane-strain"
boundary = "BOUNDARY"
[[support]]
where = "x == 0"
fix = ["ux", "uy"]
[[load]]
where = "all"
force_per_volume = [3.0, 0]
[[probe]]
name = "middle"
at = [0.5, 0.5, 0]
)";
  const auto middle = [&](const std::string& boundary) {
    std::string with = text;
    with.replace(with.find("BOUNDARY"), 8, boundary);
    return solve(with, testing::grid(3, 2, [](const Vec2& p) { return p; })).probes[0].state.u.x();
  };
  const double exact = 3.0 / 2.0 * (0.5 - 0.125);  // q / E (x - x^2 / 2)
  EXPECT_NEAR(middle("free"), exact, 1e-12);
  EXPECT_GT(std::abs(middle("phantom") - exact), 1e-4);
}

// Moments are taken about the model's centre: about the origin rounding would be all there is of them.
TEST(Checks, HoldFarFromTheOrigin) {
  Mesh mesh = moved_grid();
  for (Vec3& x : mesh.points.span())
    x.x() += 1e8;
  const Solved s = solve(steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "x < 100000000.01"
fix = ["ux", "uy"]
[[load]]
where = "x > 100000000.99"
force_per_length = [0.6, 0.2]
)",
                         std::move(mesh));
  EXPECT_NEAR(s.solution.reactions[0].force(1), -0.2, 1e-9);
}

}  // namespace
}  // namespace limes
