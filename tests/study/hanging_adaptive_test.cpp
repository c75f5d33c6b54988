// Adaptive refinement with hanging vertices, against exact solutions, Reissner-Mindlin solutions of high order
// (data/SOURCES.md) and finer solutions.

#include <gtest/gtest.h>

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "convergence/plane_meshes.h"
#include "limes/core/error.h"
#include "limes/study/adaptive.h"
#include "limes/study/poisson_conditions.h"
#include "limes/study/run.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

Problem problem_file(const std::string& name, std::vector<std::string> overrides) {
  overrides.emplace_back("adapt.closure=hanging");
  return read_problem(std::filesystem::path(LIMES_DATA_DIR) / name, overrides);
}

double unknowns_for(const std::vector<AdaptStep>& steps, double error) {
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double a = *steps[i - 1].true_error, b = *steps[i].true_error;
    if (a < error || b > error) continue;
    const double part = std::log(a / error) / std::log(a / b);
    return steps[i - 1].dofs *
           std::pow(static_cast<double>(steps[i].dofs) / steps[i - 1].dofs, part);
  }
  return 0;
}

TEST(HangingAdaptive, LShapeHasTheOptimalRate) {
  const double norm = std::sqrt(2 * 0.91811333093758);
  const auto steps = [](const Problem& problem) {
    return run_poisson_problem(problem).adaptive->history.steps;
  };
  const auto uniform = steps(problem_file(
      "l_shape.toml", {"adapt.mark=fraction", "adapt.share=1", "adapt.max_dofs=15000"}));
  for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
    const auto own =
        steps(problem_file("l_shape.toml", {fmt::format("adapt.estimator={}", estimator)}));
    const AdaptStep &last = own.back(), &before = own[own.size() - 4];
    const double rate = std::log(*before.true_error / *last.true_error) /
                        std::log(static_cast<double>(last.dofs) / before.dofs);
    EXPECT_NEAR(rate, 0.5, 0.04) << estimator;
    EXPECT_NEAR(*last.effectivity, 1, 0.1) << estimator;
    for (const AdaptStep& s : own)
      EXPECT_NEAR(*s.effectivity, 1.1, 0.4) << estimator << s.dofs;
    EXPECT_LT(3 * unknowns_for(own, 0.02 * norm), unknowns_for(uniform, 0.02 * norm)) << estimator;
  }
}

ShellResult adapted(const std::string& file, const char* energy, std::vector<std::string> more) {
  more.push_back(std::string("adapt.reference_energy=") + energy);
  ShellResult result = run_shell_problem(problem_file(file, more));
  for (const SolutionCheck& c : result.checks)
    EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  return result;
}

TEST(HangingAdaptive, ResultsDoNotDependOnTheNumberOfThreads) {
  const auto run = [](std::size_t threads) {
#ifdef LIMES_WITH_TBB
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#else
    (void)threads;
#endif
    const ShellResult result = adapted("hole_5.toml", "1401.0685",
                                       {"adapt.max_dofs=3000", "adapt.estimator=residual",
                                        "adapt.reference_levels=1", "mesh.smoothing=10"});
    return result_json(result, false).dump();
  };
  const std::string one = run(1);
  EXPECT_EQ(run(4), one);
}

std::string refusal(const std::string& adapt) {
  try {
    (void)parse_problem(std::string("[mesh]\nfile = \"m.obj\"\nscheme = \"linear\"\n") + R"([model]
kind = "mitc4"
[material]
young = 1
poisson = 0
thickness = 1
[[support]]
where = "x == 0"
kind = "clamped"
[adapt]
)" + adapt,
                        "p.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(HangingAdaptive, ErrorsNameTheLine) {
  EXPECT_EQ(refusal("closure = \"hanging\"\n"), "no error");
  EXPECT_EQ(refusal("closure = \"triangles\"\n").find("p.toml:14: [adapt] closure"), 0U)
      << refusal("closure = \"triangles\"\n");
}

TEST(HangingAdaptive, EveryReportIsWritten) {
  const auto names_of = [](const auto& result) {
    std::vector<std::string> names;
    for (const ReportFile& file : report_files(result))
      names.push_back(file.name);
    std::string vtu;
    write_result_vtu([&](std::string_view bytes) { vtu += bytes; }, result);
    EXPECT_NE(vtu.find("</VTKFile>"), std::string::npos);
    return names;
  };
  const auto has_mesh = [](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), "adapted-mesh.png") != names.end();
  };
  EXPECT_TRUE(has_mesh(names_of(run_problem(problem_file("cook.toml", {"adapt.max_dofs=300"})))));
  EXPECT_TRUE(has_mesh(
      names_of(run_poisson_problem(problem_file("l_shape.toml", {"adapt.max_dofs=100"})))));
  EXPECT_TRUE(
      has_mesh(names_of(run_shell_problem(problem_file("hole_5.toml", {"adapt.max_dofs=1000"})))));
}

// Faces tagged as holes are as if they were not there, split or beside split ones; leaves are marked by
// estimates, so these agree as well.
TEST(HangingAdaptive, HolesAreNotThere) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "limes_hanging";
  std::filesystem::create_directories(folder);
  std::string vertices, faces, others;
  std::vector<int> holes;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i)
      vertices += fmt::format("v {} {} 0\n", i, j);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int v = 5 * j + i + 1;
      const std::string face = fmt::format("f {} {} {} {}\n", v, v + 1, v + 6, v + 5);
      faces += face;
      if ((i == 1 && j > 0 && j < 3) || (i == 3 && j == 0))
        holes.push_back(4 * j + i);
      else
        others += face;
    }
  std::string tags;
  for (const int f : holes)
    tags += fmt::format("t hole 1/0/0 {}\n", f);
  std::ofstream(folder / "tagged.obj") << vertices << faces << tags;
  std::ofstream(folder / "without.obj") << vertices << others;
  for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
    const auto steps_on = [&](const char* mesh) {
      return run_problem(parse_problem(fmt::format(R"([mesh]
file = "{}.obj"
scheme = "linear"
[model]
kind = "plane-stress"
[material]
young = 10
poisson = 0.25
thickness = 0.5
[[support]]
where = "x == 0"
fix = ["ux", "uy"]
[[load]]
where = "x == 4"
force_per_length = [1, -2]
[[load]]
where = "x == 1 and y >= 1 and y <= 3"
pressure = 3
[adapt]
closure = "hanging"
estimator = "{}"
max_dofs = 700
reference_levels = 1
)",
                                                   mesh, estimator),
                                       folder / "p.toml"))
          .adaptive->history.steps;
    };
    const auto tagged = steps_on("tagged"), without = steps_on("without");
    ASSERT_EQ(tagged.size(), without.size()) << estimator;
    ASSERT_GT(tagged.size(), 3U);
    for (std::size_t i = 0; i < tagged.size(); ++i) {
      EXPECT_EQ(tagged[i].dofs, without[i].dofs);
      EXPECT_NEAR(tagged[i].strain_energy / without[i].strain_energy, 1, 1e-9);
      EXPECT_NEAR(tagged[i].error_estimate / without[i].error_estimate, 1, 1e-9);
      EXPECT_NEAR(*tagged[i].finer_error / *without[i].finer_error, 1, 1e-9);
    }
  }
}

/// The grid [0, 4]^2 with two holes that meet in its middle.
Mesh holes_that_meet(FaceId a, FaceId b) {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return Vec2(4 * p); });
  mesh.tags.holes = {a, b};
  return mesh;
}

/// All faces but holes are split twice: vertices hang in the sides of holes only.
ForestMesh split_between_holes(const Problem& problem, const Mesh& control) {
  Forest forest = plane_forest(problem, control, find_scheme("linear"));
  for (int level = 0; level < 2; ++level) {
    std::vector<FaceId> wanted;
    for (const FaceId leaf : forest.leaves()) {
      const std::vector<FaceId>& holes = control.tags.holes;
      if (std::find(holes.begin(), holes.end(), forest.ancestry(leaf).root) == holes.end())
        wanted.push_back(leaf);
    }
    forest.refine(wanted);
  }
  return forest_mesh(forest, Closure::hanging);
}

VertexId vertex_at(const PlaneModel& model, const Vec3& x) {
  const auto& points = model.mesh().points.vector();
  return VertexId(std::find(points.begin(), points.end(), x) - points.begin());
}

const std::string grid_file = "[mesh]\nfile = \"m.obj\"\nscheme = \"linear\"\n";

// What hangs in the sides of holes is not there, so these are the values of the conforming mesh that is split
// everywhere. In the middle elements meet in one vertex only, and holes come first or last around it.
TEST(HangingAdaptive, ValuesWhereHolesMeetAreThoseOfTheConformingMesh) {
  const Vec3 middle(2, 2, 0);
  for (const auto& [a, b] : {std::pair(FaceId(5), FaceId(10)), std::pair(FaceId(6), FaceId(9))}) {
    const Mesh control = holes_that_meet(a, b);
    const auto models = [&](const std::string& text) {
      const std::string hanging = text + "[adapt]\nclosure = \"hanging\"\n";
      const Problem problem = parse_problem(grid_file + hanging, "p.toml");
      const ForestMesh forest = split_between_holes(problem, control);
      EXPECT_GT(forest.hanging.size(), 7U);
      return std::pair(
          build_model(problem, forest.mesh, forest.hanging),
          build_model(parse_problem(grid_file + "levels = 2\n" + text, "p.toml"), control));
    };
    const auto [heat, heat_conforming] = models(R"([model]
kind = "poisson"
[material]
conductivity = 3
[[support]]
where = "x == 0"
value = "y"
[[support]]
where = "x == 2 and y == 2"
value = 5
[[load]]
where = "all"
source = 1
)");
    const PoissonSolution u = solve_poisson(heat), v = solve_poisson(heat_conforming);
    EXPECT_EQ(u.num_unknowns, v.num_unknowns);
    EXPECT_NEAR(u.strain_energy / v.strain_energy, 1, 1e-11);
    EXPECT_EQ(u.u(dof_of_vertex(*heat.space, vertex_at(heat, middle))), 5);
    EXPECT_NEAR(u.reactions[1].flux / v.reactions[1].flux, 1, 1e-11);

    const auto [sheet, sheet_conforming] = models(R"([model]
kind = "plane-stress"
[material]
young = 10
poisson = 0.25
[[support]]
where = "x == 0"
fix = ["ux", "uy"]
[[support]]
where = "x == 2 and y == 2"
fix = ["uy"]
[[load]]
where = "x == 2 and y == 2"
force = [1, 0]
[[load]]
where = "x == 4"
force_per_length = [0, 1]
)");
    const PlaneSolution d = solve_plane(sheet), e = solve_plane(sheet_conforming);
    EXPECT_EQ(d.num_unknowns, e.num_unknowns);
    EXPECT_NEAR(d.strain_energy / e.strain_energy, 1, 1e-11);
    EXPECT_NEAR(d.loads(0), 1, 1e-12);
    const auto moved = [&](const PlaneModel& model, const PlaneSolution& s) {
      return s.u(2 * dof_of_vertex(*model.space, vertex_at(model, middle)));
    };
    EXPECT_NEAR(moved(sheet, d) / moved(sheet_conforming, e), 1, 1e-11);
    EXPECT_NEAR(d.reactions[1].force(1) / e.reactions[1].force(1), 1, 1e-11);
  }
}

// Where a force acts on a point no mesh is fine enough.
TEST(HangingAdaptive, FinerSolutionsHaveRoomBelowTheLeaves) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "limes_hanging_deep";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "square.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  for (const int levels : {0, 1}) {
    const PlaneResult r = run_problem(parse_problem(fmt::format(R"([mesh]
file = "square.obj"
scheme = "linear"
[model]
kind = "plane-stress"
[material]
young = 10
poisson = 0.25
[[support]]
where = "x == 1"
fix = ["ux", "uy"]
[[load]]
where = "x == 0 and y == 0"
force = [1, 0]
[adapt]
closure = "hanging"
mark = "maximum"
share = 0.9
max_dofs = 2000
max_steps = 60
reference_levels = {}
)",
                                                                levels),
                                                    folder / "p.toml"));
    EXPECT_EQ(r.adaptive->history.end, "max_level");
    EXPECT_EQ(r.adaptive->deepest_level, Forest::max_level - levels);
    double smallest = 1;  // of the sides, which were halved level by level
    const Adjacency& a = r.model.space->geometry().adjacency();
    for (int h = 0; h < a.topology().num_corners(); ++h)
      smallest = std::min(smallest, (r.model.mesh().points[a.from(HalfedgeId(h))] -
                                     r.model.mesh().points[a.to(HalfedgeId(h))])
                                        .norm());
    EXPECT_EQ(smallest, std::ldexp(1.0, levels - Forest::max_level));
  }
}

TEST(HangingAdaptive, RoofWithAHoleComesToTheLimitOfTheTheory) {
  const ShellResult r = adapted("hole_5.toml", "1401.0685",
                                {"adapt.max_dofs=40000", "adapt.mark=maximum", "adapt.share=0.2"});
  EXPECT_NEAR(r.solution.strain_energy / 1401.0685, 1, 0.0005);
}

TEST(HangingAdaptive, SmallHoleHasTheErrorThatIsEstimated) {
  const ShellResult r = adapted("hole_2_5.toml", "1260.10622",
                                {"adapt.max_dofs=40000", "adapt.mark=maximum", "adapt.share=0.2"});
  for (const AdaptStep& s : r.adaptive->history.steps)
    EXPECT_NEAR(*s.effectivity, 1.1, 0.4) << s.dofs;
}

// Both estimates are of the error against a finer solution, which finds sqrt(3/4) of the error. Residuals see
// the transverse shear that oscillates between few, large elements of the plate, though it has little energy.
TEST(HangingAdaptive, ErrorsOfShellsAreThoseAgainstAFinerSolution) {
  for (const auto& [file, more] : {std::pair("hole_2_5.toml", "mesh.levels=1"),
                                   std::pair("cylinder_plate_c.toml", "mesh.levels=2"),
                                   std::pair("hole_5.toml", "mesh.smoothing=20")})
    for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
      const ShellResult r = run_shell_problem(
          problem_file(file, {more, "adapt.max_dofs=6000", "adapt.reference_levels=1",
                              std::string("adapt.estimator=") + estimator}));
      EXPECT_GT(r.adaptive->history.steps.size(), 1U);
      const bool shear = file[0] == 'c' && estimator[0] == 'r';
      for (const AdaptStep& s : r.adaptive->history.steps)
        EXPECT_NEAR(*s.finer_effectivity * std::sqrt(0.75), 1, shear ? 0.35 : 0.2)
            << file << estimator << s.dofs;
    }
}

TEST(HangingAdaptive, ErrorsOfPlaneProblemsAreThoseAgainstAFinerSolution) {
  const PoissonResult r = run_poisson_problem(
      problem_file("l_shape.toml", {"adapt.max_dofs=2000", "adapt.reference_levels=2"}));
  for (const AdaptStep& s : r.adaptive->history.steps)
    EXPECT_NEAR(*s.finer_error / *s.true_error, 0.95, 0.05) << s.dofs;  // 0.92 of the singularity
  const PlaneResult cook =
      run_problem(problem_file("cook.toml", {"adapt.max_dofs=1000", "adapt.reference_levels=2"}));
  EXPECT_NEAR(*cook.adaptive->history.steps.back().finer_effectivity, 1.1, 0.2);
}

// From one level, of which the conforming closure cannot start.
TEST(HangingAdaptive, CylinderOnAPlateHasTheErrorThatIsEstimated) {
  const ShellResult r =
      adapted("cylinder_plate_c.toml", "10.21295", {"mesh.levels=1", "adapt.max_dofs=12000"});
  for (const AdaptStep& s : r.adaptive->history.steps)
    EXPECT_NEAR(*s.effectivity, 1.1, 0.4) << s.dofs;
}

}  // namespace
}  // namespace limes
