// Error estimation and the adaptive loop, on problems whose exact solutions are known.

#include <gtest/gtest.h>

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <set>

#include "limes/adapt/zienkiewicz_zhu.h"
#include "limes/study/run.h"
#include "study/solved.h"

namespace limes {
namespace {

double total(const std::vector<double>& squares) {
  return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
}

/// Distorted quads on [0, 2] x [0, 1] with a line of edges at x = 1.
Mesh two_halves(int n) {
  return testing::grid(2 * n, n, [](const Vec2& p) {
    const double bend = 0.1 * std::sin(2 * std::numbers::pi * p.x()) * std::sin(3 * p.y());
    return Vec2(2 * p.x() + bend, p.y() + 0.05 * std::sin(std::numbers::pi * p.y()) * p.x());
  });
}

const std::string poisson_of_two = R"(scheme = "linear"
[model]
kind = "poisson"
[[material]]
conductivity = 1
[[material]]
where = "x >= 1"
conductivity = 4
[[support]]
where = "boundary"
value = )";

struct SolvedPoisson {
  PlaneModel model;
  PoissonSolution solution;
};

SolvedPoisson solve_scalar(const std::string& text, Mesh mesh) {
  SolvedPoisson s{build_model(problem_of(text), std::move(mesh)), {}};
  s.solution = solve_poisson(s.model);
  for (const SolutionCheck& c : check_solution(s.model, s.solution))
    EXPECT_TRUE(c.passed()) << c.name << ' ' << c.value;
  return s;
}

const char* const by_residual = "[adapt]\nestimator = \"residual\"\n";

class EveryEstimate : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Estimators, EveryEstimate, ::testing::Values("", by_residual),
                         [](const auto& param) {
                           return std::string(param.index == 0 ? "recovery" : "residual");
                         });

TEST_P(EveryEstimate, VanishesForALinearSolution) {
  const SolvedPoisson s = solve_scalar(R"(scheme = "linear"
[model]
kind = "poisson"
[material]
conductivity = 3
[[support]]
where = "boundary"
value = "2 + 3 * x - y"
)" + GetParam(),
                                       two_halves(4));
  EXPECT_NEAR(s.solution.strain_energy, 0.5 * 3 * 10 * 2, 1e-12);
  EXPECT_LT(total(estimate_error(s.model, s.solution)), 1e-12);

  const Solved plane = solve(R"(scheme = "linear"
[material]
young = 10
poisson = 0.25
[model]
kind = "plane-strain"
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == 2"
force_per_length = [1, 0]
)" + GetParam(),
                             two_halves(4));
  EXPECT_LT(total(estimate_error(plane.model, plane.solution)), 1e-12);
}

// u = y + x where k = 1 and y + 1 + (x - 1) / 4 where k = 4: the flux along x is 1 on both sides,
// along y it jumps from 1 to 4. Recovery across the line would see an error.
// Fluxes, sources, pressure and forces per length and volume that a linear solution, or one whose
// error is not seen, balances: each one left out would be an error.
TEST(ErrorEstimate, ResidualsKnowEveryLoad) {
  const SolvedPoisson flux = solve_scalar(R"(scheme = "linear"
[model]
kind = "poisson"
[material]
conductivity = 3
[[support]]
where = "x == 0"
value = "5"
[[load]]
where = "x == 2"
flux = 6
)" + std::string(by_residual),
                                          two_halves(4));
  EXPECT_LT(total(estimate_error(flux.model, flux.solution)), 1e-12);

  const Solved pressed = solve(R"(scheme = "linear"
[material]
young = 10
poisson = 0.25
thickness = 0.5
[model]
kind = "plane-stress"
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == 2"
pressure = 3
)" + std::string(by_residual),
                               two_halves(4));
  EXPECT_LT(total(estimate_error(pressed.model, pressed.solution)), 1e-12);
}

// u = x (2 - x) / 2 with the source 1 on a row of n rectangles of length h: the solution is exact at the
// nodes, its slope jumps by h there. Each of a rectangle's two sides between rectangles counts
// h / 6 (h / 2)^2 per length, and the held ends nothing; the square of the error is h^2 / 12 per area.
TEST(ErrorEstimate, ResidualsOfAParabolaAreKnown) {
  constexpr int n = 8;
  constexpr double h = 2.0 / n, width = 0.1;
  const SolvedPoisson s = solve_scalar(
      R"(scheme = "linear"
[model]
kind = "poisson"
[material]
[[support]]
where = "x == 0 or x == 2"
value = 0
[[load]]
where = "all"
source = 1
)" + std::string(by_residual),
      testing::grid(n, 1, [](const Vec2& p) { return Vec2(2 * p.x(), p.y() * width); }));
  EXPECT_NEAR(s.solution.strain_energy, width * (1.0 / 3 - h * h / 12), 1e-12);
  const double sides = h / 6 * (h / 2) * (h / 2) * width * 2 * (n - 1);
  const double square = std::pow(total(estimate_error(s.model, s.solution)), 2);
  EXPECT_NEAR(square, sides, 1e-12);
  EXPECT_NEAR(square, h * h / 12 * 2 * width * (n - 1) / n, 1e-12);
}

// Expressions are not thread safe; more elements than one thread takes at a time.
TEST(ErrorEstimate, ResidualsOfFormulasAreTheSameForAnyNumberOfThreads) {
  const SolvedPoisson s = solve_scalar(R"(scheme = "linear"
[model]
kind = "poisson"
[material]
[[support]]
where = "x == 0"
value = 0
[[load]]
where = "all"
source = "sin(x) * exp(y) + x^2"
[[load]]
where = "x == 2"
flux = "cos(y) + x"
)" + std::string(by_residual),
                                       two_halves(48));
  const auto estimate = [&](std::size_t threads) {
#ifdef LIMES_WITH_TBB
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#else
    (void)threads;
#endif
    return estimate_error(s.model, s.solution);
  };
  const std::vector<double> one = estimate(1);
  ASSERT_GT(one.size(), 4U * 1024);
  for (int run = 0; run < 5; ++run)
    EXPECT_EQ(estimate(4), one);
}

TEST(ErrorEstimate, DoesNotSmearAcrossMaterials) {
  const SolvedPoisson s =
      solve_scalar(poisson_of_two + "\"y + (x < 1 ? x : 1 + (x - 1) / 4)\"\n", two_halves(4));
  EXPECT_LT(total(estimate_error(s.model, s.solution)), 1e-12);
  EnergyDensity energy;
  energy.gradient = [&](int e, const ElementTable& table) {
    MatrixX out(table.uv.rows(), 2);
    const auto at = states(s.model, s.solution, e, table);
    for (std::size_t i = 0; i < at.size(); ++i)
      out.row(static_cast<Eigen::Index>(i)) = at[i].gradient.transpose();
    return out;
  };
  energy.stiffness = [&](int e) {
    return MatrixX(s.model.conductivity(e) * MatrixX::Identity(2, 2));
  };
  EXPECT_LT(total(zienkiewicz_zhu(*s.model.space, energy, s.model.same_material())), 1e-12);
  EXPECT_GT(total(zienkiewicz_zhu(*s.model.space, energy, [](HalfedgeId) { return true; })), 0.3);
}

std::string sine(const std::string& adapt) {
  return R"toml(scheme = "linear"
levels = 1
[model]
kind = "poisson"
[material]
[[support]]
where = "boundary"
value = 0
[[load]]
where = "all"
source = "2 * pi^2 * sin(pi * x) * sin(pi * y)"
[adapt]
reference_energy = 2.4674011002723395   # pi^2 / 4
)toml" + adapt;
}

/// Runs a problem whose mesh file is m.obj beside it.
PoissonResult run_scalar(const std::string& text, const std::string& obj) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "limes_adaptive";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "m.obj") << obj;
  return run_poisson_problem(parse_problem("[mesh]\nfile = \"m.obj\"\n" + text, folder / "p.toml"));
}

const char* const unit_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

// Uniform refinement of a smooth problem: the error halves with the mesh size, and the estimate is
// asymptotically exact.
TEST(AdaptiveRun, SmoothProblemHasOrderOneAndAnExactEstimate) {
  const PoissonResult result =
      run_scalar(sine("mark = \"fraction\"\nshare = 1\nmax_dofs = 5000\n"), unit_square);
  const std::vector<AdaptStep>& steps = result.adaptive->history.steps;
  ASSERT_EQ(steps.size(), 6U);  // 2 x 2 to 64 x 64
  for (std::size_t i = 3; i < steps.size(); ++i) {
    EXPECT_NEAR(std::log2(*steps[i - 1].true_error / *steps[i].true_error), 1, 0.02);
  }
  EXPECT_NEAR(*steps.back().effectivity, 1, 0.01);
}

TEST(AdaptiveRun, ResultsHaveTheSteps) {
  const PoissonResult result = run_scalar(sine("target_error = 0.2\n"), unit_square);
  const nlohmann::ordered_json json = result_json(result, false);
  EXPECT_EQ(json["end"], "target_error");
  ASSERT_GT(json["steps"].size(), 1U);
  for (const auto& step : json["steps"])
    for (const char* key : {"dofs", "elements", "strain_energy", "error_estimate",
                            "relative_error_estimate", "error", "effectivity"})
      EXPECT_TRUE(step.contains(key)) << key;
  EXPECT_EQ(json["dofs"], json["steps"].back()["dofs"]);
  EXPECT_EQ(json["strain_energy"], json["steps"].back()["strain_energy"]);
  std::vector<std::string> names;
  for (const ReportFile& file : report_files(result))
    names.push_back(file.name);
  for (const char* name : {"report.html", "solution.png", "convergence.png", "adapted-mesh.png"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

// The spaces are nested, so by Galerkin's orthogonality the square of the difference to the finer solution is
// twice the difference of the energies.
TEST(AdaptiveRun, ErrorAgainstAFinerSolutionIsThatOfTheEnergies) {
  const auto energy = [](const std::string& more) {
    return run_scalar("scheme = \"linear\"\nlevels = " + more + R"toml(
[model]
kind = "poisson"
[material]
[[support]]
where = "boundary"
value = 0
[[load]]
where = "all"
source = 1
)toml" + (more[0] == '1' ? "[adapt]\nmax_steps = 2\nreference_levels = 2\n" : ""),
                      "v 0 0 0\nv 1 0 0\nv 1.4 1.2 0\nv 0.4 1.2 0\nf 1 2 3 4\n");
  };
  const PoissonResult result = energy("1");
  ASSERT_EQ(result.adaptive->history.steps.size(), 2U);
  const AdaptStep& first = result.adaptive->history.steps[0];
  const double difference = energy("3").solution.strain_energy - first.strain_energy;
  EXPECT_NEAR(*first.finer_error * *first.finer_error / (2 * difference), 1, 1e-9);
  EXPECT_DOUBLE_EQ(*first.finer_effectivity, first.error_estimate / *first.finer_error);
  const auto step = result_json(result, false)["steps"][0];
  EXPECT_EQ(step["error_against_finer"], *first.finer_error);
  EXPECT_EQ(step["effectivity_against_finer"], *first.finer_effectivity);
}

// One of two squares is a hole.
TEST(AdaptiveRun, HolesAreNoElements) {
  const PoissonResult result = run_scalar(R"toml(scheme = "linear"
[model]
kind = "poisson"
[material]
[[support]]
where = "x == 0"
value = 0
[[load]]
where = "all"
source = 1
[adapt]
mark = "fraction"
share = 1
max_steps = 2
)toml",
                                          R"(v 0 0 0
v 1 0 0
v 2 0 0
v 0 1 0
v 1 1 0
v 2 1 0
f 1 2 5 4
f 2 3 6 5
t hole 1/0/0 1
)");
  const std::vector<AdaptStep>& steps = result.adaptive->history.steps;
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].elements, 1);
  EXPECT_EQ(steps[1].elements, 4);
}

std::vector<AdaptStep> l_shape(const std::vector<std::string>& overrides) {
  return run_poisson_problem(read_problem(LIMES_DATA_DIR "/l_shape.toml", overrides))
      .adaptive->history.steps;
}

/// Slope of the logarithm of the true error between two steps.
double rate(const AdaptStep& a, const AdaptStep& b) {
  return std::log(*b.true_error / *a.true_error) / std::log(double(b.dofs) / a.dofs);
}

/// Unknowns at which the straight lines between the steps, in logarithms, reach a relative error.
double dofs_for(double relative, const std::vector<AdaptStep>& steps) {
  const double norm = std::sqrt(2 * 0.91811333093758);
  for (std::size_t i = 1; i < steps.size(); ++i)
    if (*steps[i].true_error <= relative * norm)
      return steps[i].dofs *
             std::pow(relative * norm / *steps[i].true_error, 1 / rate(steps[i - 1], steps[i]));
  return 1e300;
}

TEST(AdaptiveRun, ResidualsDriveTheLoopAsWell) {
  const std::vector<AdaptStep> steps = l_shape({"adapt.estimator=residual", "adapt.max_dofs=8000"});
  EXPECT_NEAR(rate(steps[steps.size() - 4], steps.back()), -0.5, 0.06);
  for (const AdaptStep& s : steps) {
    EXPECT_GT(*s.effectivity, 0.7) << s.dofs;
    EXPECT_LT(*s.effectivity, 1.5) << s.dofs;
  }
  const PlaneResult cook = run_problem(read_problem(
      LIMES_DATA_DIR "/cook.toml", std::vector<std::string>{"adapt.estimator=residual"}));
  for (const AdaptStep& s : cook.adaptive->history.steps) {
    EXPECT_GT(*s.effectivity, 0.7) << s.dofs;
    EXPECT_LT(*s.effectivity, 1.5) << s.dofs;
  }
  EXPECT_NEAR(cook.solution.strain_energy, 12.02080, 0.002 * 12.02080);
}

// u = r^(2/3) sin(2/3 t) is in H^(5/3): uniform refinement loses half of the order.
TEST(AdaptiveRun, OnTheLShapeBeatsUniformRefinement) {
  const std::vector<AdaptStep> adaptive = l_shape({"adapt.max_dofs=8000"});
  const std::vector<AdaptStep> uniform =
      l_shape({"adapt.mark=fraction", "adapt.share=1", "adapt.max_dofs=13000"});
  EXPECT_NEAR(rate(uniform[uniform.size() - 2], uniform.back()), -1.0 / 3, 0.03);
  EXPECT_NEAR(rate(adaptive[adaptive.size() - 4], adaptive.back()), -0.5, 0.06);
  EXPECT_LT(3 * dofs_for(0.02, adaptive), dofs_for(0.02, uniform));
  const double norm = std::sqrt(2 * 0.91811333093758);
  for (const auto& steps : {adaptive, uniform})
    for (const AdaptStep& s : steps)
      if (*s.true_error < 0.2 * norm) {
        EXPECT_GT(*s.effectivity, 0.7) << s.dofs;
        EXPECT_LT(*s.effectivity, 1.5) << s.dofs;
      }
}

// Against elements of degree 6, see data/SOURCES.md.
TEST(AdaptiveRun, CooksMembraneGoesToItsEnergy) {
  const PlaneResult result = run_problem(read_problem(LIMES_DATA_DIR "/cook.toml", {}));
  const std::vector<AdaptStep>& steps = result.adaptive->history.steps;
  EXPECT_EQ(result.adaptive->history.end, "max_dofs");
  for (const AdaptStep& s : steps) {
    EXPECT_LT(s.strain_energy, 12.02080);
    EXPECT_GT(*s.effectivity, 0.7) << s.dofs;
    EXPECT_LT(*s.effectivity, 1.5) << s.dofs;
  }
  EXPECT_NEAR(rate(steps[steps.size() / 2], steps.back()), -0.5, 0.08);
  EXPECT_NEAR(steps.back().strain_energy, 12.02080, 0.002 * 12.02080);
  EXPECT_NEAR(result.probes.at(0).state.u.y(), 23.96774, 0.002 * 23.96774);
}

TEST(AdaptiveRun, AnErrorOfZeroHasNoPlot) {
  std::string text = sine("");
  text.erase(text.find("[[load]]"), text.find("[adapt]") - text.find("[[load]]"));
  text.erase(text.find("reference_energy"));
  const PoissonResult result = run_scalar(text, unit_square);
  EXPECT_EQ(result.adaptive->history.end, "no error left");
  EXPECT_EQ(result.adaptive->history.steps.back().error_estimate, 0);
  std::set<std::string> names;
  for (const ReportFile& file : report_files(result))
    names.insert(file.name);
  EXPECT_EQ(names.count("convergence.png"), 0U);
  EXPECT_EQ(names.count("adapted-mesh.png"), 1U);
}

/// Runs a problem that keeps its state, with m.obj beside it.
void run_with_state(const std::string& text, const std::string& obj, bool resume) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "limes_state";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "m.obj") << obj;
  Problem problem = parse_problem("[mesh]\nfile = \"m.obj\"\n" + text, folder / "p.toml");
  problem.adapt->state = folder / "state.json";
  problem.adapt->resume = resume;
  (void)run_poisson_problem(problem);
}

std::string refusal_to_resume(const std::string& text, const std::string& obj) {
  try {
    run_with_state(text, obj, true);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const char* const two_squares = R"(v 0 0 0
v 1 0 0
v 2 0 0
v 0 1 0
v 1 1 0
v 2 1 0
)";

TEST(AdaptState, IsOfOneMeshWithItsNamesAndTags) {
  const std::string text = sine("max_steps = 2\n"), more = sine("max_steps = 3\n");
  const std::string faces = "g a\nf 1 2 5 4\nf 2 3 6 5\n";
  run_with_state(text, two_squares + faces, false);
  for (const char* tag : {"t crease 2/1/0 1 4 2\n", "t corner 1/1/0 1 2\n", "t hole 1/0/0 1\n",
                          "t interpolateboundary 1/0/0 2\n"})
    EXPECT_NE(refusal_to_resume(more, two_squares + faces + tag).find("started on another mesh"),
              std::string::npos)
        << tag;
  for (const char* other : {"f 1 2 5 4\nf 2 3 6 5\n", "g b\nf 1 2 5 4\nf 2 3 6 5\n",
                            "g a\nf 1 2 5 4\ng b\nf 2 3 6 5\n", "o p\ng a\nf 1 2 5 4\nf 2 3 6 5\n"})
    EXPECT_NE(
        refusal_to_resume(more, std::string(two_squares) + other).find("started on another mesh"),
        std::string::npos)
        << other;
  EXPECT_EQ(refusal_to_resume(more, two_squares + faces), "no error");
}

TEST(AdaptState, WithImpossibleStepsIsDamaged) {
  const std::string more = sine("max_steps = 3\n");
  run_with_state(sine("max_steps = 2\n"), unit_square, false);
  const std::filesystem::path file =
      std::filesystem::path(::testing::TempDir()) / "limes_state" / "state.json";
  const nlohmann::json good = nlohmann::json::parse(std::ifstream(file));
  const auto refusal = [&](const auto& change) {
    nlohmann::json bad = good;
    change(bad["steps"][0]);
    std::ofstream(file) << bad;
    return refusal_to_resume(more, unit_square);
  };
  using Step = nlohmann::json;
  const auto expect_damaged = [&](const auto& change) {
    const std::string message = refusal(change);
    EXPECT_NE(message.find("state.json: is damaged"), std::string::npos) << message;
  };
  expect_damaged([](Step& s) { s["dofs"] = 0; });
  expect_damaged([](Step& s) { s["dofs"] = 1.5; });
  expect_damaged([](Step& s) { s["elements"] = -4; });
  expect_damaged([](Step& s) { s["error_estimate"] = -1; });
  expect_damaged([](Step& s) { s.erase("true_error"); });
  expect_damaged([](Step& s) { s["strain_energy"] = nullptr; });
  EXPECT_EQ(refusal([](Step&) {}), "no error");
}

TEST(AdaptiveRun, RefusesWhatItCannotDo) {
  const auto refusal = [](const std::string& text, const std::string& obj = unit_square) {
    try {
      (void)run_scalar(text, obj);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  std::string warm = sine("");
  warm.replace(warm.find("value = 0"), 9, "value = \"x\"");
  EXPECT_NE(refusal(warm).find("says what the error is only where all supports have the value 0"),
            std::string::npos)
      << refusal(warm);
  std::string triangle = sine("");
  triangle.replace(triangle.find("levels = 1"), 10, "levels = 0");
  EXPECT_NE(refusal(triangle, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
                .find("[adapt] refines quads, but face 0 of"),
            std::string::npos);
  EXPECT_NE(refusal(sine(""), std::string(unit_square) + "t interpolateboundary 1/0/0 0\n")
                .find("p.toml:14: [adapt] refines all faces, but"),
            std::string::npos);
}

}  // namespace
}  // namespace limes
