// Problems on meshes with hanging vertices: patch tests, motions and forces that are known.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <random>

#include "convergence/plane_meshes.h"
#include "limes/adapt/finer.h"
#include "limes/core/error.h"
#include "limes/study/adaptive.h"
#include "limes/study/poisson_conditions.h"
#include "limes/study/run.h"
#include "limes/study/shell_error.h"
#include "limes/study/shell_finer.h"
#include "limes/study/shell_forest.h"
#include "limes/study/shell_placement.h"
#include "limes/study/shell_residual.h"
#include "limes/study/shell_smoothing.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split_leaves.h"

namespace limes {
namespace {

/// The square [0, 3]^2 of five distorted quads.
Mesh flat_patch() {
  return testing::make_mesh(
      {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 3, 0), Vec3(0, 3, 0), Vec3(0.8, 1.1, 0),
       Vec3(2.1, 0.7, 0), Vec3(1.9, 2.2, 0), Vec3(1.2, 1.8, 0)},
      {0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7, 4, 5, 6, 7});
}

/// Splits about one leaf in three, a few times.
void split_here_and_there(Forest& forest, int times, unsigned seed,
                          std::span<const TiedEdge> seams = {}) {
  std::mt19937 random(seed);
  for (int i = 0; i < times; ++i) {
    std::vector<FaceId> marked;
    for (const FaceId leaf : forest.leaves())
      if (random() % 3 == 0) marked.push_back(leaf);
    forest.refine(marked);
    match_seams(forest, seams);
  }
}

ForestMesh random_mesh(const Mesh& control, unsigned seed) {
  Forest forest(control, find_scheme("linear"), {}, SplitUnit::faces);
  split_here_and_there(forest, 4, seed);
  return forest_mesh(forest, Closure::hanging);
}

double total(const std::vector<double>& squares) {
  return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
}

class EverySeed : public ::testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Hanging, EverySeed, ::testing::Range(1U, 6U));

// Neighbours share whole edges: one boundary of a disc, and each hanging vertex is an inner one with three
// faces.
TEST_P(EverySeed, FacesWithHangingCornersAreASurface) {
  const ForestMesh forest = random_mesh(flat_patch(), GetParam());
  ASSERT_GT(forest.hanging.size(), 10U);
  const HangingFaces faces = hanging_faces(forest.mesh.topology, forest.hanging);
  const Adjacency adjacency(faces.topology);
  const int vertices = forest.mesh.points.size();
  EXPECT_EQ(vertices - adjacency.num_edges() + faces.topology.num_faces(), 1);
  for (const HangingVertex& h : forest.hanging) {
    EXPECT_FALSE(adjacency.is_boundary(h.vertex));
    EXPECT_EQ(adjacency.num_ring_faces(h.vertex), 3);
  }
  for (int f = 0; f < faces.topology.num_faces(); ++f)
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(faces.topology.corner(faces.corner(FaceId(f), i)),
                forest.mesh.topology.face(FaceId(f))[static_cast<std::size_t>(i)]);
}

const std::string plate = R"([mesh]
file = "m.obj"
scheme = "linear"
[model]
kind = "mitc4"
[material]
young = 1000
poisson = 0.25
thickness = 0.2
[adapt]
closure = "hanging"
)";

ShellModel plate_on(const ForestMesh& forest, const std::string& conditions) {
  return shell_model_on(parse_problem(plate + conditions, "p.toml"), forest.mesh, {},
                        forest.hanging);
}

ShellSolution solved(const ShellModel& model) {
  ShellSolution solution = solve_shell(model);
  for (const SolutionCheck& c : check_solution(model, solution))
    EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  const double size = std::max(solution.load_size, 1.0);  // moments may be all there is
  EXPECT_LT(solution.imbalance.force.norm(), 1e-9 * size);
  EXPECT_LT(solution.imbalance.moment.norm(), 1e-9 * size * model.diagonal);
  return solution;
}

const std::string stretched = R"(
[[support]]
where = "all"
fix = ["uz", "rx", "ry"]
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == 3"
force_per_length = [1, 0, 0]
)";

void expect_stretch(const ShellModel& model) {
  const ShellSolution solution = solved(model);
  constexpr double strain = 1 / (1000 * 0.2);
  for (int v = 0; v < model.mesh->points.size(); ++v) {
    const Vec3& x = model.mesh->points[VertexId(v)];
    EXPECT_LT((solution.u.segment<3>(6 * v) - strain * Vec3(x.x(), -0.25 * x.y(), 0)).norm(),
              1e-12);
  }
  EXPECT_NEAR(solution.strain_energy, 9 * strain / 2, 1e-12);
  EXPECT_LT(total(estimate_error(model, solution)), 1e-11);
  EXPECT_LT(total(residual_estimate(model, solution)), 1e-11);
}

// Stretch along x by a stress of 5 on the whole plate, which is held in its plane everywhere, at hanging nodes
// too.
TEST_P(EverySeed, ConstantMembraneStrain) {
  expect_stretch(plate_on(random_mesh(flat_patch(), GetParam()), stretched));
}

// The same after smoothing, and on the mesh with every face of that split: nodes hang in the middles of their
// sides. Vertices where a selection ends have not moved.
TEST_P(EverySeed, ConstantMembraneStrainOfSmoothedMeshes) {
  const Problem problem = parse_problem(
      plate + stretched +
          "[[load]]\nwhere = \"x < 1.3\"\nforce_per_area = [0, 0, 1e-9]\n"
          "[geometry]\nkind = \"plane\"\naxis = [0, 0, 1]\n",
      "p.toml", std::vector<std::string>{"mesh.placement=\"exact\"", "mesh.smoothing=20"});
  ShellForest shell = shell_forest(problem, flat_patch());
  split_here_and_there(shell.forest, 4, GetParam());
  const ForestMesh mesh = forest_mesh(shell.forest, Closure::hanging);
  ForestMesh smoothed = mesh;
  smooth_on_surfaces(problem, shell.forest, shell.areas, shell.curves, {}, smoothed);
  EXPECT_TRUE(std::isfinite(worst_distortion(smoothed.mesh)));
  for (const HangingVertex& h : mesh.hanging)
    EXPECT_LT((2 * smoothed.mesh.points[h.vertex] - smoothed.mesh.points[h.ends[0]] -
               smoothed.mesh.points[h.ends[1]])
                  .norm(),
              1e-14);
  Mesh closed = mesh.mesh;
  closed.topology = hanging_faces(mesh.mesh.topology, mesh.hanging).topology;
  const IdArray<VertexId, char> held = held_by_selections(problem, closed);
  int moved = 0;
  for (int v = 0; v < held.size(); ++v) {
    const double d = (smoothed.mesh.points[VertexId(v)] - mesh.mesh.points[VertexId(v)]).norm();
    if (held[VertexId(v)]) {
      EXPECT_LT(d, 1e-14) << v;
    }
    moved += d > 1e-3;
  }
  EXPECT_GT(moved, held.size() / 4);
  const ShellModel model = shell_model_on(problem, smoothed.mesh, {}, mesh.hanging);
  expect_stretch(model);
  expect_stretch(finer_model(model, shell, {}, mesh, 1));
}

/// Moments at the vertices of two opposite sides that bend the plate by one moment per length.
std::string moments_on(const Mesh& mesh, int axis, double moment) {
  const Adjacency adjacency(mesh.topology);
  std::map<VertexId, double> at;
  for (int i = 0; i < mesh.topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    const VertexId a = adjacency.from(h), b = adjacency.to(h);
    const double s = mesh.points[a](axis), length = (mesh.points[b] - mesh.points[a]).norm();
    if (adjacency.twin(h).valid() || s != mesh.points[b](axis)) continue;
    for (const VertexId v : {a, b})
      at[v] += (s == 0 ? -1 : 1) * moment * length / 2;
  }
  std::string text;
  for (const auto& [v, m] : at)
    text += fmt::format("[[load]]\nwhere = \"vertex:{}\"\nmoment = [{}, {}, 0]\n", v.value,
                        axis == 1 ? m : 0.0, axis == 0 ? -m : 0.0);
  return text;
}

// w = (a x^2 + b y^2) / 2, with Kirchhoff's rotations.
TEST_P(EverySeed, ConstantCurvature) {
  const ForestMesh forest = random_mesh(flat_patch(), GetParam());
  const std::string held = R"(
[[support]]
where = "x == 0 and y == 0"
fix = ["ux", "uy", "uz", "rx", "ry"]
[[support]]
where = "x == 3 and y == 0"
fix = ["uy"]
)";
  constexpr double mx = 0.3, my = -0.1, nu = 0.25, bending = 1000 * 0.008 / 12;
  const Mesh closed = *plate_on(forest, held).mesh;
  const ShellModel model =
      plate_on(forest, held + moments_on(closed, 0, mx) + moments_on(closed, 1, my));
  const ShellSolution solution = solved(model);
  constexpr double a = (mx - nu * my) / bending, b = (my - nu * mx) / bending;
  for (int v = 0; v < model.mesh->points.size(); ++v) {
    const Vec3& x = model.mesh->points[VertexId(v)];
    Eigen::Matrix<double, 6, 1> exact;
    exact << 0, 0, (a * x.x() * x.x() + b * x.y() * x.y()) / 2, b * x.y(), -a * x.x(), 0;
    EXPECT_LT((solution.u.segment<6>(6 * v) - exact).norm(), 1e-10) << v;
  }
  EXPECT_NEAR(solution.strain_energy, 9 * (mx * a + my * b) / 2, 1e-11);
  EXPECT_LT(total(estimate_error(model, solution)), 1e-9);
}

// No residuals of a state that all elements have exactly, with constant strain and curvature, where the border
// is held; also if nodes lie on circles, so that hanging ones are beside the chords of the sides they are in.
TEST_P(EverySeed, ResidualsOfConstantStrainAndCurvature) {
  for (const bool bent : {false, true}) {
    ForestMesh forest = random_mesh(
        bent ? testing::grid(3, 3, [](const Vec2& p) { return Vec2(3 * p); }) : flat_patch(),
        GetParam());
    for (int v = 0; bent && v < forest.mesh.points.size(); ++v) {
      const Vec3 x = forest.mesh.points[VertexId(v)];
      forest.mesh.points[VertexId(v)] =
          (2 + x.y()) * Vec3(-std::sin(x.x() / 4), std::cos(x.x() / 4), 0);
    }
    const ShellModel model = plate_on(forest, R"(
[[support]]
where = "boundary"
fix = ["ux", "uy", "uz", "rx", "ry"]
)");
    ShellSolution solution;
    solution.u = VectorX::Zero(model.num_unknowns());
    for (int v = 0; v < model.mesh->points.size(); ++v) {  // w = x^2 + 3 x y - 2 y^2
      const Vec3& x = model.mesh->points[VertexId(v)];
      solution.u.segment<6>(6 * v) << 2 * x.x() - x.y(), x.x() + 3 * x.y(),
          x.x() * x.x() + 3 * x.x() * x.y() - 2 * x.y() * x.y(), 3 * x.x() - 4 * x.y(),
          -2 * x.x() - 3 * x.y(), 0;
    }
    const double norm = std::sqrt(solution.u.dot(shell_matrix(model) * solution.u));
    EXPECT_LT(total(residual_estimate(model, solution)), 1e-10 * norm) << bent;
  }
}

// Loads at hanging nodes, supports along a line that has some, and as many reactions as loads.
TEST_P(EverySeed, ReactionsAreTheLoads) {
  const std::vector<std::string> overrides{"adapt.closure=hanging", "mesh.levels=0"};
  const Problem problem =
      read_problem(std::filesystem::path(LIMES_DATA_DIR) / "hole_5.toml", overrides);
  const Mesh control = read_control_mesh(problem, {}).mesh;
  ShellForest shell = shell_forest(problem, control);
  split_here_and_there(shell.forest, 2, GetParam());
  const ForestMesh mesh = forest_mesh(shell.forest, Closure::hanging);
  ASSERT_GT(mesh.hanging.size(), 10U);
  Problem more = problem;
  for (const std::size_t i : {std::size_t{0}, mesh.hanging.size() / 2}) {
    const int v = mesh.hanging[i].vertex.value;
    more.loads.push_back(problem.loads.front());
    more.loads.back().kind = LoadKind::force;
    more.loads.back().where = fmt::format("vertex:{}", v);
    SupportSettings& support = more.supports.emplace_back();
    support.where = fmt::format("vertex:{}", mesh.hanging[i + 1].vertex.value);
    support.fix = {true, true, true};
  }
  const ShellModel model = shell_model_on(more, mesh.mesh, {}, mesh.hanging);
  const ShellSolution solution = solved(model);
  EXPECT_GT(solution.load_size, 90 * 2 * 0.99);
  for (std::size_t i = 0; i < 2; ++i) {  // held where a node hangs
    const auto at = mesh.hanging[i == 0 ? 1 : mesh.hanging.size() / 2 + 1].vertex;
    EXPECT_LT(solution.u.segment<3>(6 * at.value).norm(), 1e-12 * solution.u.norm());
    EXPECT_GT(solution.reactions[problem.supports.size() + i].resultant.force.norm(), 1);
  }
}

/// Three plates of 2 x 2 quads that meet on the line x = z = 0.
Mesh tee() {
  std::vector<Vec3> x;
  std::vector<int> quads;
  std::vector<FaceGroup> parts;
  for (const Vec3& along : {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
    const int first = static_cast<int>(x.size());
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i <= 2; ++i)
        x.emplace_back(0.5 * i * along + Vec3(0, 0.5 * j, 0));
    FaceGroup& part = parts.emplace_back();
    part.name = parts.size() == 1 ? "left" : parts.size() == 2 ? "right" : "wall";
    for (int k = 0; k < 4; ++k) {
      part.faces.emplace_back(static_cast<int>(quads.size() / 4));
      const int a = first + 3 * (k / 2) + k % 2;
      quads.insert(quads.end(), {a, a + 1, a + 4, a + 3});
    }
  }
  Mesh mesh = testing::make_mesh(std::move(x), std::move(quads));
  mesh.parts = std::move(parts);
  return mesh;
}

// Three parts on a seam, with six unknowns there, from control faces that are not split; no node of the seam
// hangs.
TEST_P(EverySeed, SeamsOfThreePartsAndKinks) {
  const Problem problem = parse_problem(plate + R"(
[[support]]
where = "abs(x) == 1"
kind = "clamped"
[[seam]]
parts = ["left", "right", "wall"]
[[load]]
where = "z == 1"
force_per_length = [1, 0, 2]
)",
                                        "p.toml");
  ShellForest shell = shell_forest(problem, tee());
  split_here_and_there(shell.forest, 3, GetParam(), shell.seams);
  const ForestMesh mesh = forest_mesh(shell.forest, Closure::hanging);
  const std::vector<TiedEdge> tied = tied_edges(shell.forest, mesh, shell.seams);
  const ShellModel model = shell_model_on(problem, mesh.mesh, tied, mesh.hanging);
  ASSERT_GT(mesh.hanging.size(), 10U);
  for (const HangingVertex& h : mesh.hanging)
    EXPECT_GT(mesh.mesh.points[h.vertex].head<3>().cwiseProduct(Vec3(1, 0, 1)).norm(), 0);
  const ShellSolution solution = solved(model);
  EXPECT_LT((solution.loads.force + solution.reactions[0].resultant.force).norm(), 1e-9);
  EXPECT_GT(solution.num_kink_nodes, 3);
}

PlaneModel plane_on(const ForestMesh& forest, const std::string& text) {
  return build_model(
      parse_problem("[mesh]\nfile = \"m.obj\"\nscheme = \"linear\"\n" + text, "p.toml"),
      forest.mesh, forest.hanging);
}

const std::string linear_value = R"([model]
kind = "poisson"
[material]
conductivity = 3
[[support]]
where = "boundary"
value = "2 + 3 * x - y"
)";

TEST_P(EverySeed, LinearSolutionsOfPoissonsEquation) {
  const ForestMesh forest = random_mesh(flat_patch(), GetParam());
  for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
    const PlaneModel model =
        plane_on(forest, linear_value + "[adapt]\nclosure = \"hanging\"\nestimator = \"" +
                             estimator + "\"\n");
    const PoissonSolution solution = solve_poisson(model);
    for (const SolutionCheck& c : check_solution(model, solution))
      EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
    EXPECT_NEAR(solution.strain_energy, 0.5 * 3 * 10 * 9, 1e-11);
    EXPECT_LT(std::abs(solution.imbalance), 1e-11 * solution.reaction_size);
    EXPECT_LT(total(estimate_error(model, solution)), 1e-11) << estimator;
  }
}

// The space is part of that of the forest with all leaves split, so by Galerkin's orthogonality the square of
// the difference is twice that of the energies.
TEST_P(EverySeed, ErrorAgainstAFinerSolutionIsThatOfTheEnergies) {
  const Mesh control =
      testing::grid(3, 2, [](const Vec2& p) { return Vec2(3 * p.x() + p.y(), 2 * p.y()); });
  Forest forest(control, find_scheme("linear"), {}, SplitUnit::faces);
  split_here_and_there(forest, 3, GetParam());
  const auto model_on = [](Forest& leaves) {
    const ForestMesh mesh = forest_mesh(leaves, Closure::hanging);
    EXPECT_GT(mesh.hanging.size(), 10U);
    return plane_on(mesh, R"([model]
kind = "poisson"
[material]
[[support]]
where = "boundary"
value = 0
[[load]]
where = "all"
source = 1
)");
  };
  const PlaneModel model = model_on(forest);
  const PoissonSolution solution = solve_poisson(model);
  for (const int levels : {1, 2}) {
    Forest split = split_leaves(forest, levels);
    ASSERT_EQ(split.leaves().size(), forest.leaves().size() << (2 * levels));
    const PlaneModel finer = model_on(split);
    const PoissonSolution reference = solve_poisson(finer);
    const std::vector<double> squares =
        error_against(*finer.space, energy_density(finer, reference), levels, *model.space,
                      energy_density(model, solution));
    const double difference = reference.strain_energy - solution.strain_energy;
    EXPECT_NEAR(std::accumulate(squares.begin(), squares.end(), 0.0) / (2 * difference), 1, 1e-9);
  }
}

TEST_P(EverySeed, LinearDisplacementsOfPlaneElasticity) {
  const ForestMesh forest = random_mesh(flat_patch(), GetParam());
  for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
    const PlaneModel model = plane_on(forest, R"([model]
kind = "plane-stress"
[material]
young = 10
poisson = 0.25
thickness = 0.5
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == 3"
pressure = -5
[adapt]
closure = "hanging"
estimator = ")" + std::string(estimator) + "\"\n");
    const PlaneSolution solution = solve_plane(model);
    for (const SolutionCheck& c : check_solution(model, solution))
      EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
    EXPECT_NEAR(solution.strain_energy, 0.5 * 0.5 * 5 * 0.5 * 9, 1e-11);
    EXPECT_NEAR(solution.reactions[0].force(0), -5 * 0.5 * 3, 1e-11);
    EXPECT_LT(total(estimate_error(model, solution)), 1e-11) << estimator;
  }
}

// Fluxes along the border of two materials jump; no recovery across it, where vertices hang in it too.
TEST_P(EverySeed, LinearSolutionsInTwoMaterials) {
  ForestMesh forest = random_mesh(
      testing::grid(4, 2, [](const Vec2& p) { return Vec2(2 * p.x(), p.y()); }), GetParam());
  const auto on_border = [&](const HangingVertex& h) {
    return forest.mesh.points[h.vertex].x() == 1 && forest.mesh.points[h.ends[0]].x() == 1;
  };
  EXPECT_TRUE(std::any_of(forest.hanging.begin(), forest.hanging.end(), on_border));
  for (const HangingVertex& h : forest.hanging)  // tags mean nothing here, and do no harm
    for (const VertexId end : h.ends)
      forest.mesh.tags.creases.push_back({h.vertex, end, 1});
  for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
    const PlaneModel model = plane_on(forest, R"toml([model]
kind = "poisson"
[[material]]
conductivity = 1
[[material]]
where = "x >= 1"
conductivity = 4
[[support]]
where = "boundary"
value = "y + (x < 1 ? x : 1 + (x - 1) / 4)"
[adapt]
closure = "hanging"
estimator = ")toml" + std::string(estimator) + "\"\n");
    const PoissonSolution solution = solve_poisson(model);
    for (int v = 0; v < forest.mesh.points.size(); ++v) {
      const Vec3& x = forest.mesh.points[VertexId(v)];
      const double exact = x.y() + (x.x() < 1 ? x.x() : 1 + (x.x() - 1) / 4);
      EXPECT_NEAR(solution.u(dof_of_vertex(*model.space, VertexId(v))), exact, 1e-12);
    }
    EXPECT_LT(total(estimate_error(model, solution)), 1e-11) << estimator;
  }
}

}  // namespace
}  // namespace limes
