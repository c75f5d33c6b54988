#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "limes/io/io.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

Result refine(const std::string& mesh, const std::string& out, int levels,
              const Arguments& more = {}, std::chrono::milliseconds signal_after = {},
              int signal = SIGINT) {
  Arguments arguments{
      "refine", mesh, "-o", out, "--scheme", "catmull-clark", "--levels", std::to_string(levels)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_limes(arguments, signal_after, signal);
}

TEST(Refine, ReportsCountsAsJsonOnly) {
  const TempFolder folder;
  const Result result = refine(data_file("cube.obj"), folder / "fine.obj", 3, {"--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json.size(), 5U);
  EXPECT_EQ(json["faces"], 6 * 64);
  EXPECT_EQ(json["vertices"], 6 * 64 + 2);  // Euler
  EXPECT_EQ(json["levels"], 3);
  EXPECT_GE(json["seconds"], 0.0);
  EXPECT_GT(json["peak_memory"], 1000000);
}

TEST(Refine, PutsVerticesWhereTheRuleSays) {
  const TempFolder folder;
  ASSERT_EQ(refine(data_file("cube.obj"), folder / "fine.obj", 1).exit_code, 0);
  const Mesh mesh = read_mesh(folder / "fine.obj").mesh;
  // Corner (-1,-1,-1) with n = 3: 1/3 (mean of face points) + 2/3 (mean of edge midpoints) = -5/9.
  EXPECT_LT((mesh.points[VertexId(0)] - Vec3::Constant(-5.0 / 9.0)).norm(), 1e-15);
  ASSERT_EQ(mesh.parts.size(), 1U);
  EXPECT_EQ(mesh.parts[0].name, "cube");
  EXPECT_EQ(mesh.parts[0].faces.size(), 24U);
}

TEST(Refine, LimitOfTheCubeIsKnown) {
  const TempFolder folder;
  // Limit of a vertex with n edges: (n^2 V + 4 sum E + sum F) / (n (n + 5)), where E are its
  // neighbours and F the opposite corners of its faces [halstead_1993]. For (-1,-1,-1) every
  // coordinate is (-9 - 4 + 1) / 24 = -1/2.
  for (int levels : {0, 1, 3}) {
    ASSERT_EQ(refine(data_file("cube.obj"), folder / "l.obj", levels, {"--limit"}).exit_code, 0);
    const Mesh mesh = read_mesh(folder / "l.obj").mesh;
    EXPECT_LT((mesh.points[VertexId(0)] - Vec3::Constant(-0.5)).norm(), 1e-14) << levels;
  }
  // With quarters (4 V + 4 mean of E + mean of F) / 9 for every n: (-4 - 4/3 + 1/3) / 9 = -5/9.
  for (int levels : {0, 2}) {
    ASSERT_EQ(refine(data_file("cube.obj"), folder / "q.obj", levels,
                     {"--limit", "--weights", "quarters"})
                  .exit_code,
              0);
    const Mesh mesh = read_mesh(folder / "q.obj").mesh;
    EXPECT_LT((mesh.points[VertexId(0)] - Vec3::Constant(-5.0 / 9)).norm(), 1e-14) << levels;
  }
}

TEST(Refine, LimitWithoutBoundaryFacesMatchesTheLimitWithThem) {
  // 5 x 5 faces: dropping the outer ones leaves 3 x 3, whose limit is the same bicubic surface.
  const TempFolder folder;
  std::string obj;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i)
      obj += "v " + std::to_string(i) + " " + std::to_string(j) + " " +
             std::to_string((i * i + 3 * i * j) % 5) + "\n";
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) {
      const int v = 6 * j + i + 1;
      obj += "f " + std::to_string(v) + " " + std::to_string(v + 1) + " " + std::to_string(v + 7) +
             " " + std::to_string(v + 6) + "\n";
    }
  const std::string mesh = folder.file("grid.obj", obj);
  for (const int levels : {0, 1, 2}) {
    ASSERT_EQ(
        refine(mesh, folder / "none.obj", levels, {"--limit", "--boundary", "none"}).exit_code, 0);
    ASSERT_EQ(refine(mesh, folder / "all.obj", levels, {"--limit"}).exit_code, 0);
    const Mesh none = read_mesh(folder / "none.obj").mesh;
    const Mesh all = read_mesh(folder / "all.obj").mesh;
    ASSERT_EQ(none.topology.num_faces(), 9 << (2 * levels));
    // Every vertex that is left lies exactly on one of the full surface.
    for (const Vec3& x : none.points) {
      double nearest = 1;
      for (const Vec3& y : all.points)
        nearest = std::min(nearest, (x - y).norm());
      EXPECT_LT(nearest, 1e-14);
    }
  }
}

TEST(Refine, LevelZeroConvertsBetweenAllFormats) {
  const TempFolder folder;
  const Mesh torus = read_mesh(data_file("torus.obj")).mesh;
  for (const Format& from : all_formats) {
    if (!from.read) continue;
    const std::string source = folder / ("source" + std::string(from.extension));
    ASSERT_EQ(refine(data_file("torus.obj"), source, 0).exit_code, 0);
    for (const Format& to : all_formats) {
      const std::string target = folder / ("target" + std::string(to.extension));
      ASSERT_EQ(refine(source, target, 0).exit_code, 0) << from.extension << to.extension;
      if (!to.read) continue;
      const Mesh mesh = read_mesh(target).mesh;
      const bool stl = from.extension == ".stl" || to.extension == ".stl";
      EXPECT_EQ(mesh.topology.num_vertices(), 48) << from.extension << to.extension;
      EXPECT_EQ(mesh.topology.num_faces(), stl ? 96 : 48) << from.extension << to.extension;
      if (stl) continue;
      EXPECT_EQ(mesh.points, torus.points) << from.extension << to.extension;
      EXPECT_EQ(mesh.topology, torus.topology) << from.extension << to.extension;
    }
  }
}

TEST(Refine, KeepsTagsAtLevelZeroAndDecaysThemBelow) {
  const TempFolder folder;
  const std::string mesh = folder.file(
      "m.obj", read_file(data_file("cube.obj")) +
                   "t interpolateboundary 1/0/0 1\nt crease 2/1/0 0 1 2.5\nt corner 1/1/0 6 10\n");
  ASSERT_EQ(refine(mesh, folder / "0.obj", 0).exit_code, 0);
  const Tags same = read_mesh(folder / "0.obj").mesh.tags;
  EXPECT_EQ(same.creases, (std::vector<CreaseTag>{{VertexId(0), VertexId(1), 2.5F}}));
  EXPECT_EQ(same.boundary, BoundaryRule::edges_and_corners);

  ASSERT_EQ(refine(mesh, folder / "1.obj", 1).exit_code, 0);
  const Tags finer = read_mesh(folder / "1.obj").mesh.tags;
  ASSERT_EQ(finer.creases.size(), 2U);
  EXPECT_EQ(finer.creases[0].sharpness, 1.5F);
  EXPECT_EQ(finer.corners, (std::vector<CornerTag>{{VertexId(6), 10.0F}}));
  EXPECT_EQ(finer.boundary, BoundaryRule::edges_and_corners);
}

TEST(Refine, SameBytesForAnyNumberOfThreads) {
  const TempFolder folder;
  for (const char* file : {"rook.obj", "pawn.obj"}) {
    ASSERT_EQ(refine(data_file(file), folder / "1.obj", 3, {"--threads", "1"}).exit_code, 0);
    ASSERT_EQ(refine(data_file(file), folder / "2.obj", 3, {"--threads", "2"}).exit_code, 0);
    EXPECT_TRUE(read_file(folder / "1.obj") == read_file(folder / "2.obj")) << file;
  }
}

TEST(Refine, RefusesWhatCannotFitBeforeItStarts) {
  const TempFolder folder;
  expect_failure(refine(data_file("cube.obj"), folder / "x.obj", 15, {"--memory-limit", "900G"}), 3,
                 "at most 536870911 faces can be numbered; --levels 13 is possible");
  expect_failure(refine(data_file("cube.obj"), folder / "x.obj", 2000000000), 3, "is possible");
  expect_failure(refine(data_file("cube.obj"), folder / "x.obj", 10, {"--memory-limit", "200M"}), 3,
                 "200 MiB may be used; --levels 9 is possible");
  EXPECT_TRUE(folder.list().empty());
}

TEST(Refine, KeepsToTheMemoryLimitItAccepted) {
  const TempFolder folder;
  const auto keeps = [&](const std::string& output, int levels, int mebibytes,
                         const Arguments& more) {
    Arguments options{"--memory-limit", std::to_string(mebibytes) + "M", "--json"};
    options.insert(options.end(), more.begin(), more.end());
    const Result result = refine(data_file("cube.obj"), folder / output, levels, options);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_LT(Json::parse(result.out)["peak_memory"], mebibytes << 20);
  };
  keeps("x.ply", 8, 130, {});
  keeps("x.ply", 8, 130, {"--limit"});
  keeps("x.vtu", 8, 130, {});
  keeps("x.ply", 9, 200, {});
}

TEST(Refine, BadInputIsNamedWithItsLine) {
  const TempFolder folder;
  expect_failure(refine(folder / "none.obj", folder / "x.obj", 1), 3, "no such file");
  const std::string broken = folder.file("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 zero\nf 1 2 3\n");
  expect_failure(refine(broken, folder / "x.obj", 1), 3, broken + ":3:");
  const std::string fan = folder.file(
      "fan.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  expect_failure(refine(fan, folder / "x.obj", 1), 3, fan + ":");
  EXPECT_EQ(folder.list(), (std::vector<std::string>{"broken.obj", "fan.obj"}));
}

TEST(Refine, FacesAreNamedWithTheirLines) {
  const TempFolder folder;
  const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\nf 1 2 3 4\n";
  const std::string mesh = folder.file("quad.obj", quad);
  expect_failure(
      run_limes({"refine", mesh, "-o", folder / "x.obj", "--scheme", "loop", "--levels", "1"}), 3,
      mesh + ":6: face 0 has 4 corners; loop takes faces with 3 only");
  expect_failure(run_limes({"limit", mesh, "-o", folder / "x.vtu", "--scheme", "loop"}), 3,
                 mesh + ":6: face 0 has 4 corners; loop takes faces with 3 only");
  const std::string twice = folder.file("twice.obj", quad + "# again\nf 2 3 4 1\n");
  expect_failure(refine(twice, folder / "x.obj", 1), 3,
                 twice + ":8: face 1 repeats face 0 (line 6); --repair leaves one of them out");
}

TEST(Refine, RepairMendsWhatItCanAndSaysSo) {
  const TempFolder folder;
  const std::string twice =
      folder.file("twice.obj", read_file(data_file("cube.obj")) + "f 1 4 3 2\n");
  expect_failure(refine(twice, folder / "x.obj", 1), 3, "twice.obj:");
  const Result result = refine(twice, folder / "x.obj", 1, {"--repair", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("repaired: "), std::string::npos) << result.err;
  EXPECT_EQ(Json::parse(result.out)["faces"], 24);
}

TEST(Refine, OutputThatCannotBeWrittenIsCodeFive) {
  const TempFolder folder;
  expect_failure(refine(data_file("cube.obj"), "/nonexistent/x.obj", 1), 5,
                 "/nonexistent/x.obj: cannot be written: there is no folder");
  std::filesystem::create_directory(folder / "dir.obj");
  expect_failure(refine(data_file("cube.obj"), folder / "dir.obj", 1), 5, "it is a directory");
  // Known before the mesh is read.
  expect_failure(refine(folder / "none.obj", folder / "dir.obj", 1), 5, "it is a directory");
}

TEST(Refine, AFileThatMayNotGrowIsCodeFive) {
  const TempFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{4096, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);  // the program inherits it
  const Result result = refine(data_file("cube.obj"), folder / "x.obj", 4);
  setrlimit(RLIMIT_FSIZE, &before);
  expect_failure(result, 5, "x.obj: cannot be written: File too large");
  EXPECT_TRUE(folder.list().empty());
}

// Limits and the text of 1.6 million vertices take seconds; the signal comes in the first tenth of one.
TEST(Refine, SignalsLeaveNoFile) {
  for (const int signal : {SIGINT, SIGHUP, SIGTERM}) {
    const TempFolder folder;
    const Result result = refine(data_file("cube.obj"), folder / "x.obj", 9, {"--limit"},
                                 std::chrono::milliseconds(50), signal);
    expect_failure(result, 130, "interrupted");
    EXPECT_TRUE(folder.list().empty());
  }
}

}  // namespace
}  // namespace limes::test
