#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;

const std::string square =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
    "f 1 2 5 4\nf 2 3 6 5\nt interpolateboundary 1/0/0 1\n";

const std::string pulled = R"([mesh]
file = "square.obj"
levels = 1
[material]
young = 10
poisson = 0.25
[model]
kind = "plane-stress"
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "vertex:0"
fix = ["uy"]
[[load]]
where = "x == 2"
force_per_length = [1, 0]
[[probe]]
name = "end"
at = [2, 1, 0]
)";

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
  EXPECT_NE(read_file(out + "/result.vtu").find("von_mises"), std::string::npos);
  for (const char* picture : {"control-mesh.png", "stress-xx.png", "von-mises.png"})
    EXPECT_EQ(read_file(out + "/" + picture).substr(1, 3), "PNG") << picture;
}

TEST_F(Solve, GivesTheSameBytesForAnyNumberOfThreads) {
  const std::string block = data_file("block.toml");
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(run_limes({"solve", block, "-o", folder / threads, "--threads", threads}).exit_code,
              0);
  for (const char* name : {"/result.vtu", "/stress-xx.png"})
    EXPECT_EQ(read_file(folder / "1" + name), read_file(folder / "2" + name)) << name;
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
  expect_failure(run_limes({"solve", problem, "--set", "support.0.fix=[\"uy\"]"}), 3,
                 "can still move along x");
  expect_failure(run_limes({"solve", problem, "--set", "load.0.where=x == 9"}), 3, "x == 9");
  expect_failure(run_limes({"solve", problem, "--set", "support.0.fix=[\"uz\"]"}), 3, "uz");
  const std::string blocked = folder.file("blocked", "a file, no folder");
  expect_failure(run_limes({"solve", problem, "-o", blocked + "/out"}), 5, "cannot be made");
}

}  // namespace
}  // namespace limes::test
