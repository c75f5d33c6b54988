#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/program.h"
#include "cli/vtu_reader.h"
#include "study/tension.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;

const std::string square =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
    "f 1 2 5 4\nf 2 3 6 5\nt interpolateboundary 1/0/0 1\n";

const std::string pulled =
    "[mesh]\nfile = \"square.obj\"\nlevels = 1\n[material]\nyoung = 10\npoisson = 0.25\n" +
    testing::tension("2", "1");

/// A folder with a problem that has an exact solution: u = x / 10, v = -y / 40.
class Solve : public ::testing::Test {
 protected:
  Solve() {
    mesh = folder.file("square.obj", square);
    problem = folder.file("pull.toml", pulled);
  }
  TempFolder folder;
  std::string mesh, problem;
};

TEST_F(Solve, PrintsOneJsonObject) {
  const Result result = run_limes({"solve", problem, "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["model"], "plane-stress");
  EXPECT_EQ(json["scheme"], "catmull-clark");
  EXPECT_EQ(json["elements"], 8);
  EXPECT_NEAR(json["strain_energy"], 0.1, 1e-13);
  const Json& end = json["probes"]["end"];
  EXPECT_NEAR(end["displacement"][0], 0.2, 1e-13);
  EXPECT_NEAR(end["displacement"][1], -0.025, 1e-13);
  EXPECT_NEAR(end["stress"][0], 1.0, 1e-12);
  EXPECT_NEAR(end["distance"], 0, 1e-14);
  EXPECT_NEAR(json["reactions"][0]["force"][0], -1.0, 1e-12);
  for (const char* key : {"dofs", "timings", "peak_memory", "checks", "title", "loads"})
    EXPECT_TRUE(json.contains(key)) << key;
  for (const Json& check : json["checks"])
    EXPECT_TRUE(check["passed"]) << check;
}

TEST_F(Solve, WritesResultsThatStandAlone) {
  const std::string out = folder / "out";
  const Result result = run_limes({"solve", problem, "-o", out});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(read_file(out + "/result.json"));
  EXPECT_NEAR(json["strain_energy"], 0.1, 1e-13);
  const std::string report = read_file(out + "/report.html");
  EXPECT_NE(report.find("equilibrium of forces"), std::string::npos);
  EXPECT_EQ(report.find("src=\"http"), std::string::npos);
  EXPECT_NE(report.find("square.obj, 2 faces, refined 1 time<"), std::string::npos);
  EXPECT_NE(report.find("<td class=\"number\">\u22121"), std::string::npos);  // reaction
  // The largest displacement is hypot(0.2, 0.025), the diagonal sqrt(5): 1 times is 9 % of it.
  EXPECT_NE(report.find("Displacements are drawn as large as they are"), std::string::npos);
  EXPECT_NE(report.find("<footer>Made by limes 0."), std::string::npos);
  EXPECT_NE(report.find(": limes solve " + problem + "</footer>"), std::string::npos);
  EXPECT_NE(read_file(out + "/result.vtu").find("von_mises"), std::string::npos);
  for (const char* picture : {"control-mesh.png", "deformed.png", "stress-xx.png", "von-mises.png"})
    EXPECT_EQ(read_file(out + "/" + picture).substr(1, 3), "PNG") << picture;
}

TEST_F(Solve, ReplacesAllResultsOrNone) {
  const std::string out = folder / "out";
  std::filesystem::create_directories(out + "/result.json");  // the last to be written cannot be
  (void)folder.file("out/result.vtu", "of another run");
  expect_failure(run_limes({"solve", problem, "-o", out}), 5, "result.json: cannot be written");
  EXPECT_EQ(read_file(out + "/result.vtu"), "of another run");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out))
    files += entry.exists() ? 1 : 0;
  EXPECT_EQ(files, 2);  // no temporary ones either
}

// In quotes for a shell, where &#39; is the quotation mark of HTML.
TEST_F(Solve, SaysHowToRepeatTheRun) {
  const std::string out = folder / "out";
  const std::string change = "probe.0.name=it's";
  ASSERT_EQ(run_limes({"solve", problem, "-o", out, "--threads", "1", "--set", change}).exit_code,
            0);
  const std::string report = read_file(out + "/report.html");
  const std::size_t foot = report.find("<footer>");
  ASSERT_NE(foot, std::string::npos);
  EXPECT_NE(report.find("--set &#39;probe.0.name=it&#39;\\&#39;&#39;s&#39;</footer>", foot),
            std::string::npos)
      << report.substr(foot);
}

TEST_F(Solve, GivesTheSameBytesForAnyNumberOfThreads) {
  const std::string block = data_file("block.toml");
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(run_limes({"solve", block, "-o", folder / threads, "--threads", threads}).exit_code,
              0);
  for (const char* name : {"/result.vtu", "/stress-xx.png", "/report.html"})
    EXPECT_EQ(read_file(folder / "1" + name), read_file(folder / "2" + name)) << name;
}

TEST_F(Solve, AdaptsToTheSameBytesForAnyNumberOfThreads) {
  for (const char* name : {"l_shape", "cook"}) {
    for (const char* threads : {"1", "2"})
      ASSERT_EQ(run_limes({"solve", data_file(std::string(name) + ".toml"), "-o", folder / threads,
                           "--threads", threads, "--set", "adapt.max_dofs=1000"})
                    .exit_code,
                0);
    for (const char* file : {"/result.vtu", "/adapted-mesh.png", "/report.html"})
      EXPECT_EQ(read_file(folder / "1" + file), read_file(folder / "2" + file)) << name << file;
  }
}

// A run that ends early leaves the state of its last mesh, like one that is interrupted there.
TEST_F(Solve, ResumesToTheSameBytes) {
  for (const auto& tried :
       {std::array{"l_shape.toml", "adapt.closure=conforming", "adapt.reference_levels=1"},
        std::array{"cook.toml", "adapt.closure=conforming", "adapt.reference_levels=1"},
        std::array{"cook.toml", "adapt.closure=hanging", "adapt.reference_levels=0"}}) {
    const char *const name = tried[0], *const closure = tried[1], *const levels = tried[2];
    const std::string whole = folder / "whole", parts = folder / "parts";
    const auto run = [&](const std::string& out, const char* dofs,
                         const std::vector<std::string>& more = {}) {
      std::vector<std::string> arguments{
          "solve", data_file(name), "-o",   out,     "--set",
          closure, "--set",         levels, "--set", std::string("adapt.max_dofs=") + dofs};
      arguments.insert(arguments.end(), more.begin(), more.end());
      return run_limes(arguments);
    };
    ASSERT_EQ(run(whole, "1000").exit_code, 0);
    ASSERT_EQ(run(parts, "200").exit_code, 0);
    const Result resumed = run(parts, "1000", {"--resume"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    for (const char* file :
         {"/result.vtu", "/adapted-mesh.png", "/report.html", "/adapt-state.json"})
      EXPECT_EQ(read_file(whole + file), read_file(parts + file)) << name << file;
    ASSERT_EQ(run(parts, "1000", {"--resume"}).exit_code, 0);  // nothing is left to do
    EXPECT_EQ(read_file(whole + "/report.html"), read_file(parts + "/report.html"));
  }
}

// Errors of the last step as fields of the cells.
TEST_F(Solve, ShowsTheErrorOfEveryElement) {
  for (const char* name : {"l_shape.toml", "cook.toml", "hole_5.toml"})
    for (const char* estimator : {"zienkiewicz-zhu", "residual"}) {
      const std::string out = folder / "out";
      const Result result = run_limes({"solve", data_file(name), "-o", out, "--json", "--set",
                                       "adapt.max_dofs=1000", "--set", "adapt.reference_levels=1",
                                       "--set", std::string("adapt.estimator=") + estimator});
      ASSERT_EQ(result.exit_code, 0) << result.err;
      const Json json = Json::parse(result.out), step = json["steps"].back();
      VtuArrays fields = read_vtu_arrays(out + "/result.vtu");
      const auto norm = [&](const char* field) {
        EXPECT_EQ(fields[field].size(), json["elements"]) << name << field;
        double sum = 0;
        for (const double x : fields[field])
          sum += x * x;
        return std::sqrt(sum);
      };
      const double estimate = step["error_estimate"], finer = step["error_against_finer"];
      EXPECT_NEAR(norm("error") / estimate, 1, 1e-12) << name;
      EXPECT_NEAR(norm("error_against_finer") / finer, 1, 1e-12) << name;
      EXPECT_NEAR(step["effectivity_against_finer"], estimate / finer, 1e-12) << name;
    }
}

TEST_F(Solve, DrawsShellsToTheSameBytesForAnyNumberOfThreads) {
  for (const std::string closure : {"conforming", "hanging"}) {
    for (const char* threads : {"1", "2"})
      ASSERT_EQ(run_limes({"solve", data_file("hole_5.toml"), "-o", folder / (closure + threads),
                           "--threads", threads, "--set", "adapt.max_steps=2", "--set",
                           "adapt.closure=" + closure})
                    .exit_code,
                0);
    for (const char* file :
         {"/displacement.png", "/von-mises-top.png", "/von-mises-bottom.png", "/adapted-mesh.png",
          "/convergence.png", "/report.html", "/result.vtu"}) {
      const std::string bytes = read_file(folder / (closure + "1") + file);
      EXPECT_FALSE(bytes.empty()) << closure << file;
      EXPECT_EQ(bytes, read_file(folder / (closure + "2") + file)) << closure << file;
    }
  }
}

// The rotation of a plate strip under a moment m at its end: m L / (E t^3 / 12), about y and positive where z
// turns to x.
TEST_F(Solve, ReportsRotationsOfShellsInRadians) {
  const std::string text = R"([mesh]
file = "square.obj"
scheme = "linear"
levels = 1
[model]
kind = "mitc4"
[material]
young = 12e3
poisson = 0
thickness = 0.1
[[support]]
where = "x == 0"
kind = "clamped"
[[load]]
where = "vertex:2"
moment = [0, 0.0005, 0]
[[load]]
where = "vertex:5"
moment = [0, 0.0005, 0]
[[load]]
where = "x == 2 and y == 0.5"
moment = [0, 0.001, 0]
[[probe]]
name = "end"
at = [2, 0.5, 0]
)";
  const std::string out = folder / "out";
  const Result result = run_limes({"solve", folder.file("strip.toml", text), "-o", out, "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["units"]["rotation"], "rad");
  const Json& end = json["probes"]["end"];
  EXPECT_NEAR(end["rotation"][0], 0, 1e-12);
  EXPECT_NEAR(end["rotation"][1], 0.004, 1e-9);
  EXPECT_NEAR(end["von_mises"]["top"], 0.002 * 6 / 0.01, 1e-9);  // 6 m / t^2
  EXPECT_NEAR(end["von_mises"]["middle"], 0, 1e-9);
  const std::string report = read_file(out + "/report.html");
  EXPECT_NE(report.find("in radians"), std::string::npos);
  EXPECT_NE(report.find("θ<sub>y</sub>"), std::string::npos);
  EXPECT_NE(report.find(">0.004<"), std::string::npos);
  for (const char* title : {"Von Mises stress at the top", "Von Mises stress at the bottom"})
    EXPECT_NE(report.find(title), std::string::npos) << title;
}

TEST_F(Solve, OneStepHasNoDiagramOfConvergence) {
  for (const char* name : {"l_shape.toml", "hole_5.toml"}) {
    const std::string out = folder / name;
    ASSERT_EQ(
        run_limes({"solve", data_file(name), "-o", out, "--set", "adapt.max_steps=1"}).exit_code,
        0);
    EXPECT_FALSE(std::filesystem::exists(out + "/convergence.png")) << name;
    EXPECT_TRUE(std::filesystem::exists(out + "/adapted-mesh.png")) << name;
    EXPECT_NE(read_file(out + "/report.html").find("There is no diagram of the error"),
              std::string::npos)
        << name;
  }
}

// Shells: on an exact surface with curves, with shapes optimised after each step, of parts on a seam, with
// junctions, and by the scheme.
TEST_F(Solve, ResumesShellsToTheSameBytes) {
  const std::vector<std::vector<std::string>> cases{
      {"hole_5.toml"},
      {"hole_5.toml", "mesh.smoothing=3"},
      {"cylinder_plate_a.toml", "mesh.levels=2", "adapt.share=0.1"},
      {"i_beam.toml", "mesh.levels=1", "adapt.share=0.1"},
      {"hole_5_kobbelt.toml"}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string whole = folder / ("whole" + std::to_string(i));
    const std::string parts = folder / ("parts" + std::to_string(i));
    const auto run = [&](const std::string& out, const char* steps, bool resume) {
      std::vector<std::string> arguments{"solve", data_file(cases[i][0]),
                                         "-o",    out,
                                         "--set", std::string("adapt.max_steps=") + steps};
      for (std::size_t k = 1; k < cases[i].size(); ++k)
        arguments.insert(arguments.end(), {"--set", cases[i][k]});
      if (resume) arguments.emplace_back("--resume");
      const Result result = run_limes(arguments);
      EXPECT_EQ(result.exit_code, 0) << result.err;
    };
    run(whole, "3", false);
    run(parts, "2", false);
    EXPECT_NE(read_file(whole + "/adapt-state.json"), read_file(parts + "/adapt-state.json"));
    run(parts, "3", true);
    for (const char* file : {"/result.vtu", "/report.html", "/adapt-state.json"})
      EXPECT_EQ(read_file(whole + file), read_file(parts + file)) << cases[i][0] << file;
  }
}

TEST_F(Solve, ResumesAfterAnInterrupt) {
  const std::string whole = folder / "whole", parts = folder / "parts";
  const std::string file = data_file("l_shape.toml");
  ASSERT_EQ(run_limes({"solve", file, "-o", whole}).exit_code, 0);
  const Result broken = run_limes({"solve", file, "-o", parts}, std::chrono::milliseconds(200));
  if (broken.exit_code == 130) {
    EXPECT_EQ(read_file(parts + "/report.html"), "");
  }
  if (!std::filesystem::exists(parts + "/adapt-state.json")) GTEST_SKIP() << "interrupted too soon";
  ASSERT_EQ(run_limes({"solve", file, "-o", parts, "--resume"}).exit_code, 0);
  EXPECT_EQ(read_file(whole + "/result.vtu"), read_file(parts + "/result.vtu"));
  EXPECT_EQ(read_file(whole + "/report.html"), read_file(parts + "/report.html"));
}

TEST_F(Solve, ResumesOnlyWhatFits) {
  const std::string out = folder / "out", file = data_file("cook.toml");
  const auto resume = [&](const std::vector<std::string>& changes) {
    std::vector<std::string> arguments{"solve", file, "-o", out, "--resume"};
    for (const std::string& change : changes) {
      arguments.emplace_back("--set");
      arguments.push_back(change);
    }
    return run_limes(arguments);
  };
  expect_failure(resume({}), 3, "adapt-state.json: there is no run to resume");
  ASSERT_EQ(run_limes({"solve", file, "-o", out, "--set", "adapt.max_dofs=500"}).exit_code, 0);
  expect_failure(resume({"material.young=2"}), 3,
                 "is of another problem, it has 'material.young = 1' where");
  expect_failure(resume({"adapt.closure=hanging"}), 3,
                 "is of another problem, it has nothing where");
  expect_failure(resume({"adapt.max_dofs=100"}), 3, "has gone beyond max_dofs");
  expect_failure(resume({"adapt.max_steps=2"}), 3, "has gone beyond step 1, the last of max_steps");
  expect_failure(resume({"adapt.target_error=0.4"}), 3, "at which target_error is reached");
  std::string state = read_file(out + "/adapt-state.json");
  (void)folder.file("out/adapt-state.json", state.substr(0, state.size() / 2));
  expect_failure(resume({}), 3, "adapt-state.json: is damaged; run without --resume");
  state.replace(state.find("\"mesh\":\"") + 8, 4, "0123");
  (void)folder.file("out/adapt-state.json", state);
  expect_failure(resume({}), 3, "was started on another mesh than");
  expect_failure(run_limes({"solve", file, "--resume"}), 2, "--resume: name the folder");
  expect_failure(run_limes({"solve", problem, "-o", out, "--resume"}), 2, "has no [adapt]");
}

TEST_F(Solve, HomogenisesAPeriodicCell) {
  // Without holes and grains of another stiffness the cell is homogeneous: plane stress, E = 1,
  // nu = 0.3, so C1111 = 1 / 0.91, C1122 = 0.3 / 0.91, C1212 = 1 / 2.6.
  const std::string text = R"([mesh]
file = "square.obj"
[material]
young = 1
poisson = 0.3
[model]
kind = "plane-stress"
[periodic]
gradient = [[1, 0.05], [0.05, 1]]
)";
  const Result result = run_limes({"solve", folder.file("cell.toml", text), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  const double expected[3][3] = {{1 / .91, .3 / .91, 0}, {.3 / .91, 1 / .91, 0}, {0, 0, 1 / 2.6}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(json["effective_stiffness"][i][j], expected[i][j], 1e-13) << i << j;
  EXPECT_NEAR(json["average_stress"][2], .1 / 2.6, 1e-14);
}

TEST_F(Solve, TakesOverrides) {
  const Result result = run_limes({"solve", problem, "--json", "--set", "material.young=20",
                                   "mesh.levels=2", "load.0.force_per_length=[2, 0]"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["elements"], 32);
  EXPECT_NEAR(json["probes"]["end"]["displacement"][0], 0.2, 1e-13);
}

TEST_F(Solve, FailsWithTheRightCode) {
  expect_failure(run_limes({"solve", problem, "--set", "mesh.level=2"}), 2, "mesh.level");
  expect_failure(run_limes({"solve", folder / "none.toml"}), 3, "none.toml");
  expect_failure(run_limes({"solve", problem, "--set", "mesh.file=none.obj"}), 3, "none.obj");
  expect_failure(run_limes({"solve", problem, "--set", "support.0.fix=[\"uy\"]"}), 2,
                 "can still move along x");
  expect_failure(run_limes({"solve", problem, "--set", "load.0.where=x == 9"}), 2,
                 "--set load.0.where: where = 'x == 9' selects no vertex");
  expect_failure(run_limes({"solve", problem, "--set", "support.0.fix=[\"uz\"]"}), 2,
                 "--set support.0.fix: plane models have no uz");
  expect_failure(run_limes({"solve", problem, "--set", "material.thickness=1e308"}), 4,
                 problem + ": the stiffness matrix is not finite; check the units");
  expect_failure(run_limes({"solve", problem, "--set", "load.0.force_per_length=[1e308, 0]"}), 4,
                 problem + ": the solution of the linear system");
  const std::string blocked = folder.file("blocked", "a file, no folder");
  // Known before anything is read.
  expect_failure(run_limes({"solve", folder / "none.toml", "-o", blocked + "/out"}), 5,
                 "out: cannot be made: " + blocked + " is a file");
  expect_failure(run_limes({"solve", problem, "--set", "mesh.scheme=loop"}), 2,
                 "--set mesh.scheme: there are no plane elements of the scheme \"loop\"");
}

// Whatever finds that a value does not fit, and wherever its table is.
TEST_F(Solve, BlamesOverridesForWhatIsFoundLater) {
  const auto refused = [&](const std::string& file, const std::string& change,
                           const std::string& message) {
    const Result result = run_limes({"solve", file, "--set", change});
    expect_failure(result, 2, message);
    EXPECT_EQ(result.err.find("limes: --set "), 0U) << result.err;
  };
  refused(problem, "model.kind=poisson",
          "--set model.kind, " + problem + ":5: [material] young is no key of kind = \"poisson\"");
  refused(problem, "load.0.force_per_length=[0, 0, 1]",
          "--set load.0.force_per_length: plane models carry no load in z");
  refused(problem, "load.0.force_per_length.0=1 / (x - 2)",
          "--set load.0.force_per_length.0: '1 / (x - 2)' has no finite value at (2, ");
  refused(problem, "adapt.max_steps=3",
          "--set adapt.max_steps: [adapt] works on bilinear elements");
  refused(problem, "mesh.levels=4.0",
          "--set mesh.levels: [mesh] levels is 4.0; it must be an integer from 0 to 12");
  refused(data_file("i_beam.toml"), "mesh.scheme=loop",
          "--set mesh.scheme: scheme \"loop\" gives no quads");
  refused(data_file("i_beam.toml"), "support.0.where=x == 0 and y > 9",
          "--set support.0.where: where = 'x == 0 and y > 9' selects no vertex");
}

/// The cylinder of the roof made a cone that lies behind its apex.
TEST_F(Solve, RefusesPlacementsWithoutArea) {
  std::string roof = read_file(data_file("roof.toml"));
  const std::size_t begin = roof.find("kind = \"cylinder\""), end = roof.find("\n\n", begin);
  ASSERT_NE(begin, std::string::npos);
  roof.replace(begin, end - begin,
               "kind = \"cone\"\nangle = 10\npoint = [1, 2, 999]\naxis = [0, 0, 1]");
  (void)folder.file("roof.obj", read_file(data_file("roof.obj")));
  expect_failure(run_limes({"solve", folder.file("roof.toml", roof)}), 3,
                 "roof.obj has no area on this surface: its vertices come to one point or line");
}

TEST_F(Solve, RefusesWhatCannotFitBeforeItStarts) {
  const std::string out = folder / "out";
  const std::int64_t idle = run_limes({"schemes"}).peak_memory;
  const auto refused = [&](const std::string& file, const std::vector<std::string>& more,
                           const std::string& message) {
    std::vector<std::string> arguments{"solve", file, "-o", out, "--memory-limit", "500M"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = run_limes(arguments);
    expect_failure(result, 3, message);
    EXPECT_LT(result.peak_memory, idle + (30 << 20));
  };
  // 120 faces; the mesh of level 3 has 7680.
  refused(data_file("i_beam.toml"), {"--set", "mesh.levels=12"},
          "--set mesh.levels: level 4 would have 30720 elements and about 162105 unknowns");
  refused(data_file("i_beam.toml"), {"--set", "mesh.levels=12"},
          "500 MiB may be used; [mesh] levels = 3 is possible");
  std::string fine = pulled;
  fine.replace(fine.find("levels = 1"), 10, "levels = 12");
  const std::string file = folder.file("fine.toml", fine);
  refused(file, {}, file + ":3: level 7 would have 32768 elements");
  refused(data_file("l_shape.toml"),
          {"--set", "adapt.reference_levels=4", "--set", "mesh.levels=6"},
          "--set adapt.reference_levels: level ");
  EXPECT_FALSE(std::filesystem::exists(out));
}

// Five quads around a vertex: with no rings of tiles there the area is off by 3e-4.
TEST_F(Solve, WritesResultsAndFailsIfACheckFails) {
  std::string star = "v 0 0 0\n";
  std::string faces;
  for (int i = 0; i < 5; ++i) {
    const double a = i * 0.4 * std::numbers::pi;
    const double b = a + 0.2 * std::numbers::pi;
    star += fmt::format("v {} {} 0\nv {} {} 0\n", std::cos(a), std::sin(a), 1.3 * std::cos(b),
                        1.3 * std::sin(b));
    faces += fmt::format("f 1 {} {} {}\n", 2 + 2 * i, 3 + 2 * i, i < 4 ? 4 + 2 * i : 2);
  }
  (void)folder.file("star.obj", star + faces);
  const std::string file = folder.file("star.toml", R"([mesh]
file = "star.obj"
[material]
young = 1
poisson = 0.3
[model]
kind = "plane-stress"
quadrature_points = 2
quadrature_depth = 0
[[support]]
where = "vertex:1"
fix = ["ux", "uy"]
[[support]]
where = "vertex:3"
fix = ["ux", "uy"]
[[load]]
where = "all"
force_per_area = [0, -1]
)");
  const std::string out = folder / "out";
  const Result result = run_limes({"solve", file, "-o", out, "--json"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("a check of the solution failed: quadrature"), std::string::npos)
      << result.err;
  EXPECT_EQ(num_lines(result.err), 1) << result.err;
  for (const std::string& text : {result.out, read_file(out + "/result.json")})
    EXPECT_FALSE(Json::parse(text)["checks"].back()["passed"]);
  EXPECT_EQ(run_limes({"solve", file, "--set", "model.quadrature_depth=4"}).exit_code, 0);
}

TEST_F(Solve, RemarksOnAProbeFarFromTheSurface) {
  const Result result = run_limes({"solve", problem, "--json", "--set", "probe.0.at=[5, 5]"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(num_lines(result.err), 1) << result.err;
  EXPECT_NE(result.err.find("probe 'end' at (5, 5) is 5 away from the surface"), std::string::npos)
      << result.err;
}

TEST_F(Solve, HelpNamesTheFileOnly) {
  const std::string help = run_limes({"solve", "--help"}).out;
  EXPECT_NE(help.find("Usage: limes solve PROBLEM.toml [options]"), std::string::npos);
  EXPECT_EQ(help.find("TEXT"), std::string::npos);
}

TEST(SolveOutput, AFileIsNoFolder) {
  const TempFolder folder;
  const std::string file = folder.file("results", "precious");
  expect_failure(run_limes({"solve", data_file("block.toml"), "-o", file}), 5, "it is a file");
  EXPECT_EQ(read_file(file), "precious");
}

}  // namespace
}  // namespace limes::test
