// Shells with holes and of several parts, against Reissner-Mindlin solutions of high order (dolfinx, degree 4
// and 5, see data/SOURCES.md), and parts against the same mesh in one piece.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
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

double energy(const std::string& name, std::vector<std::string> overrides = {}) {
  return solve_file(name, std::move(overrides)).solution.strain_energy;
}

// Energy of the quarter, hard diaphragm: from below.
TEST(ShellHole, GoesToTheLimitOfTheTheory) {
  for (const auto& [file, limit] :
       {std::pair("hole_5.toml", 1401.0685), std::pair("hole_2_5.toml", 1260.10622)}) {
    double before = 1;
    for (const char* level : {"1", "2", "3"}) {
      const double error = 1 - energy(file, {std::string("mesh.levels=") + level}) / limit;
      EXPECT_GT(error, 0) << file << level;
      EXPECT_LT(error, before / 2) << file << level;
      before = error;
    }
    EXPECT_LT(before, 0.01) << file;
  }
}

// A tenth as thick: 64 x 128 elements for 1 %.
TEST(ShellHole, ThinRoofComesClose) {
  EXPECT_NEAR(energy("hole_5.toml", {"material.thickness=0.025", "mesh.levels=4"}) / 72685.37, 1,
              0.01);
}

// The developed circle, to rounding.
TEST(ShellHole, NodesOfTheRimAreOnTheCircle) {
  const ShellModel model =
      read_shell_model(read_problem(std::filesystem::path(LIMES_DATA_DIR) / "hole_5.toml",
                                    std::vector<std::string>{"mesh.levels=3"}));
  int on_circle = 0;
  for (const Vec3& x : model.mesh->points) {
    EXPECT_NEAR(std::hypot(x.x(), x.z()), 25, 1e-13 * 25);
    on_circle += std::abs(std::hypot(25 * std::atan2(x.x(), x.z()), x.y()) - 5) < 1e-12;
  }
  EXPECT_EQ(on_circle, 65);
}

// Bands between shell models: 2 %, 1 % of the energy; C needs finer meshes than a test has time for.
TEST(ShellSeam, CylinderOnAPlate) {
  for (const auto& [file, rotation, limit, band] :
       {std::tuple("cylinder_plate_a.toml", "hard", 1.034345e-3, 0.02),
        std::tuple("cylinder_plate_a.toml", "soft", 1.09743e-3, 0.02),
        std::tuple("cylinder_plate_b.toml", "hard", 1.304e-2, 0.01),
        std::tuple("cylinder_plate_b.toml", "soft", 1.34667e-2, 0.01)}) {
    const ShellResult r =
        solve_file(file, {std::string("support.0.rotation=") + rotation,
                          std::string("mesh.levels=") + (rotation[0] == 'h' ? "3" : "4")});
    EXPECT_NEAR(r.solution.strain_energy / limit, 1, band) << file << rotation;
    EXPECT_EQ(r.solution.num_kink_nodes, rotation[0] == 'h' ? 64 : 128);
    for (int v = 0; v < r.model.mesh->points.size(); ++v)
      EXPECT_EQ(r.model.mesh->points[VertexId(v)], r.model.mesh->points[r.model.node[VertexId(v)]]);
  }
}

/// EI = 1 per width.
const std::string thin = R"([mesh]
file = "m.obj"
scheme = "linear"
[model]
kind = "mitc4"
[material]
young = 12e6
thickness = 0.01
)";

const std::string frame = thin + R"(poisson = 0.3
[[support]]
where = "x == 0"
kind = "clamped"
[[load]]
where = "z == 1"
force_per_length = [5, 3, 0]
[[probe]]
name = "tip"
at = [1, 0.1, 1]
)";

/// An L of a floor and a wall, n quads each along; in two parts with vertices of their own, or in one piece.
Mesh angle(int n, bool in_parts) {
  const int m = 2 * n + 1 + (in_parts ? 1 : 0);
  std::vector<Vec3> x;
  std::vector<int> quads;
  for (int j = 0; j <= 2; ++j)
    for (int i = 0; i < m; ++i) {
      const double s = double(in_parts && i > n ? i - 1 : i) / n;
      x.emplace_back(std::min(s, 1.0), 0.1 * j, std::max(s - 1, 0.0));
    }
  Mesh mesh;
  FaceGroup floor{"floor", {}}, wall{"wall", {}};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < m - 1; ++i) {
      if (in_parts && i == n) continue;
      (i < n ? floor : wall).faces.emplace_back(static_cast<int>(quads.size() / 4));
      quads.insert(quads.end(), {j * m + i, j * m + i + 1, (j + 1) * m + i + 1, (j + 1) * m + i});
    }
  mesh = testing::make_mesh(std::move(x), std::move(quads));
  mesh.parts = {floor, wall};
  return mesh;
}

TEST(ShellSeam, TwoPartsAreAsOnePieceWithAKink) {
  const ShellModel one = build_shell_model(parse_problem(frame, "p.toml"), angle(8, false));
  const ShellModel two = build_shell_model(
      parse_problem(frame + "[[seam]]\nparts = [\"floor\", \"wall\"]\n", "p.toml"), angle(8, true));
  const ShellSolution a = solve_shell(one), b = solve_shell(two);
  EXPECT_EQ(a.num_unknowns, b.num_unknowns);
  EXPECT_EQ(a.num_kink_nodes, b.num_kink_nodes);
  EXPECT_NEAR(b.strain_energy / a.strain_energy, 1, 1e-9);
  const Vec3 p = probe(one, a).front().displacement, q = probe(two, b).front().displacement;
  EXPECT_LT((p - q).norm(), 1e-9 * p.norm());
  EXPECT_LT((a.reactions[0].resultant.moment - b.reactions[0].resultant.moment).norm(), 1e-8);
}

/// A floor in two halves, clamped at x = -1 and 1, and a wall on the line where they meet: a T-junction.
Mesh tee(int n) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  Mesh mesh;
  for (const Vec3& along : {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
    const int first = static_cast<int>(x.size());
    for (int j = 0; j <= 1; ++j)
      for (int i = 0; i <= n; ++i)
        x.emplace_back(double(i) / n * along + Vec3(0, 0.1 * j, 0));
    FaceGroup& part = mesh.parts.emplace_back();
    part.name = mesh.parts.size() == 1 ? "left" : mesh.parts.size() == 2 ? "right" : "wall";
    for (int i = 0; i < n; ++i) {
      part.faces.emplace_back(static_cast<int>(quads.size() / 4));
      const int a = first + i;
      quads.insert(quads.end(), {a, a + 1, a + n + 2, a + n + 1});
    }
  }
  std::vector<FaceGroup> parts = std::move(mesh.parts);
  mesh = testing::make_mesh(std::move(x), std::move(quads));
  mesh.parts = std::move(parts);
  return mesh;
}

// Bending of beams of length 1, per width, EI = 1 (nu = 0, thin), and with shared rotation at the joint: a
// force H on the end of the wall moves it by H/3 + H/8 (the floor resists with 4 EI on each side), and
// a force P along the wall sinks the joint by P/24.
TEST(ShellSeam, TJunctionSharesRotation) {
  const std::string text = thin + R"(poisson = 0
[[support]]
where = "abs(x) == 1"
kind = "clamped"
[[seam]]
parts = ["left", "right", "wall"]
[[load]]
where = "z == 1"
force_per_length = [1, 0, 2]
[[probe]]
name = "end"
at = [0, 0.05, 1]
[[probe]]
name = "joint"
at = [0, 0.05, 0]
)";
  const ShellModel model = build_shell_model(parse_problem(text, "p.toml"), tee(32));
  const ShellSolution solution = solve_shell(model);
  EXPECT_EQ(solution.num_kink_nodes, 2);
  const std::vector<ShellProbe> probes = probe(model, solution);
  EXPECT_NEAR(probes[0].displacement.x(), 1.0 / 3 + 1.0 / 8, 1e-3);
  EXPECT_NEAR(probes[1].rotation.y(), 1.0 / 8, 1e-3);
  EXPECT_NEAR(probes[1].displacement.z(), 2.0 / 24, 1e-3);
}

std::string message_of(const std::string& text, const Mesh& mesh) {
  try {
    (void)build_shell_model(parse_problem(text, "p.toml"), mesh);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ShellSeam, ErrorsNamePartsVerticesAndDistance) {
  const std::string seam = "[[seam]]\nparts = [\"floor\", \"wall\"]\n";
  Mesh mesh = angle(4, true);
  EXPECT_NE(message_of(frame + "[[seam]]\nparts = [\"floor\", \"wal\"]\n", mesh)
                .find("p.toml:20: there is no part 'wal'; did you mean 'wall'?"),
            std::string::npos);
  mesh.points[VertexId(15)].z() += 1e-3;  // of the wall, in the middle of the seam
  const std::string message = message_of(frame + seam, mesh);
  EXPECT_NE(message.find("part 'floor' has the vertex 14 on the edge between vertices"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("vertex 15 is 0.001 away"), std::string::npos) << message;
}

// Linear precision of the scheme kobbelt: the plate between its square and the ellipse stays flat, and square.
TEST(ShellSeams, SchemeKeepsThePlateFlat) {
  const ShellModel model = read_shell_model(
      read_problem(std::filesystem::path(LIMES_DATA_DIR) / "cylinder_plate_c.toml",
                   std::vector<std::string>{"mesh.file=cylinder_plate_6_quads.obj",
                                            "mesh.scheme=kobbelt", "mesh.placement=scheme"}));
  const Mesh& mesh = *model.mesh;
  ASSERT_EQ(mesh.parts.size(), 2U);
  double border = 0;
  for (const FaceId f : mesh.parts[1].faces)
    for (int i = 0; i < 4; ++i) {
      const Vec3& x = mesh.points[mesh.topology.face(f)[static_cast<std::size_t>(i)]];
      EXPECT_LE(std::abs(x.z()), 1e-14);
      EXPECT_LE(x.head<2>().cwiseAbs().maxCoeff(), 15 + 1e-13);
      const HalfedgeId h = mesh.topology.halfedge(f, i);
      if (model.adjacency->twin(h).valid() || x.head<2>().norm() < 10) continue;
      border += (mesh.points[model.adjacency->to(h)] - x).norm();
    }
  EXPECT_NEAR(border, 120, 1e-12 * 120);
}

}  // namespace
}  // namespace limes
