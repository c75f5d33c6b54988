#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.h"
#include "limes/core/text.h"
#include "limes/io/io.h"
#include "limes/mesh/measure.h"

namespace limes::test {
namespace {

/// True at all corners of the control faces of the cube, then at the quarter of its upper face around
/// the corner (1, 1, 1): one uniform step, then one family on each level.
const char* const corner_of_cube =
    "(abs(x) == 1 and abs(y) == 1 and abs(z) == 1) or (z == 1 and x >= 0 and y >= 0)";

std::vector<std::string> adapt(const std::string& mesh, const std::string& output,
                               const std::string& scheme, const std::string& where,
                               const std::string& levels) {
  return {"adapt",   data_file(mesh), "-o",       output, "--scheme", scheme,
          "--where", where,           "--levels", levels, "--json"};
}

/// Counts of another program, tests/data/interpolatory/README.md.
TEST(Adapt, CountsOnACubeAreThoseOfAnotherProgram) {
  const TempFolder folder;
  const Result two =
      run_limes(adapt("cube.obj", folder / "two.ply", "linear", corner_of_cube, "2"));
  ASSERT_EQ(two.exit_code, 0) << two.err;
  auto json = nlohmann::json::parse(two.out);
  EXPECT_EQ(json["leaves"], 36);
  EXPECT_EQ(json["faces"], 52);
  EXPECT_EQ(json["vertices"], 54);
  EXPECT_EQ(json["hanging_vertices"], 0);

  const Result three =
      run_limes(adapt("cube.obj", folder / "three.ply", "linear", corner_of_cube, "3"));
  ASSERT_EQ(three.exit_code, 0) << three.err;
  json = nlohmann::json::parse(three.out);
  EXPECT_EQ(json["leaves"], 72);
  EXPECT_EQ(json["leaves_by_level"], nlohmann::json({0, 12, 44, 16}));
  EXPECT_EQ(json["faces"], 109);
  EXPECT_EQ(json["vertices"], 111);
  const Mesh mesh = read_mesh(folder / "three.ply").mesh;
  EXPECT_EQ(mesh.topology.num_faces(), 109);
  EXPECT_EQ(measure(mesh).euler, 2);
  EXPECT_NEAR(measure(mesh).area, 24, 1e-12);
}

/// With `all`, the file of refine, but for the numbers of the vertices.
TEST(Adapt, AllIsUniformRefinement) {
  const TempFolder folder;
  for (const char* scheme : {"kobbelt", "linear"}) {
    ASSERT_EQ(run_limes(adapt("torus.obj", folder / "a.ply", scheme, "all", "2")).exit_code, 0);
    ASSERT_EQ(run_limes({"refine", data_file("torus.obj"), "-o", folder / "r.ply", "--scheme",
                         scheme, "--levels", "2"})
                  .exit_code,
              0);
    const Mesh ours = read_mesh(folder / "a.ply").mesh, uniform = read_mesh(folder / "r.ply").mesh;
    ASSERT_EQ(ours.topology.num_faces(), uniform.topology.num_faces());
    for (int f = 0; f < ours.topology.num_faces(); ++f)
      for (std::size_t i = 0; i < 4; ++i)
        ASSERT_EQ(ours.points[ours.topology.face(FaceId(f))[i]],
                  uniform.points[uniform.topology.face(FaceId(f))[i]]);
  }
}

/// Lines of an ASCII ply file's faces: their properties after the corners.
TEST(Adapt, KeepsAncestryInFiles) {
  const TempFolder folder;
  ASSERT_EQ(run_limes(adapt("cube.obj", folder / "a.ply", "linear", corner_of_cube, "2")).exit_code,
            0);
  const std::string header = read_file(folder / "a.ply").substr(0, 500);
  for (const char* field : {"root", "level", "path"})
    EXPECT_NE(header.find(field), std::string::npos) << header;
  ASSERT_EQ(run_limes(adapt("cube.obj", folder / "a.vtu", "linear", corner_of_cube, "2")).exit_code,
            0);
  const std::string vtu = read_file(folder / "a.vtu");
  for (const char* field : {"Name=\"root\"", "Name=\"level\"", "Name=\"path\""})
    EXPECT_NE(vtu.find(field), std::string::npos);
  const Result obj = run_limes(adapt("cube.obj", folder / "a.obj", "linear", "all", "1"));
  EXPECT_NE(obj.err.find("keeps no root, level and path"), std::string::npos) << obj.err;
}

/// The other two closures: triangles, or vertices inside sides and where these lie.
TEST(Adapt, ClosesAsAsked) {
  const TempFolder folder;
  auto arguments = adapt("cube.obj", folder / "a.ply", "linear", corner_of_cube, "3");
  arguments.insert(arguments.end(), {"--closure", "triangles"});
  ASSERT_EQ(run_limes(arguments).exit_code, 0);
  const Mesh closed = read_mesh(folder / "a.ply").mesh;
  EXPECT_EQ(measure(closed).euler, 2);
  EXPECT_EQ(measure(closed).boundary_loops, 0);
  EXPECT_NEAR(measure(closed).area, 24, 1e-12);

  arguments.back() = "hanging";
  arguments.insert(arguments.end(), {"--constraints", folder / "a.csv"});
  const Result hanging = run_limes(arguments);
  ASSERT_EQ(hanging.exit_code, 0) << hanging.err;
  const Mesh open = read_mesh(folder / "a.ply").mesh;
  const std::string csv = read_file(folder / "a.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "vertex,end0,end1");
  EXPECT_EQ(num_lines(csv) - 1, nlohmann::json::parse(hanging.out)["hanging_vertices"].get<int>());
  std::size_t start = csv.find('\n') + 1;
  int rows = 0;
  while (start < csv.size()) {
    int v = 0, a = 0, b = 0;
    ASSERT_EQ(std::sscanf(csv.c_str() + start, "%d,%d,%d", &v, &a, &b), 3);
    EXPECT_EQ(open.points[VertexId(v)],
              0.5 * (open.points[VertexId(a)] + open.points[VertexId(b)]));
    start = csv.find('\n', start) + 1;
    ++rows;
  }
  EXPECT_GT(rows, 0);
}

TEST(Adapt, BytesDoNotDependOnThreads) {
  const TempFolder folder;
  for (const char* threads : {"1", "4"}) {
    auto arguments = adapt("torus.obj", folder / (std::string(threads) + ".vtu"), "catmull-clark",
                           "x > 0.5 and y > -1", "3");
    arguments.insert(arguments.end(), {"--threads", threads});
    ASSERT_EQ(run_limes(arguments).exit_code, 0);
  }
  EXPECT_EQ(read_file(folder / "1.vtu"), read_file(folder / "4.vtu"));
}

TEST(Adapt, RefusesWhatMeansNoFace) {
  const TempFolder folder;
  const std::string out = folder / "x.ply";
  expect_failure(run_limes(adapt("torus.obj", out, "catmull-clark", "x > 9", "2")), 3,
                 "means no vertex; on the limit surface the mesh has x from -2.36872");
  expect_failure(run_limes(adapt("cube.obj", out, "linear", "x > 0 and y > 0", "2")), 3,
                 "means 2 of the vertices but no face");
  expect_failure(run_limes(adapt("pawn.obj", out, "linear", "group:head", "2")), 3,
                 "the mesh has no groups");
  expect_failure(run_limes(adapt("cube.obj", out, "linear", "sqrt(x)", "2")), 3, "has no value at");
  EXPECT_TRUE(folder.list().empty());
}

/// What is meant at first may have gone when faces are smaller: a remark, and the rest is written.
TEST(Adapt, SaysWhenNothingIsLeftToSplit) {
  const TempFolder folder;
  const Result result =
      run_limes(adapt("cube.obj", folder / "x.ply", "linear", "abs(x * y * z) == 1", "4"));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("nothing was split from round 2 on"), std::string::npos) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["leaves"], 24);
}

TEST(Adapt, RefusesWhatItCannotTake) {
  const TempFolder folder;
  const std::string out = folder / "x.ply";
  expect_failure(run_limes(adapt("rook.obj", out, "catmull-clark", "x > 0", "2")), 3,
                 "rook.obj:1418: face 640 has 3 corners; local refinement needs quads");
  expect_failure(run_limes(adapt("cube.obj", out, "loop", "x > 0", "2")), 3,
                 "cube.obj:11: face 0 has 4 corners; local refinement by loop needs triangles");
  expect_failure(
      run_limes(adapt("rook.obj", out, "linear", "x > 0", "2")), 3,
      "rook.obj:1418: face 640 has 3 corners; local refinement needs quads, which one step of "
      "refine makes, or triangles only");
  expect_failure(run_limes(adapt("gallery/torus.obj", out, "kobbelt", "x > 0", "2")), 3,
                 "face 0 has 3 corners");
  expect_failure(run_limes(adapt("cube.obj", out, "four-eight", "x > 0", "2")), 2,
                 "--scheme linear --bisect splits the same way");
  expect_failure(run_limes(adapt("gallery/torus.obj", out, "sqrt3", "x > 0", "2")), 2,
                 "--scheme: sqrt3 does not split faces into four");
  expect_failure(run_limes(adapt("cube.obj", out, "linear", "x >", "2")), 2, "--where: formula");
  expect_failure(run_limes(adapt("cube.obj", out, "linear", "boundary", "2")), 2,
                 "--where: 'boundary' means vertices");
  expect_failure(run_limes(adapt("cube.obj", out, "linear", "all", "27")), 2,
                 "--levels: 27 is more than 26");
  expect_failure(run_limes(adapt("missing.obj", out, "linear", "all", "2")), 3, "missing.obj");
  auto with = [&](const std::vector<std::string>& more) {
    auto arguments = adapt("cube.obj", out, "catmull-clark", "all", "1");
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_limes(arguments);
  };
  expect_failure(with({"--boundary", "none"}), 2, "--boundary: rule none drops faces");
  expect_failure(with({"--boundary", "biermann"}), 2, "--boundary");
  expect_failure(with({"--closure", "none"}), 2, "known are conforming, triangles, hanging");
  expect_failure(with({"--constraints", folder / "c.csv"}), 2, "--constraints");
  EXPECT_TRUE(folder.list().empty());
}

TEST(Adapt, RefusesARoundThatDoesNotFit) {
  const TempFolder folder;
  const auto refused = [&](const std::string& where, const char* scheme,
                           const std::vector<std::string>& more, const std::string& reason) {
    auto arguments = adapt("torus.obj", folder / "x.ply", scheme, where, "26");
    arguments.insert(arguments.end(), {"--memory-limit", "100M"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = run_limes(arguments);
    expect_failure(result, 3, data_file("torus.obj") + ": round " + reason);
    return result.peak_memory;
  };
  const std::int64_t idle = run_limes({"schemes"}).peak_memory;
  // 48 faces; all at once is refused before the first split.
  EXPECT_LT(refused("all", "kobbelt", {}, "7 would have 786432 faces or more: that takes about "),
            idle + (15 << 20));
  EXPECT_LT(refused("all", "linear", {"--bisect"}, "13 would have 786432 faces or more"),
            idle + (15 << 20));
  refused("x < 1e9", "linear", {}, "7 would have 786432 faces or more");
  refused("x > 0", "catmull-clark", {"--closure", "triangles"}, "");
  EXPECT_TRUE(folder.list().empty());
}

/// The table of hanging vertices fits where the mesh does not: neither appears.
TEST(Adapt, WritesMeshAndConstraintsOrNeither) {
  const TempFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{4096, before.rlim_max};
  auto arguments = adapt("cube.obj", folder / "x.obj", "linear", "x == 1", "4");
  arguments.insert(arguments.end(), {"--closure", "hanging", "--constraints", folder / "x.csv"});
  setrlimit(RLIMIT_FSIZE, &small);  // the program inherits it
  const Result result = run_limes(arguments);
  setrlimit(RLIMIT_FSIZE, &before);
  expect_failure(result, 5, "x.obj: cannot be written: File too large");
  EXPECT_TRUE(folder.list().empty());
  ASSERT_EQ(run_limes(arguments).exit_code, 0);
  EXPECT_EQ(folder.list(), (std::vector<std::string>{"x.csv", "x.obj"}));
  EXPECT_LT(read_file(folder / "x.csv").size(), 4096U);
}

TEST(Adapt, RefusesARuleOfTheFileThatDropsFaces) {
  const TempFolder folder;
  const std::string mesh = folder.file(
      "open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nt interpolateboundary 1/0/0 0\n");
  expect_failure(run_limes({"adapt", mesh, "-o", folder / "x.ply", "--scheme", "catmull-clark",
                            "--where", "all", "--levels", "1"}),
                 3, "boundary rule none drops faces");
  EXPECT_EQ(run_limes({"adapt", mesh, "-o", folder / "x.ply", "--scheme", "catmull-clark",
                       "--where", "all", "--levels", "1", "--boundary", "edges"})
                .exit_code,
            0);
}

int faces_of_size(const Mesh& mesh, int size) {
  int count = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    count += mesh.topology.face_size(FaceId(f)) == size ? 1 : 0;
  return count;
}

/// Red-green refinement by each scheme; with `all` the mesh of refine, on its limit.
TEST(Adapt, RefinesTriangles) {
  const TempFolder folder;
  for (const char* scheme : {"loop", "butterfly", "linear"}) {
    const Result result =
        run_limes(adapt("gallery/torus.obj", folder / "a.ply", scheme, "x > 0.5 and z > -1", "3"));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Mesh mesh = read_mesh(folder / "a.ply").mesh;
    EXPECT_EQ(faces_of_size(mesh, 3), mesh.topology.num_faces());
    EXPECT_GT(nlohmann::json::parse(result.out)["leaves"], 96);
    EXPECT_EQ(measure(mesh).euler, 0);
    EXPECT_EQ(measure(mesh).boundary_loops, 0);
  }
  ASSERT_EQ(run_limes(adapt("gallery/torus.obj", folder / "a.ply", "loop", "all", "2")).exit_code,
            0);
  ASSERT_EQ(run_limes({"refine", data_file("gallery/torus.obj"), "-o", folder / "r.ply", "--scheme",
                       "loop", "--levels", "2", "--limit"})
                .exit_code,
            0);
  const Mesh ours = read_mesh(folder / "a.ply").mesh, uniform = read_mesh(folder / "r.ply").mesh;
  ASSERT_EQ(ours.topology.num_faces(), uniform.topology.num_faces());
  for (int f = 0; f < ours.topology.num_faces(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      ASSERT_LE((ours.points[ours.topology.face(FaceId(f))[i]] -
                 uniform.points[uniform.topology.face(FaceId(f))[i]])
                    .norm(),
                1e-14);
}

TEST(Adapt, LeavesVerticesOfTrianglesHanging) {
  const TempFolder folder;
  auto arguments = adapt("gallery/torus.obj", folder / "a.ply", "loop", "x > 0.5 and z > -1", "2");
  arguments.insert(arguments.end(), {"--closure", "hanging", "--constraints", folder / "a.csv"});
  const Result result = run_limes(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["faces"], json["leaves"]);
  EXPECT_GT(json["hanging_vertices"], 0);
  const std::string rows = read_file(folder / "a.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + json["hanging_vertices"].get<int>());
  EXPECT_EQ(rows.find("vertex,end0,end1\n"), 0U);
}

/// Each quad of a cube becomes four triangles, which are then halved across its sides.
TEST(Adapt, Bisects) {
  const TempFolder folder;
  auto arguments = adapt("cube.obj", folder / "a.ply", "linear", "all", "2");
  arguments.emplace_back("--bisect");
  ASSERT_EQ(run_limes(arguments).exit_code, 0);
  const Mesh all = read_mesh(folder / "a.ply").mesh;
  EXPECT_EQ(all.topology.num_faces(), 48);
  EXPECT_EQ(all.topology.num_vertices(), 8 + 6 + 12);

  arguments = adapt("cube.obj", folder / "b.vtu", "linear", corner_of_cube, "12");
  arguments.emplace_back("--bisect");
  const Result local = run_limes(arguments);
  ASSERT_EQ(local.exit_code, 0) << local.err;
  EXPECT_EQ(nlohmann::json::parse(local.out)["hanging_vertices"], 0);

  arguments.insert(arguments.end(), {"--closure", "hanging"});
  expect_failure(run_limes(arguments), 2, "bisection leaves nothing to close");
  arguments = adapt("gallery/torus.obj", folder / "b.vtu", "loop", "all", "2");
  arguments.emplace_back("--bisect");
  expect_failure(run_limes(arguments), 2, "--bisect: halves are placed by the scheme linear only");
  arguments = adapt("cube.obj", folder / "b.vtu", "linear", "all", "41");
  arguments.emplace_back("--bisect");
  expect_failure(run_limes(arguments), 2, "--levels: 41 is more than 40");
}

/// Work that would take minutes ends soon, and leaves nothing behind.
TEST(Adapt, CanBeInterrupted) {
  const TempFolder folder;
  const Result result = run_limes(adapt("torus.obj", folder / "x.ply", "kobbelt", "x > 0", "9"),
                                  std::chrono::milliseconds(50));
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_TRUE(folder.list().empty());
}

}  // namespace
}  // namespace limes::test
