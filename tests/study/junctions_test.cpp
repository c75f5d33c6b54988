// Junctions of shells: an I-beam against the theories of bending and torsion, and edges of three faces
// against parts that a seam ties.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "convergence/plane_meshes.h"
#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/junctions.h"
#include "limes/mesh/measure.h"
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

/// The section of data/i_beam.obj.
struct Section {
  double E = 1e7, G = E / 2.6, t = 0.05, b = 1, h = 2, L = 20;
};

double inertia(const Section& s) {
  return s.t * s.h * s.h * s.h / 12 + 2 * s.b * s.t * s.h * s.h / 4;
}

// With the shear flow q = V Q / I of a thin-walled section, 1 / A_s = integral of Q^2 / t over I^2: Q = t h s / 2
// along each half flange, plus t (h^2/4 - z^2) / 2 in the web.
double over_shear_area(const Section& s) {
  const double flange = std::pow(s.t * s.h / 2, 2) * std::pow(s.b / 2, 3) / 3 / s.t;
  double web = 0;
  constexpr int n = 1000;
  for (int i = 0; i < n; ++i) {
    const double z = s.h * ((i + 0.5) / n - 0.5);
    web += std::pow(s.t * s.b * s.h / 2 + s.t * (s.h * s.h / 4 - z * z) / 2, 2) / s.t * s.h / n;
  }
  return (4 * flange + web) / std::pow(inertia(s), 2);
}

// Timoshenko's beam: P L^3 / 3 E I + P L / (G A_s).
double bent(const Section& s) {
  return s.L * s.L * s.L / (3 * s.E * inertia(s)) + s.L * over_shear_area(s) / s.G;
}

// Vlasov's: G J phi' - E C phi''' = T with phi' = 0 at the clamped end and phi'' = 0 at the other. J of a flange
// is that of a rectangle, (b - 0.63 t) t^3 / 3 [timoshenko_goodier].
double twisted(const Section& s) {
  const double J = (2 * (s.b - 0.63 * s.t) + s.h) * s.t * s.t * s.t / 3;
  const double C = s.t * s.b * s.b * s.b / 12 * s.h * s.h / 2;
  const double k = std::sqrt(s.G * J / (s.E * C));
  return (s.L - std::tanh(k * s.L) / k) / (s.G * J);
}

TEST(IBeam, BendsAsTimoshenkosBeam) {
  const ShellResult r = solve_file("i_beam.toml");
  EXPECT_NEAR(-r.probes.at(0).displacement.z() / bent({}), 1, 0.01);
  EXPECT_EQ(r.solution.num_kink_nodes, 2 * 81);
  EXPECT_NEAR(r.solution.reactions.at(0).resultant.force.z(), 1, 1e-8);
}

// Under a force P down at the end the flange slopes by P x (2 L - x) / 2 E I + P / (G A_s) and turns by that about
// y, by the right-hand rule. It carries P (L - x) z / I; its layers are half a thickness apart.
TEST(IBeam, RotationsAndStressesAreThoseOfBeams) {
  const Section s;
  const double x = 10.125;  // the middle of an element
  const ShellResult r = solve_file("i_beam.toml", {"probe.0.at=[10.125, 0.25, 1]"});
  const ShellProbe& p = r.probes.at(0);
  const double slope = x * (2 * s.L - x) / (2 * s.E * inertia(s)) + over_shear_area(s) / s.G;
  EXPECT_NEAR(p.rotation.y() / slope, 1, 0.01);
  const double per_height = (s.L - x) / inertia(s);
  const auto [low, high] = std::minmax(p.state.von_mises.top, p.state.von_mises.bottom);
  EXPECT_NEAR(p.state.von_mises.middle / (per_height * s.h / 2), 1, 0.01);
  EXPECT_NEAR(high / (per_height * (s.h + s.t) / 2), 1, 0.01);
  EXPECT_NEAR(low / (per_height * (s.h - s.t) / 2), 1, 0.01);
}

TEST(IBeam, TwistsAsVlasovsBeam) {
  const ShellResult r = solve_file("i_beam_torsion.toml", {"mesh.levels=3"});
  EXPECT_NEAR(-r.probes.at(0).displacement.y() / twisted({}), 1, 0.02);
  EXPECT_NEAR(r.solution.reactions.at(0).resultant.moment.x(), -1, 1e-7);
}

// What a stiffness against drilling changes, over six decades of its factor.
TEST(Drilling, ChangesLittleInTheIBeam) {
  for (const char* name : {"i_beam.toml", "i_beam_torsion.toml"}) {
    const double none = solve_file(name).solution.strain_energy;
    for (const auto& [factor, bound] :
         {std::pair("1e-6", 1e-6), std::pair("1e-3", 1e-3), std::pair("1", 1e-2)}) {
      const double energy =
          solve_file(name, {std::string("model.drilling=") + factor}).solution.strain_energy;
      EXPECT_LE(energy, none * (1 + 1e-10)) << name << factor;
      EXPECT_NEAR(energy / none, 1, bound) << name << factor;
    }
  }
}

// Only where the junctions end the pieces have corners.
TEST(Junctions, IBeamFallsIntoItsFiveStrips) {
  const Mesh mesh = read_mesh(std::filesystem::path(LIMES_DATA_DIR) / "i_beam.obj").mesh;
  const CutMesh cut = cut_junctions(mesh);
  EXPECT_EQ(cut.num_edges, 40);
  EXPECT_EQ(measure(cut.mesh).components, 5);
  EXPECT_NEAR(measure(cut.mesh).area, 20 * 4, 1e-12);
  EXPECT_EQ(cut.mesh.tags.corners.size(), 12U);
  EXPECT_EQ(junction_edges(cut.mesh, Adjacency(cut.mesh.topology)).size(), 3U * 40);
  const MeshFile file =
      read_control_mesh(read_problem(std::filesystem::path(LIMES_DATA_DIR) / "i_beam.toml"), {});
  EXPECT_EQ(file.mesh.topology, cut.mesh.topology);
  ASSERT_EQ(file.remarks.size(), 1U);
  EXPECT_NE(file.remarks[0].find("cut along 40 edges with three faces or more"), std::string::npos);
}

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
where = "abs(x) == 1"
kind = "clamped"
[[load]]
where = "z == 1"
force_per_length = [1, 0, 2]
[[load]]
where = "z == 0 and x == 0"
force_per_length = [0, 0, 3]
)";

/// A floor, clamped at x = -1 and 1, and a wall on the line in its middle; with common vertices there, or
/// in parts.
Mesh tee(int n, bool in_parts) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  std::vector<FaceGroup> parts;
  for (const Vec3& along : {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
    const int first = static_cast<int>(x.size());
    const auto at = [&](int i, int j) { return i == 0 && !in_parts ? j : first + 2 * i + j; };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= 1; ++j)
        x.emplace_back(double(i) / n * along + Vec3(0, 0.1 * j, 0));
    parts.push_back({parts.empty() ? "left" : parts.size() == 1 ? "right" : "wall", {}});
    for (int i = 0; i < n; ++i) {
      parts.back().faces.emplace_back(static_cast<int>(quads.size() / 4));
      quads.insert(quads.end(), {at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)});
    }
  }
  Mesh mesh = testing::make_mesh(std::move(x), std::move(quads));
  mesh.parts = std::move(parts);
  return mesh;
}

ShellSolution solved(const std::string& more, Mesh mesh,
                     const char* override = "model.drilling=0") {
  const Problem problem = parse_problem(text + more, "p.toml", std::vector<std::string>{override});
  return solve_shell(build_shell_model(problem, std::move(mesh)));
}

// Cut edges are as a seam; a load along them acts once.
TEST(Junctions, AreAsPartsOnASeam) {
  const ShellSolution parts =
      solved("[[seam]]\nparts = [\"left\", \"right\", \"wall\"]\n", tee(8, true));
  const ShellSolution cut = solved("", cut_junctions(tee(8, false)).mesh, "mesh.junctions=tied");
  EXPECT_EQ(parts.num_unknowns, cut.num_unknowns);
  EXPECT_EQ(cut.num_kink_nodes, 2);
  EXPECT_NEAR(cut.strain_energy / parts.strain_energy, 1, 1e-9);
  EXPECT_NEAR(cut.loads.force.z(), 0.1 * (2 + 3), 1e-12);
  EXPECT_NEAR(parts.loads.force.z(), 0.1 * (2 + 3), 1e-12);
}

TEST(Junctions, AreRefusedUnlessTheyAreTied) {
  try {
    (void)solved("", tee(2, false));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "m.obj: edge 1-0 has 3 faces (0, 2, 4); at most two can be joined; [mesh] junctions = "
        "\"tied\" makes it a junction of shells");
  }
}

// Schemes bend the pieces alike, and so the seam stays closed. Catmull-Clark rounds the flanges' corners.
TEST(Junctions, StayClosedUnderEveryScheme) {
  for (const char* scheme : {"linear", "kobbelt", "catmull-clark"}) {
    const ShellResult r =
        solve_file("i_beam.toml", {std::string("mesh.scheme=") + scheme, "mesh.levels=1"});
    EXPECT_EQ(r.solution.num_kink_nodes, 2 * 41) << scheme;
    EXPECT_NEAR(-r.probes.at(0).displacement.z() / bent({}), 1, 0.08) << scheme;
  }
}

// Stiffness against drilling is that of the nodes on junctions, next to hanging nodes too.
TEST(Junctions, DrillWithHangingNodes) {
  const auto energy = [](const char* drilling) {
    const ShellResult r = solve_file(
        "i_beam.toml", {"mesh.levels=0", "adapt.closure=hanging", "adapt.max_steps=3", drilling});
    EXPECT_GT(r.adaptive->history.steps.size(), 2U);
    EXPECT_LT(r.solution.imbalance.moment.norm(), 1e-9 * r.solution.loads.moment.norm())
        << drilling;
    return r.solution.strain_energy;
  };
  EXPECT_NEAR(energy("model.drilling=0.01") / energy("model.drilling=0"), 1, 2e-4);
}

// Refined where the error is: both sides of the junctions are split alike.
TEST(Junctions, CanBeRefinedAdaptively) {
  const ShellResult r =
      solve_file("i_beam.toml", {"mesh.levels=1", "adapt.max_dofs=12000", "adapt.share=0.3"});
  EXPECT_GT(r.adaptive->history.steps.size(), 1U);
  EXPECT_NEAR(-r.probes.at(0).displacement.z() / bent({}), 1, 0.01);
  // In every place along the junctions the edges of all three pieces.
  std::map<std::array<double, 6>, int> edges;
  const Mesh& mesh = *r.model.mesh;
  for (int h = 0; h < mesh.topology.num_corners(); ++h) {
    if (r.model.adjacency->twin(HalfedgeId(h)).valid()) continue;
    std::array<Vec3, 2> x{mesh.points[r.model.adjacency->from(HalfedgeId(h))],
                          mesh.points[r.model.adjacency->to(HalfedgeId(h))]};
    if (x[0].x() > x[1].x()) std::swap(x[0], x[1]);
    if (x[0].y() == 0 && x[1].y() == 0 && x[0].x() < x[1].x() && x[0].z() == x[1].z())
      ++edges[{x[0].x(), x[0].y(), x[0].z(), x[1].x(), x[1].y(), x[1].z()}];
  }
  EXPECT_GT(edges.size(), 2U * 40U);  // those of uniform refinement; some are split
  for (const auto& [place, count] : edges)
    EXPECT_EQ(count, 3) << place[0] << ' ' << place[2];
}

}  // namespace
}  // namespace limes
