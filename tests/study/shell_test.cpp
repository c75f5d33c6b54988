// MITC4 shells against published values of the same element, and against limits of the theory.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <tuple>

#include "convergence/plane_meshes.h"
#include "limes/core/error.h"
#include "limes/study/run.h"

namespace limes {
namespace {

ShellResult solve_file(const std::string& name, std::vector<std::string> overrides = {}) {
  ShellResult result =
      run_shell_problem(read_problem(std::filesystem::path(LIMES_DATA_DIR) / name, overrides));
  for (const SolutionCheck& c : result.checks)
    EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  return result;
}

double deflection(const ShellResult& result) {
  return -result.probes.front().displacement.z();
}

// [ko_2017] tables 10 and 8: the regular 16 x 16 meshes.
TEST(Mitc4Published, ScordelisLoRoof) {
  EXPECT_NEAR(deflection(solve_file("roof.toml")), 0.9886 * 0.3024, 0.002 * 0.2990);
}

TEST(Mitc4Published, PinchedCylinder) {
  EXPECT_NEAR(deflection(solve_file("pinched_cylinder.toml")), 0.9286 * 1.8248e-5,
              0.002 * 1.6945e-5);
}

// Reissner-Mindlin limits of the quarter's energy, from spectral solutions, soft and hard ends kept apart.
// From below; edge layers as wide as the thickness keep the coarse meshes from the full order.
TEST(Mitc4Limit, RoofConvergesToItsOwnEnergy) {
  for (const auto& [rotation, limit, gap] :
       {std::tuple("soft", 1211.105963, 2e-3), std::tuple("hard", 1208.890028, 1e-3)}) {
    const std::string set = std::string("support.0.rotation=") + rotation;
    double before = 1;
    for (const char* level : {"3", "4", "5", "6"}) {
      const double error = 1 - solve_file("roof.toml", {set, std::string("mesh.levels=") + level})
                                       .solution.strain_energy /
                                   limit;
      EXPECT_GT(error, 0) << rotation << level;
      EXPECT_LT(error, before / 2) << rotation << level;
      before = error;
    }
    EXPECT_LT(before, gap) << rotation;
  }
}

// Kirchhoff-Love limit 0.0924131, computed with harmonics: thin, nearly inextensional bending.
TEST(Mitc4Limit, ClosedHemisphereDoesNotLock) {
  const auto error = [](const char* level) {
    const ShellResult r = solve_file("hemisphere.toml", {std::string("mesh.levels=") + level});
    return std::abs(r.probes.front().displacement.x() / 0.0924131 - 1);
  };
  EXPECT_LT(error("4"), 0.005);
  EXPECT_LT(error("5"), 0.001);
}

// Kirchhoff-Love limit 0.0935216; this theory 0.2 % above it, once elements are smaller than the thickness.
TEST(Mitc4Limit, HemisphereWithAHole) {
  const auto error = [](const char* level) {
    const ShellResult r = solve_file("hemisphere_hole.toml", {std::string("mesh.levels=") + level});
    return std::abs(r.probes.front().displacement.x() / 0.0935216 - 1);
  };
  EXPECT_LT(error("4"), 0.01);
  EXPECT_LT(error("5"), 0.003);
}

// Partly clamped, thickness over length 1/100, 1/1000, 1/10000: MITC16 of Bathe, Iosilevich, Chapelle 2000.
TEST(Mitc4Limit, HyparDoesNotLock) {
  for (const auto& [thickness, deflected] :
       {std::pair("0.01", 9.3355e-5), std::pair("0.001", 6.3941e-3),
        std::pair("0.0001", 0.52988)}) {
    const std::string set = std::string("material.thickness=") + thickness;
    EXPECT_NEAR(deflection(solve_file("hypar.toml", {set})) / deflected, 1, 0.05) << thickness;
    EXPECT_NEAR(deflection(solve_file("hypar.toml", {set, "mesh.levels=5"})) / deflected, 1, 0.02)
        << thickness;
  }
}

// A long tube of a Catmull-Clark surface under inner pressure widens by p R^2 / (E t), far from its ends.
TEST(ShellPlacement, LimitPointsAndNormalsOfCatmullClark) {
  const int n = 16, m = 8;
  const double pi = std::numbers::pi;
  const double R = 3 / (2 + std::cos(2 * pi / n));  // limit points of the control circle: radius 1
  std::vector<Vec3> x;
  std::vector<int> quads;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j < n; ++j)
      x.emplace_back(4.0 * i / m, R * std::cos(2 * pi * j / n), R * std::sin(2 * pi * j / n));
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const int k = (j + 1) % n;
      quads.insert(quads.end(), {i * n + j, i * n + k, (i + 1) * n + k, (i + 1) * n + j});
    }
  const ShellModel model = build_shell_model(parse_problem(R"([mesh]
file = "m.obj"
levels = 2
[model]
kind = "mitc4"
[material]
young = 1e6
poisson = 0.3
thickness = 0.05
[[support]]
where = "x == 0"
kind = "clamped"
[[load]]
where = "all"
pressure = -1
[[probe]]
name = "middle"
at = [2, 1, 0]
)",
                                                           "p.toml"),
                                             testing::make_mesh(std::move(x), std::move(quads)));
  for (const Vec3& p : model.mesh->points)
    EXPECT_NEAR(p.tail<2>().norm(), 1, 2e-4);
  for (int h = 0; h < model.mesh->topology.num_corners(); ++h) {
    const Vec3& p = model.mesh->points[model.mesh->topology.corner(HalfedgeId(h))];
    EXPECT_NEAR(model.director[HalfedgeId(h)].tail<2>().dot(p.tail<2>()), 1, 1e-3);
  }
  const ShellSolution solution = solve_shell(model);
  EXPECT_EQ(solution.num_kink_nodes, 0);
  EXPECT_NEAR(probe(model, solution).front().displacement.y(), 2e-5, 0.003 * 2e-5);
}

/// A quarter of a square plate of side 1, thickness 1/100, D = 1, under a unit pressure.
std::string plate(const std::string& support) {
  std::string text = R"([mesh]
file = "m.obj"
scheme = "linear"
[model]
kind = "mitc4"
[material]
young = 10.92e6
poisson = 0.3
thickness = 0.01
[[load]]
where = "all"
pressure = 1
[[support]]
where = "x == 0"
kind = "symmetry"
[[support]]
where = "y == 0"
kind = "symmetry"
[[probe]]
name = "centre"
at = [0, 0]
)";
  for (const char* edge : {"x == 0.5", "y == 0.5"})
    text += "[[support]]\nwhere = \"" + std::string(edge) + "\"\n" + support + "\n";
  return text;
}

/// Times D.
double plate_deflection(const std::string& support, double thickness = 0.01) {
  const Mesh mesh = testing::grid(16, 16, [](const Vec2& p) -> Vec2 { return p / 2; });
  const ShellModel model =
      build_shell_model(parse_problem(plate(support), "p.toml",
                                      std::vector{fmt::format("material.thickness={}", thickness)}),
                        mesh);
  const ShellSolution solution = solve_shell(model);
  return -probe(model, solution).front().displacement.z() * std::pow(thickness / 0.01, 3);
}

// [ko_2017]: 16 x 16 on the quarter, over 1.267e-3 and 4.062e-3 q L^4 / D.
TEST(Mitc4Published, SquarePlates) {
  for (const auto& [thickness, clamped, supported] :
       {std::tuple(1e-2, 0.9984, 1.0), std::tuple(1e-3, 0.9980, 0.9998),
        std::tuple(1e-4, 0.9979, 0.9998)}) {
    EXPECT_NEAR(plate_deflection("kind = \"clamped\"", thickness) / 1.267e-3, clamped, 0.002)
        << thickness;
    EXPECT_NEAR(plate_deflection("kind = \"supported\"\nrotation = \"hard\"", thickness) / 4.062e-3,
                supported, 0.002)
        << thickness;
  }
  // soft edges give way a little more
  EXPECT_GT(plate_deflection("kind = \"supported\""),
            plate_deflection("kind = \"supported\"\nrotation = \"hard\""));
}

// q cos(pi x) cos(pi y) on hard edges: w = q (1 + 2 pi^2 D / (k G t)) / (4 pi^4 D) in the centre, exactly.
TEST(Mitc4Limit, SinusoidalPlateWithOrderTwo) {
  const double pi = std::numbers::pi, D = 10.92e6 * 1e-6 / (12 * 0.91);
  const double shear = 5.0 / 6 * 10.92e6 / 2.6 * 0.01;
  const double exact = (1 + 2 * pi * pi * D / shear) / (4 * std::pow(pi, 4) * D);
  std::string text = plate("kind = \"supported\"\nrotation = \"hard\"");
  text.replace(text.find("pressure = 1"), 12, "pressure = \"cos(pi * x) * cos(pi * y)\"");
  const auto error = [&](int n) {
    const Mesh mesh = testing::grid(n, n, [](const Vec2& p) -> Vec2 { return p / 2; });
    const ShellModel model = build_shell_model(parse_problem(text, "p.toml"), mesh);
    return std::abs(-probe(model, solve_shell(model)).front().displacement.z() / exact - 1);
  };
  EXPECT_NEAR(std::log2(error(8) / error(16)), 2, 0.1);
  EXPECT_NEAR(std::log2(error(16) / error(32)), 2, 0.1);
}

/// An L-shaped strip: a wall 1 high on a floor 1 long, width b, kinked by a right angle.
Mesh angle_strip(int n) {
  Mesh mesh = testing::grid(2 * n, 2, [](const Vec2& p) { return Vec2(2 * p.x(), 0.2 * p.y()); });
  for (Vec3& x : mesh.points)
    if (x.x() > 1) x = Vec3(1, x.y(), x.x() - 1);
  return mesh;
}

// A right-angled cantilever frame with a force F along x at its tip: exact beam theory with nu = 0 gives
// the tip F / (E I) (h^3 / 3 + h^2 L) in x, and the moment goes through the kink.
TEST(ShellKink, CarriesMomentsAroundTheCorner) {
  const std::string text = R"([mesh]
file = "m.obj"
scheme = "linear"
[model]
kind = "mitc4"
[material]
young = 12e6
poisson = 0
thickness = 0.01
[[support]]
where = "x == 0"
kind = "clamped"
[[load]]
where = "z == 1"
force_per_length = [5, 0, 0]
[[probe]]
name = "tip"
at = [1, 0.1, 1]
)";
  const ShellModel model = build_shell_model(parse_problem(text, "p.toml"), angle_strip(32));
  const ShellSolution solution = solve_shell(model);
  EXPECT_EQ(solution.num_kink_nodes, 3);
  const double EI = 12e6 * 0.2 * 1e-6 / 12, F = 5 * 0.2;
  const Vec3 tip = probe(model, solution).front().displacement;
  EXPECT_NEAR(tip.x(), F / EI * (1.0 / 3 + 1), 2e-3 * tip.x());
  EXPECT_NEAR(tip.z(), -F / EI / 2, 2e-3 * std::abs(tip.z()));
}

std::string message_of(const std::string& text) {
  try {
    const Mesh mesh = testing::grid(2, 2, [](const Vec2& p) -> Vec2 { return p / 2; });
    (void)solve_shell(build_shell_model(parse_problem(text, "p.toml"), mesh));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ShellErrors, SaySo) {
  EXPECT_EQ(message_of(plate("fix = [\"uz\"]")), "no error");  // symmetry holds the rest
  std::string loose = plate("fix = [\"rx\"]");
  EXPECT_NE(message_of(loose).find("free to move along z"), std::string::npos) << message_of(loose);
  EXPECT_NE(
      message_of(plate("kind = \"clamped\"\nrotation = \"hard\"")).find("rotation belongs to"),
      std::string::npos);
  EXPECT_NE(message_of(plate("kind = \"clamped\"") +
                       "[[load]]\nwhere = \"vertex:0\"\nmoment = [0, 0, 1]\n")
                .find("about the shell's normal"),
            std::string::npos);
}

TEST(ShellErrors, NameFacesFarFromConvex) {
  const auto message = [](double middle) {
    Mesh mesh = testing::grid(2, 2, [](const Vec2& p) -> Vec2 { return p / 2; });
    mesh.points[VertexId(4)] = Vec3(middle, middle, 0);  // the corner that the four faces share
    try {
      (void)solve_shell(
          build_shell_model(parse_problem(plate("kind = \"clamped\""), "p.toml",
                                          std::vector<std::string>{"model.membrane=assumed"}),
                            mesh));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message(0.3), "no error");
  EXPECT_EQ(message(0.41),
            "m.obj: face 3 of the refined mesh is far from convex at its corner 0; membrane = "
            "\"assumed\" needs faces that are nearly so");
}

// A scheme's own boundary is no edge of symmetry: directors are slanted there.
TEST(ShellRemarks, SlantedDirectorsAtASymmetryAreNamed) {
  const auto firm = [](const ShellResult& r) {
    return std::count_if(
        r.model.remarks.begin(), r.model.remarks.end(),
        [](const std::string& remark) { return remark.find("too firmly") != std::string::npos; });
  };
  EXPECT_EQ(firm(solve_file("hemisphere.toml")), 0);
  std::ifstream in(std::filesystem::path(LIMES_DATA_DIR) / "hemisphere.toml");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t geometry = text.find("[geometry]");
  text.erase(geometry, text.find("[model]") - geometry);
  const Problem problem =
      parse_problem(text, std::filesystem::path(LIMES_DATA_DIR) / "p.toml",
                    std::vector<std::string>{"mesh.placement=scheme", "mesh.scheme=kobbelt"});
  EXPECT_EQ(firm(run_shell_problem(problem)), 2);
}

}  // namespace
}  // namespace limes
