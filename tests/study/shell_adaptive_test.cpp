// Shells refined where the error is: against Reissner-Mindlin solutions of high order (dolfinx, see
// data/SOURCES.md), stress states that the elements represent exactly, and uniform refinement.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "convergence/plane_meshes.h"
#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/study/run.h"
#include "limes/study/shell_error.h"
#include "limes/study/shell_finer.h"
#include "limes/study/shell_forest.h"
#include "limes/study/shell_placement.h"
#include "limes/study/shell_residual.h"

namespace limes {
namespace {

Problem problem_file(const std::string& name, const std::vector<std::string>& overrides) {
  return read_problem(std::filesystem::path(LIMES_DATA_DIR) / name, overrides);
}

/// Splits about one leaf in twenty, a few times.
void refine_here_and_there(ShellForest& shell, int times, unsigned seed) {
  std::mt19937 random(seed);
  for (int i = 0; i < times; ++i) {
    std::vector<FaceId> marked;
    for (const FaceId leaf : shell.forest.leaves())
      if (random() % 20 == 0) marked.push_back(leaf);
    shell.forest.refine(marked);
    match_seams(shell.forest, shell.seams);
  }
}

struct Placed {
  const char* file;
  int before;  // uniform steps before the forest: the plate's control net has triangles
};

class PlacedForest : public ::testing::TestWithParam<Placed> {};
INSTANTIATE_TEST_SUITE_P(Files, PlacedForest,
                         ::testing::Values(Placed{"hole_5.toml", 0}, Placed{"hypar.toml", 0},
                                           Placed{"cylinder_plate_c.toml", 1}));

TEST_P(PlacedForest, VerticesAreBitwiseThoseOfUniformRefinement) {
  const Problem problem = problem_file(GetParam().file, {"mesh.levels=2"});
  const Mesh control = read_control_mesh(problem, {}).mesh;
  ShellForest shell = shell_forest(problem, control);
  refine_here_and_there(shell, 3, 7);
  std::vector<Mesh> uniform;
  std::set<int> levels;
  for (const FaceId leaf : shell.forest.leaves()) {
    const auto [root, level, path] = shell.forest.ancestry(leaf);
    levels.insert(level);
    while (static_cast<int>(uniform.size()) <= level)
      uniform.push_back(refined_on_surfaces(problem, control,
                                            GetParam().before + static_cast<int>(uniform.size())));
    const Mesh& mesh = uniform[static_cast<std::size_t>(level)];
    const auto face = (static_cast<std::int64_t>(root.value) << (2 * level)) + path;
    const auto corners = mesh.topology.face(FaceId(face));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(shell.forest.nodes().position(shell.forest.corners(leaf)[i]),
                mesh.points[corners[i]])
          << face << ' ' << level;
  }
  EXPECT_GE(levels.size(), 3U);
}

TEST_P(PlacedForest, ElementsAreNotFoldedWhereTheMeshIsFine) {
  const Problem problem = problem_file(GetParam().file, {"mesh.levels=5"});
  const ShellModel model = build_shell_model(problem, read_control_mesh(problem, {}).mesh);
  for (int f = 0; f < model.mesh->topology.num_faces(); ++f) {
    const ShellQuad q = model.quad(FaceId(f));
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 normal = (q.x[(i + 1) % 4] - q.x[i]).cross(q.x[(i + 3) % 4] - q.x[i]);
      EXPECT_GT(normal.dot(q.director[(i + 2) % 4]), 0) << f;
    }
  }
}

/// Boundary edges of a part that lie in a set of points.
template <class In>
int edges_in(const Mesh& mesh, const FaceGroup& part, const In& in) {
  const Adjacency adjacency(mesh.topology);
  int n = 0;
  for (const FaceId f : part.faces)
    for (int i = 0; i < mesh.topology.face_size(f); ++i) {
      const HalfedgeId h = mesh.topology.halfedge(f, i);
      n += !adjacency.twin(h).valid() && in(mesh.points[adjacency.from(h)]) &&
           in(mesh.points[adjacency.to(h)]);
    }
  return n;
}

void expect_in_one_place(const Mesh& mesh, const std::vector<TiedEdge>& tied) {
  for (const TiedEdge& e : tied)
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(mesh.points[e.ends[i]], mesh.points[e.tied[i]]);
}

TEST(ShellForestSeams, BothSidesHaveTheSameEdges) {
  const Problem problem = problem_file("cylinder_plate_c.toml", {"mesh.levels=2"});
  ShellForest shell = shell_forest(problem, read_control_mesh(problem, {}).mesh);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    refine_here_and_there(shell, 1, seed);
    const ForestMesh mesh = forest_mesh(shell.forest, Closure::conforming);
    const auto tied = tied_edges(shell.forest, mesh, shell.seams);
    const auto on_seam = [](const Vec3& x) {
      return std::abs(x.z()) < 1e-9 && std::max(std::abs(x.x()), std::abs(x.y())) < 14;
    };
    for (const FaceGroup& part : mesh.mesh.parts)
      EXPECT_EQ(edges_in(mesh.mesh, part, on_seam), static_cast<int>(tied.size())) << part.name;
    expect_in_one_place(mesh.mesh, tied);
    EXPECT_GT(tied.size(), 32U);
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

const std::string steel_shell = R"([mesh]
file = "m.obj"
scheme = "linear"
levels = 1
[model]
kind = "mitc4"
[material]
young = 12e6
poisson = 0
thickness = 0.01
)";

TEST(ShellForestSeams, ThreePartsMeetWithTheSameEdges) {
  const Problem problem = parse_problem(steel_shell + R"([[support]]
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
  for (unsigned seed = 1; seed <= 5; ++seed) {
    refine_here_and_there(shell, 1, seed);
    const ForestMesh mesh = forest_mesh(shell.forest, Closure::conforming);
    const auto tied = tied_edges(shell.forest, mesh, shell.seams);
    const auto on_seam = [](const Vec3& x) { return x.x() == 0 && x.z() == 0; };
    for (const FaceGroup& part : mesh.mesh.parts)  // each tied to both others
      EXPECT_EQ(3 * edges_in(mesh.mesh, part, on_seam), static_cast<int>(tied.size()));
    expect_in_one_place(mesh.mesh, tied);
    const ShellModel model = shell_model_on(problem, mesh.mesh, tied);
    for (const SolutionCheck& c : check_solution(model, solve_shell(model)))
      EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  }
}

/// Estimated error as a part of the energy norm: recovered, by residuals.
std::array<double, 2> estimated_parts(const ShellModel& model) {
  const ShellSolution solution = solve_shell(model);
  std::array<double, 2> out{};
  std::size_t i = 0;
  for (const auto& squares : {estimate_error(model, solution), residual_estimate(model, solution)})
    out[i++] = std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) /
                         (2 * solution.strain_energy));
  return out;
}

// Uniform stretch in x of two materials side by side: membrane forces jump where they meet.
TEST(ShellError, VanishesForUniformStretchOfTwoMaterials) {
  const Mesh mesh = testing::grid(6, 4, [](const Vec2& p) {
    return Vec2(p.x() + 0.1 * std::sin(9 * p.y()) * p.x() * (1 - p.x()), p.y());
  });
  const Problem problem = parse_problem(R"([mesh]
file = "m.obj"
scheme = "linear"
[model]
kind = "mitc4"
[[material]]
young = 1
poisson = 0
[[material]]
where = "y >= 0.5"
young = 4
poisson = 0
[[support]]
where = "x == 0"
fix = ["ux", "uz", "rx", "ry"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == 1"
force_per_length = ["y > 0.5 ? 4 : 1", 0, 0]
)",
                                        "p.toml");
  for (const double part : estimated_parts(build_shell_model(problem, mesh)))
    EXPECT_LT(part, 1e-10);
}

// Three plates meet; two of them are pulled, the force goes past the third.
TEST(ShellError, VanishesForStretchPastAThirdPlate) {
  const Problem problem = parse_problem(steel_shell + R"([[support]]
where = "x == -1"
kind = "clamped"
[[seam]]
parts = ["left", "right", "wall"]
[[load]]
where = "x == 1"
force_per_length = [3, 0, 0]
)",
                                        "p.toml");
  for (const double part : estimated_parts(build_shell_model(problem, tee())))
    EXPECT_LT(part, 1e-9);
}

// Constant curvature on a distorted mesh, all of whose border is held; where it is free, moments are missing.
TEST(ShellError, OfConstantCurvatureIsZeroUnlessTheBorderIsFree) {
  const Mesh mesh = testing::grid(5, 4, [](const Vec2& p) {
    return Vec2(p.x() + 0.1 * std::sin(9 * p.y()) * p.x() * (1 - p.x()),
                p.y() + 0.1 * std::sin(5 * p.x()) * p.y() * (1 - p.y()));
  });
  for (const char* held : {"boundary", "vertex:0"}) {
    const Problem problem =
        parse_problem(steel_shell + "[[support]]\nwhere = \"" + held +
                          "\"\nfix = [\"ux\", \"uy\", \"uz\", \"rx\", \"ry\"]\n",
                      "p.toml", std::vector<std::string>{"material.poisson=0.3"});
    const ShellModel model = build_shell_model(problem, mesh);
    ShellSolution solution;
    solution.u = VectorX::Zero(model.num_unknowns());
    for (int v = 0; v < model.mesh->points.size(); ++v) {  // w = x^2 + 3 x y - 2 y^2
      const Vec3 x = model.mesh->points[VertexId(v)];
      solution.u.segment<6>(6 * v) << 0, 0, x.x() * x.x() + 3 * x.x() * x.y() - 2 * x.y() * x.y(),
          3 * x.x() - 4 * x.y(), -2 * x.x() - 3 * x.y(), 0;
    }
    const double norm = std::sqrt(solution.u.dot(shell_matrix(model) * solution.u));
    const auto squares = residual_estimate(model, solution);
    const double part = std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0)) / norm;
    if (std::string(held) == "boundary") {
      EXPECT_LT(part, 1e-9);
    } else {
      EXPECT_GT(part, 0.1);
    }
  }
}

// Hoop force of a cylinder under pressure: constant along the surface, turning from facet to facet. Facets
// have a little shear besides, because directors are not normal to them; its stiffness is taken out.
TEST(ShellError, VanishesForACylinderUnderPressure) {
  for (const char* levels : {"mesh.levels=2", "mesh.levels=3"}) {
    const Problem problem = parse_problem(R"([mesh]
file = "roof.obj"
scheme = "linear"
levels = 3
placement = "exact"
[geometry]
kind = "cylinder"
axis = [0, 1, 0]
radius = 25
[model]
kind = "mitc4"
shear_factor = 1e-8
[material]
young = 10
poisson = 0
thickness = 0.25
[[support]]
where = "y == 0"
kind = "symmetry"
[[support]]
where = "x == 0"
kind = "symmetry"
[[support]]
where = "25 * sin(2 * pi / 9) == x"
kind = "symmetry"
[[load]]
where = "all"
pressure = -1
)",
                                          std::filesystem::path(LIMES_DATA_DIR) / "p.toml",
                                          std::vector<std::string>{levels});
    for (const double part : estimated_parts(read_shell_model(problem)))
      EXPECT_LT(part, 2e-5) << levels;
  }
}

ShellResult adapted(const std::string& file, const char* energy, std::vector<std::string> more) {
  more.push_back(std::string("adapt.reference_energy=") + energy);
  ShellResult result = run_shell_problem(problem_file(file, more));
  for (const SolutionCheck& c : result.checks)
    EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  return result;
}

TEST(ShellError, IsTheErrorOnUniformMeshes) {
  for (const auto& [file, energy] :
       {std::pair("hole_5.toml", "1401.0685"), std::pair("hole_2_5.toml", "1260.10622")})
    for (const char* levels : {"mesh.levels=1", "mesh.levels=2", "mesh.levels=3"}) {
      const ShellResult r =
          adapted(file, energy, {levels, "adapt.max_steps=1", "adapt.max_dofs=20000"});
      EXPECT_NEAR(*r.adaptive->history.steps.front().effectivity, 1, 0.06) << file << levels;
    }
}

/// Twice the energy of what a solution on the unit square under the pressure sin(pi x) sin(pi y) lacks to
/// Navier's series, which has one term here and holds for thick plates as well; poisson 0.3.
double plate_error_square(const ShellModel& model, const ShellSolution& solution) {
  constexpr double pi = std::numbers::pi, nu = 0.3;
  double sum = 0;
  for (int f = 0; f < model.mesh->topology.num_faces(); ++f) {
    const ShellQuad quad = model.quad(FaceId(f));
    const ShellSection section = model.section(FaceId(f));
    const double t = section.thickness;
    const double shearing = section.shear_factor * section.young / (2 * (1 + nu)) * t;
    for (const double r : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)})
      for (const double q : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
        const Vec2 rs(r, q);
        const ShellResultants here =
            mitc4_resultants(quad, section, model.unknowns(FaceId(f), solution.u), rs);
        const Vec3 x = quad.position(rs);
        const double sx = std::sin(pi * x.x()), cx = std::cos(pi * x.x());
        const double sy = std::sin(pi * x.y()), cy = std::cos(pi * x.y());
        Mat3 M = Mat3::Zero();
        M(0, 0) = M(1, 1) = (1 + nu) * sx * sy;
        M(0, 1) = M(1, 0) = -(1 - nu) * cx * cy;
        const Mat3 dM = M / (4 * pi * pi) - here.bending;
        const Vec3 dQ = Vec3(cx * sy, sx * cy, 0) / (2 * pi) - here.shear;
        sum += quad.area_normal(rs).norm() *
               (12 / (section.young * t * t * t) *
                    ((1 + nu) * dM.squaredNorm() - nu * dM.trace() * dM.trace()) +
                dQ.squaredNorm() / shearing);
      }
  }
  return sum;
}

constexpr const char* sine_plate = R"toml(
[mesh]
file = "plate.obj"
scheme = "linear"
levels = 4
placement = "exact"
[geometry]
kind = "plane"
axis = [0, 0, 1]
[model]
kind = "mitc4"
[material]
young = 1e6
poisson = 0.3
thickness = 0.01
[[support]]
where = "boundary"
kind = "supported"
rotation = "hard"
[[load]]
where = "all"
force_per_area = [0, 0, "sin(pi * x) * sin(pi * y)"]
)toml";

/// The unit square of 2 x 2 faces, which are no parallelograms if the inner vertex is shifted.
Mesh plate_of_four(double shift) {
  Mesh plate = shapes::grid(2, 2);
  for (int v = 0; v < plate.points.size(); ++v)
    plate.points[VertexId(v)] /= 2;
  plate.points[VertexId(4)] += Vec3(shift / 2, shift / 4, 0);
  return plate;
}

double sum(const std::vector<double>& squares) {
  return std::accumulate(squares.begin(), squares.end(), 0.0);
}

// Bending of a plate, whose moments are known: the estimate is the error of the resultants. The difference
// of the energies is not, it is four times its square: shear strains are assumed ones.
TEST(ShellError, IsThatOfTheMomentsOfAPlate) {
  for (const double shift : {0.0, 0.3}) {
    const ShellModel model =
        build_shell_model(parse_problem(sine_plate, "p.toml"), plate_of_four(shift));
    const ShellSolution solution = solve_shell(model);
    const double estimate = sum(estimate_error(model, solution));
    const double error = plate_error_square(model, solution);
    EXPECT_NEAR(std::sqrt(estimate / error), 1, 0.03) << shift;
    // w in the middle is 1 / (4 pi^4 D) + 1 / (2 pi^2 k G t)
    constexpr double exact_energy = 0.0035052422;
    EXPECT_GT(2 * (exact_energy - solution.strain_energy) / error, 3) << shift;
  }
}

/// A quarter of the leaves split, here and there.
ShellForest split_plate(const Problem& problem, double shift) {
  ShellForest shell = shell_forest(problem, plate_of_four(shift));
  std::mt19937 random(1);
  std::vector<FaceId> marked;
  for (const FaceId leaf : shell.forest.leaves())
    if (random() % 4 == 0) marked.push_back(leaf);
  shell.forest.refine(marked);
  return shell;
}

// The same with hanging nodes: both estimates stay the error.
TEST(ShellError, IsThatOfTheMomentsOfAPlateWithHangingNodes) {
  const Problem problem =
      parse_problem(std::string(sine_plate) + "[adapt]\nclosure = \"hanging\"\n", "p.toml");
  for (const double shift : {0.0, 0.3}) {
    ShellForest shell = split_plate(problem, shift);
    const ForestMesh mesh = forest_mesh(shell.forest, Closure::hanging);
    ASSERT_GT(mesh.hanging.size(), 100U);
    const ShellModel model = shell_model_on(problem, mesh.mesh, {}, mesh.hanging);
    const ShellSolution solution = solve_shell(model);
    const double error = plate_error_square(model, solution);
    EXPECT_NEAR(std::sqrt(sum(estimate_error(model, solution)) / error), 1, 0.03) << shift;
    EXPECT_NEAR(std::sqrt(sum(residual_estimate(model, solution)) / error), 1, 0.06) << shift;
  }
}

// On the same leaves, and with families of four, the residuals of both closures differ as their errors do: that
// of the conforming one has more elements.
TEST(ShellError, ResidualsOfBothClosuresAreThatOfTheMomentsOfAPlate) {
  const Problem problem = parse_problem(sine_plate, "p.toml");
  for (const double shift : {0.0, 0.3}) {
    ShellForest shell = split_plate(problem, shift);
    std::array<double, 2> effectivity{}, estimate{};
    std::size_t i = 0;
    for (const Closure closure : {Closure::hanging, Closure::conforming}) {
      const ForestMesh mesh = forest_mesh(shell.forest, closure);
      const ShellModel model = shell_model_on(problem, mesh.mesh, {}, mesh.hanging);
      const ShellSolution solution = solve_shell(model);
      estimate.at(i) = std::sqrt(sum(residual_estimate(model, solution)));
      effectivity.at(i) = estimate.at(i) / std::sqrt(plate_error_square(model, solution));
      ++i;
    }
    EXPECT_GT(estimate[0], 1.1 * estimate[1]);
    EXPECT_NEAR(effectivity[0] / effectivity[1], 1, 0.06) << shift << ' ' << effectivity[0];
  }
}

// A finer solution finds of the error with hanging nodes what it finds without.
TEST(ShellError, AgainstAFinerSolutionWithHangingNodes) {
  const Problem problem =
      parse_problem(std::string(sine_plate) + "[adapt]\nclosure = \"hanging\"\n", "p.toml",
                    std::vector<std::string>{"mesh.levels=3"});
  for (const double shift : {0.0, 0.3}) {
    ShellForest shell = split_plate(problem, shift);
    const ForestMesh mesh = forest_mesh(shell.forest, Closure::hanging);
    ASSERT_GT(mesh.hanging.size(), 20U);
    const ShellModel model = shell_model_on(problem, mesh.mesh, {}, mesh.hanging);
    const ShellSolution solution = solve_shell(model);
    const double error = plate_error_square(model, solution);
    for (int levels = 1; levels <= 2; ++levels) {
      const ShellModel finer = finer_model(model, shell, {}, mesh, levels);
      EXPECT_GT(std::count(finer.hangs.begin(), finer.hangs.end(), 1), mesh.hanging.size());
      const double found = sum(error_against(finer, solve_shell(finer), levels, model, solution));
      EXPECT_NEAR(found / error, 1 - std::pow(4.0, -levels), 0.02) << shift << ' ' << levels;
    }
  }
}

// Errors of first order, seen from a solution whose error is 2^-N of them and orthogonal to the difference:
// sqrt(1 - 4^-N) of the error is found.
TEST(ShellError, AgainstAFinerSolutionIsThatOfTheMomentsOfAPlate) {
  for (const double shift : {0.0, 0.3}) {
    const Problem problem =
        parse_problem(sine_plate, "p.toml", std::vector<std::string>{"mesh.levels=3"});
    ShellForest shell = shell_forest(problem, plate_of_four(shift));
    const ForestMesh mesh = forest_mesh(shell.forest, Closure::conforming);
    const ShellModel model = shell_model_on(problem, mesh.mesh, {});
    const ShellSolution solution = solve_shell(model);
    const double error = plate_error_square(model, solution);
    for (int levels = 1; levels <= 3; ++levels) {
      const ShellModel finer = finer_model(model, shell, {}, mesh, levels);
      const double found = sum(error_against(finer, solve_shell(finer), levels, model, solution));
      EXPECT_NEAR(found / error, 1 - std::pow(4.0, -levels), 0.01) << shift << ' ' << levels;
    }
  }
}

// The aim of both estimates, in the norm that they are of: on roofs, where the difference of the energies is
// no measure because MITC4's energy is no bound, and in bending, where it is four times the square.
TEST(ShellError, IsThatAgainstAFinerSolution) {
  for (const auto& [file, more] :
       {std::pair("hole_5.toml", "adapt.mark=doerfler"),
        std::pair("hole_5.toml", "adapt.mark=maximum"), std::pair("hole_2_5.toml", "mesh.levels=1"),
        std::pair("cylinder_plate_c.toml", "mesh.levels=2")})
    for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
      const ShellResult r = run_shell_problem(
          problem_file(file, {more, "adapt.max_dofs=6000", "adapt.reference_levels=1",
                              std::string("adapt.estimator=") + estimator}));
      EXPECT_EQ(r.adaptive->finer_squares.size(), r.adaptive->squares.size());
      for (const AdaptStep& s : r.adaptive->history.steps) {
        const double found = std::sqrt(0.75);  // of the error
        EXPECT_GT(*s.finer_effectivity * found, 0.85) << file << ' ' << estimator << s.dofs;
        EXPECT_LT(*s.finer_effectivity * found, 1.25) << file << ' ' << estimator << s.dofs;
      }
    }
}

// Of the moments of a plate the residuals find the error, with its order.
TEST(ShellError, ResidualsAreThatOfTheMomentsOfAPlate) {
  for (const double shift : {0.0, 0.3}) {
    double coarser = 0;
    for (const char* levels : {"mesh.levels=3", "mesh.levels=4", "mesh.levels=5"}) {
      const ShellModel model =
          build_shell_model(parse_problem(sine_plate, "p.toml", std::vector<std::string>{levels}),
                            plate_of_four(shift));
      const ShellSolution solution = solve_shell(model);
      const double estimate = std::sqrt(sum(residual_estimate(model, solution)));
      EXPECT_NEAR(estimate / std::sqrt(plate_error_square(model, solution)), 1, 0.03) << shift;
      if (coarser > 0) {
        EXPECT_NEAR(std::log2(coarser / estimate), 1, 0.03) << shift;
      }
      coarser = estimate;
    }
  }
}

// Both estimates find the error in the same places.
TEST(ShellError, BothMarkTheSameElements) {
  const ShellModel model = read_shell_model(problem_file("hole_2_5.toml", {"mesh.levels=3"}));
  const ShellSolution solution = solve_shell(model);
  const std::vector<double> recovered = estimate_error(model, solution);
  const std::vector<double> residual = residual_estimate(model, solution);
  const auto seen_by = [](const std::vector<double>& squares, const std::vector<double>& by) {
    double part = 0;
    for (const int i : marked(by, MarkingKind::doerfler, 0.5))
      part += squares[static_cast<std::size_t>(i)] / sum(squares);
    return part;
  };
  EXPECT_GT(seen_by(recovered, residual), 0.35);
  EXPECT_GT(seen_by(residual, recovered), 0.5);
  for (const auto& squares : {recovered, residual})  // few of 2048
    EXPECT_LT(marked(squares, MarkingKind::doerfler, 0.5).size(), 100U);
}

TEST(AdaptiveShell, RoofWithAHoleComesToTheLimitOfTheTheory) {
  const ShellResult r = adapted("hole_5.toml", "1401.0685",
                                {"adapt.max_dofs=40000", "adapt.mark=maximum", "adapt.share=0.2"});
  for (const AdaptStep& s : r.adaptive->history.steps) {
    EXPECT_GT(*s.effectivity, 0.7) << s.dofs;
    EXPECT_LT(*s.effectivity, 1.5) << s.dofs;
  }
  EXPECT_NEAR(r.solution.strain_energy / 1401.0685, 1, 0.0005);
  EXPECT_EQ(r.adaptive->history.end, "max_dofs");
  EXPECT_EQ(r.adaptive->squares.size(),
            static_cast<std::size_t>(r.model.mesh->topology.num_faces()));
  const AdaptStep& first = r.adaptive->history.steps.front();
  const ShellResult uniform = run_shell_problem(problem_file("hole_5.toml", {}));
  EXPECT_EQ(first.dofs, uniform.solution.num_unknowns);
  EXPECT_NEAR(first.strain_energy / uniform.solution.strain_energy, 1, 1e-10);
}

TEST(AdaptiveShell, SmallHoleTakesAThirdOfTheUnknowns) {
  const double limit = 1260.10622;
  const ShellSolution uniform =
      run_shell_problem(problem_file("hole_2_5.toml", {"mesh.levels=4"})).solution;
  const ShellResult r = adapted("hole_2_5.toml", "1260.10622",
                                {"adapt.max_dofs=" + std::to_string(uniform.num_unknowns / 3)});
  EXPECT_LT(std::abs(limit - r.solution.strain_energy), limit - uniform.strain_energy);
  EXPECT_LE(3 * r.solution.num_unknowns, uniform.num_unknowns);
}

TEST(AdaptiveShell, SeamIsRefinedOnBothSides) {
  const ShellResult r =
      adapted("cylinder_plate_c.toml", "10.21295", {"mesh.levels=2", "adapt.max_dofs=20000"});
  EXPECT_NEAR(r.solution.strain_energy / 10.21295, 1, 0.01);
  EXPECT_GT(r.solution.num_kink_nodes, 64);  // of 32 before the first step
}

std::string message_of(const Problem& problem, const Mesh& mesh) {
  try {
    (void)shell_forest(problem, mesh);
  } catch (const UsageError& error) {  // of an override
    return error.what();
  }
  return "no error";
}

TEST(AdaptiveShell, ErrorsNameWhatIsMissing) {
  const Problem plate = problem_file("cylinder_plate_c.toml", {"mesh.levels=1"});
  EXPECT_EQ(message_of(plate, read_control_mesh(plate, {}).mesh)
                .find("--set mesh.levels: [adapt] needs levels of 2 or more"),
            0U);
}

}  // namespace
}  // namespace limes
