#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "limes/io/io.h"

// `refine` with the 4-8 schemes.

namespace limes::test {
namespace {

using Arguments = std::vector<std::string>;

Result refine(const std::string& mesh, const std::string& out, const Arguments& more) {
  Arguments arguments{"refine", mesh, "-o", out, "--scheme", "quasi-four-eight"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_limes(arguments);
}

std::string write(const TempFolder& folder, const char* text) {
  std::ofstream(folder / "in.obj") << text;
  return folder / "in.obj";
}

constexpr const char* tetrahedron =
    "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
constexpr const char* hexagon =
    "v 0 0 0\nv 2 0 0\nv 1 2 0\nv -1 2 0\nv -2 0 0\nv -1 -2 0\nv 1 -2 0\n"
    "f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 6\nf 1 6 7\nf 1 7 2\n";

TEST(QuasiFourEight, SaysWhatItCutsAndLeavesWhole) {
  const TempFolder folder;
  const Result result =
      refine(data_file("pawn.obj"), folder / "o.obj", {"--levels", "3", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["levels"], 3);
  EXPECT_NE(result.err.find("cut along short diagonals: "), std::string::npos) << result.err;
  const auto at = result.err.find("all their edges were taken: ");
  ASSERT_NE(at, std::string::npos) << result.err;
  // What was said adds up: a step doubles the faces but for those left whole.
  std::istringstream numbers(result.err.substr(at + 28));
  const Result cut = refine(data_file("pawn.obj"), folder / "cut.obj", {"--levels", "1", "--json"});
  std::istringstream first(cut.err.substr(cut.err.find("taken: ") + 7));
  int whole = 0, first_whole = 0;
  first >> first_whole;
  int faces = nlohmann::json::parse(cut.out)["faces"];
  numbers >> whole;
  EXPECT_EQ(whole, first_whole);
  while (numbers >> whole)
    faces = 2 * faces - whole;
  EXPECT_EQ(json["faces"], faces);
}

TEST(QuasiFourEight, ATetrahedronIsRefinedAndRemarkedOn) {
  const TempFolder folder;
  const Result result = refine(write(folder, tetrahedron), folder / "o.obj", {"--levels", "4"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("the refined surface encloses no volume"), std::string::npos);
  EXPECT_EQ(read_mesh(folder / "o.obj").mesh.topology.num_faces(), 64);
}

TEST(QuasiFourEight, ItsOptionsChangeTheSurface) {
  const TempFolder folder;
  const std::string mesh = write(folder, hexagon);
  const auto boundary_x = [&](const Arguments& more) {
    Arguments arguments{"--levels", "4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = refine(mesh, folder / "o.obj", arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_mesh(folder / "o.obj").mesh.points[VertexId(1)].x();
  };
  EXPECT_EQ(boundary_x({}), 2);  // flat: the boundary moves along the normal only
  EXPECT_EQ(boundary_x({"--boundary", "curve-normal"}), 2);
  EXPECT_EQ(boundary_x({"--boundary", "fixed"}), 2);
  EXPECT_LT(boundary_x({"--boundary", "curve"}), 1.95);
}

TEST(QuasiFourEight, RefusesWhatItCannotDo) {
  const TempFolder folder;
  const std::string mesh = write(folder, hexagon), out = folder / "o.obj";
  const auto fails = [&](const Arguments& more, int code, const char* message) {
    const Result result = refine(mesh, out, more);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  };
  fails({"--levels", "1", "--boundary", "edges"}, 2, "known are curve-normal, curve, fixed");
  fails({"--levels", "1", "--tags", "x"}, 2, "known are held, curves");
  fails({"--levels", "1", "--split", "x"}, 2, "known are longest, interleaved, normal");
  fails({"--levels", "1", "--split", "normal"}, 3, "vertex 0 has 6 edges");
  fails({"--levels", "1", "--limit"}, 3, "quasi-four-eight");
  fails({"--levels", "60"}, 3, "is possible");
  EXPECT_EQ(
      run_limes({"refine", mesh, "-o", out, "--scheme", "loop", "--levels", "1", "--tags", "held"})
          .exit_code,
      2);
  const std::string three =
      write(folder, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  EXPECT_EQ(refine(three, out, {"--levels", "1"}).exit_code, 3);
}

TEST(QuasiFourEight, BytesDoNotDependOnThreads) {
  const TempFolder folder;
  for (const char* scheme : {"quasi-four-eight", "four-eight"}) {
    const auto bytes = [&](const char* threads) {
      const std::string out = folder / (std::string(scheme) + threads + ".ply");
      const Result result = run_limes({"refine", data_file("torus.obj"), "-o", out, "--scheme",
                                       scheme, "--levels", "6", "--threads", threads});
      EXPECT_EQ(result.exit_code, 0) << result.err;
      std::ifstream file(out, std::ios::binary);
      return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string one = bytes("1");
    EXPECT_FALSE(one.empty());
    EXPECT_EQ(one, bytes("2"));
  }
}

}  // namespace
}  // namespace limes::test
