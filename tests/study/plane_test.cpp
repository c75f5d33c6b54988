#include <gtest/gtest.h>

#include <array>

#include "convergence/cells.h"
#include "limes/core/error.h"
#include "limes/study/checks.h"
#include "limes/study/probes.h"
#include "study/tension.h"

namespace limes {
namespace {

Problem problem_of(const std::string& text) {
  return parse_problem("[mesh]\nfile = \"m.obj\"\n" + text, "p.toml");
}

struct Solved {
  PlaneModel model;
  PlaneSolution solution;
  std::vector<ProbeResult> probes;
};
Solved solve(const std::string& text, Mesh mesh) {
  Solved s{build_model(problem_of(text), std::move(mesh)), {}, {}};
  s.solution = solve_plane(s.model);
  s.probes = probe(s.model, s.solution);
  for (const SolutionCheck& c : check_solution(s.model, s.solution))
    EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  return s;
}

std::string message_of(const std::string& text, Mesh mesh) {
  try {
    (void)solve_plane(build_model(problem_of(text), std::move(mesh)));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string steel = "[material]\nyoung = 3.0\npoisson = 0.25\nthickness = 0.5\n";
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

/// An annulus between radius 1 and 2 whose circles are cubic B-splines.
Mesh ring(int n, int layers) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  const double stretch = 3 / (2 + std::cos(2 * std::numbers::pi / n));
  for (int k = 0; k <= layers; ++k)
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      const double r = stretch * (1 + double(k) / layers);
      x.emplace_back(r * std::cos(a), r * std::sin(a), 0);
    }
  for (int k = 0; k < layers; ++k)
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      quads.insert(quads.end(), {k * n + i, (k + 1) * n + i, (k + 1) * n + j, k * n + j});
    }
  return testing::make_mesh(std::move(x), std::move(quads));
}

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
    return solve(with, ring(48, 16));
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

// Two corners of a square under its own weight: each carries half, by symmetry, though the functions
// of the two overlap.
TEST(Reactions, AreSharedFairlyByNeighbours) {
  const std::string text = steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "vertex:0"
fix = ["ux", "uy"]
[[support]]
where = "vertex:1"
fix = ["uy"]
[[load]]
where = "all"
force_per_area = [0, -1]
)";
  const Solved s = solve(text, testing::grid(1, 1, [](const Vec2& p) { return p; }));
  EXPECT_NEAR(s.solution.reactions[0].force(1), 0.5, 1e-10);
  EXPECT_NEAR(s.solution.reactions[1].force(1), 0.5, 1e-10);
}

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

// Hole faces are no part of the domain: what remains is a narrower strip with sides of its own.
TEST(Holes, BoundTheDomain) {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return p; });
  for (const int f : {12, 13, 14, 15})
    mesh.tags.holes.emplace_back(f);
  std::string text = steel + tension;
  text.replace(text.find("at = [1, 1, 0]"), 14, "at = [1, 0.75, 0]");
  const Solved s = solve(text, mesh);
  EXPECT_NEAR(s.probes[0].state.u.x(), 0.4, 1e-10);
  EXPECT_NEAR(s.probes[0].state.u.y(), -0.75 * 0.1, 1e-10);
  EXPECT_NEAR(s.solution.reactions[0].force(0), -0.6 * 0.75, 1e-10);
  // The border of the hole carries loads: pushing on it is a compression across the strip.
  const std::string push = steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "y == 0"
fix = ["uy"]
[[support]]
where = "vertex:0"
fix = ["ux"]
[[load]]
where = "y == 0.75"
pressure = 1.5
[[probe]]
name = "top"
at = [1, 0.75, 0]
)";
  const PlaneState top = solve(push, mesh).probes[0].state;
  EXPECT_NEAR(top.stress(1), -1.5, 1e-9);
  EXPECT_NEAR(top.u.y(), -1.5 / 3.0 * 0.75, 1e-10);
}

TEST(Probes, FindPointsNextToAnExtraordinaryVertex) {
  Mesh mesh = testing::regular_polygon(5);
  std::string text = steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "all"
fix = ["ux", "uy"]
)";
  for (const char* at : {"[0.05, 0.05]", "[0.03, 0.01]", "[-0.2, 0.001]", "[0, 0]"})
    text += std::string("[[probe]]\nname = \"") + at + "\"\nat = " + at + "\n";
  for (const ProbeResult& p : solve(text, mesh).probes)
    EXPECT_LT(p.distance, 1e-9) << p.name;
}

TEST(RigidMotion, IsNamed) {
  const Mesh mesh = testing::grid(2, 2, [](const Vec2& p) { return p; });
  const std::string model = steel + "[model]\nkind = \"plane-stress\"\n";
  EXPECT_NE(message_of(model + "[[support]]\nwhere = \"x == 0\"\nfix = [\"ux\"]\n", mesh)
                .find("p.toml: the model can still move along y"),
            std::string::npos);
  EXPECT_NE(message_of(model + "[[support]]\nwhere = \"x == 0\"\nfix = [\"uy\"]\n", mesh)
                .find("move along x"),
            std::string::npos);
  EXPECT_NE(message_of(model + "[[support]]\nwhere = \"vertex:8\"\nfix = [\"ux\", \"uy\"]\n", mesh)
                .find("turn about (1, 1)"),
            std::string::npos);
}

// Two squares that touch in the middle of a grid, where holes are cut off by creases: nothing but one
// value is common to both.
TEST(RigidMotion, NamesTheHinge) {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return p; });
  for (const int f : {2, 3, 6, 7, 8, 9, 12, 13})
    mesh.tags.holes.emplace_back(f);
  for (int i = 0; i < 4; ++i)
    for (const auto& [a, b] : {std::pair(10 + i, 11 + i), std::pair(2 + 5 * i, 7 + 5 * i)})
      mesh.tags.creases.push_back({VertexId(a), VertexId(b), infinite_sharpness});
  const std::string text = steel + "[model]\nkind = \"plane-stress\"\n[[support]]\n";
  const std::string hinge = "p.toml: the model can still turn about (0.5, 0.5), vertex 12, ";
  const std::string held = text + "where = \"x == 0\"\nfix = [\"ux\", \"uy\"]\n";
  EXPECT_EQ(message_of(held, mesh).substr(0, hinge.size()), hinge);
  const std::string second = "[[support]]\nwhere = \"vertex:24\"\nfix = [\"uy\"]\n";
  EXPECT_EQ(message_of(held + second, mesh), "no error");
  // Without creases the functions reach across: value and slope are common, and there is no hinge.
  mesh.tags.creases.clear();
  EXPECT_EQ(message_of(held, mesh), "no error");
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

TEST(Messages, NameThePlace) {
  const Mesh mesh = testing::grid(2, 2, [](const Vec2& p) { return p; });
  std::string endless = steel + tension;
  endless.replace(endless.find("[0.6, 0]"), 8, "[\"1/(x-1)\", 0]");
  EXPECT_NE(message_of(endless, mesh).find("has no finite value at (1, "), std::string::npos);
  Mesh bent = mesh;
  bent.points[VertexId(4)].z() = 0.1;
  EXPECT_NE(message_of(steel + tension, bent).find("not plane"), std::string::npos);
  Mesh folded = mesh;
  folded.points[VertexId(4)] = Vec3(2.5, 2.5, 0);
  const std::string place = "m.obj: face 1: the surface is folded";
  for (const char* levels : {"", "levels = 2\n"})  // the face is that of the file
    EXPECT_EQ(message_of(levels + steel + tension, folded).substr(0, place.size()), place);
  const std::string periodic =
      steel + "[model]\nkind = \"plane-stress\"\n[periodic]\ngradient = [[1, 0.1], [0.1, 1]]\n";
  Mesh shifted = testing::grid(3, 3, [](const Vec2& p) {
    return Vec2(p.x(), p.x() == 0 && p.y() > 0 && p.y() < 0.5 ? p.y() + .1 : p.y());
  });
  EXPECT_NE(message_of(periodic, shifted).find("has no partner on the right"), std::string::npos);
}

}  // namespace
}  // namespace limes
