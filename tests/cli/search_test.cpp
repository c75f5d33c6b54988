#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "limes/core/text.h"

// evaluate --closest and --ray.

namespace limes::test {
namespace {

Result search(const std::string& option, const std::string& mesh, const std::string& input,
              const std::string& output, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"evaluate", mesh,  "--scheme", "catmull-clark",
                                     option,     input, "-o",       output};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_limes(arguments);
}

const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const std::vector<std::string> with_corners{"--boundary", "edges-and-corners"};

/// The limit of one square with corners is the square.
TEST(Search, ClosestPointsOfASquare) {
  const TempFolder folder;
  const std::string mesh = folder.file("q.obj", square);
  const std::string points = folder.file("p.csv", "z,x,y,name\n2,0.25,0.5,a\n0,-3,0.5,b\n");
  ASSERT_EQ(search("--closest", mesh, points, folder / "o.csv", with_corners).exit_code, 0);
  EXPECT_EQ(read_file(folder / "o.csv"),
            "face,corner,u,v,x,y,z,distance\n0,0,0.25,0.5,0.25,0.5,0,2\n0,0,0,0.5,0,0.5,0,3\n");
  // the result is a table of points
  std::vector<std::string> at = {"evaluate",       mesh, "--scheme",      "catmull-clark", "--at",
                                 folder / "o.csv", "-o", folder / "v.csv"};
  at.insert(at.end(), with_corners.begin(), with_corners.end());
  EXPECT_EQ(run_limes(at).exit_code, 0);
}

TEST(Search, RaysAtASquare) {
  const TempFolder folder;
  const std::string mesh = folder.file("q.obj", square);
  const std::string rays = folder.file(
      "r.csv",
      "x,y,z,dx,dy,dz\n0.25,0.5,1,0,0,-2\n0.5,0.5,-1,0,0,1\n5,5,5,0,0,1\n0.5,0.5,-1,0,0,-1\n");
  std::vector<std::string> more = with_corners;
  more.emplace_back("--json");
  const Result run = search("--ray", mesh, rays, folder / "o.csv", more);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["rays"], 4);
  EXPECT_EQ(nlohmann::json::parse(run.out)["hits"], 2);
  EXPECT_EQ(read_file(folder / "o.csv"),
            "face,corner,u,v,x,y,z,t,side\n0,0,0.25,0.5,0.25,0.5,0,0.5,front\n"
            "0,0,0.5,0.5,0.5,0.5,0,1,back\n,,,,,,,,\n,,,,,,,,\n");
}

TEST(Search, SameBytesForAnyNumberOfThreads) {
  const TempFolder folder;
  std::string points = "x,y,z\n", rays = "x,y,z,dx,dy,dz\n";
  for (int i = 0; i < 3000; ++i) {
    const std::string p = format_real(i % 7 - 3.1) + "," + format_real(i % 11 - 5.2) + "," +
                          format_real(i % 13 - 6.3);
    points += p + "\n";
    rays += p + "," + format_real(i % 3 - 1.4) + "," + format_real(i % 5 - 2.6) + ",1\n";
  }
  const std::string point_file = folder.file("p.csv", points),
                    ray_file = folder.file("r.csv", rays);
  const std::string mesh = data_file("pawn.obj");
  for (const auto& [option, input] :
       {std::pair{"--closest", point_file}, std::pair{"--ray", ray_file}}) {
    ASSERT_EQ(search(option, mesh, input, folder / "1.csv", {"--threads", "1"}).exit_code, 0);
    ASSERT_EQ(search(option, mesh, input, folder / "2.csv", {"--threads", "2"}).exit_code, 0);
    EXPECT_TRUE(read_file(folder / "1.csv") == read_file(folder / "2.csv"));
    EXPECT_EQ(num_lines(read_file(folder / "1.csv")), 3001);
  }
}

TEST(Search, LeavesOutHolesAndDroppedFaces) {
  const TempFolder folder;
  // the upper face of the cube is a hole
  const std::string cube = data_file("cube.obj");
  const std::string points = folder.file("p.csv", "x,y,z\n0,0,9\n");
  ASSERT_EQ(search("--closest", cube, points, folder / "o.csv").exit_code, 0);
  const std::string whole = read_file(folder / "o.csv");
  const std::string face = whole.substr(whole.find('\n') + 1, 1);
  const std::string holed = folder.file("h.obj", read_file(cube) + "t hole 1/0/0 " + face + "\n");
  ASSERT_EQ(search("--closest", holed, points, folder / "o.csv").exit_code, 0);
  const std::string rest = read_file(folder / "o.csv");
  EXPECT_NE(rest.substr(rest.find('\n') + 1, 1), face);
  const std::string mesh = folder.file("q.obj", square);
  expect_failure(search("--closest", mesh, points, folder / "n.csv", {"--boundary", "none"}), 3,
                 "no face has a surface");
}

TEST(Search, NamesBadInputByItsLine) {
  const TempFolder folder;
  const std::string cube = data_file("cube.obj");
  const auto bad = [&](const std::string& option, const std::string& content,
                       const std::string& reason) {
    expect_failure(search(option, cube, folder.file("p.csv", content), folder / "o.csv"), 3,
                   reason);
  };
  bad("--closest", "x,y,z\n0,0,0\n1,nan,2\n", "p.csv:3: y is 'nan'; a number is right");
  bad("--closest", "x,y\n0,0\n", "p.csv:1: there is no column z; the head must name x,y,z");
  bad("--closest", "", "p.csv: empty; the first line must name x,y,z");
  bad("--ray", "x,y,z,dx,dy,dz\n1,2,3,0,0,0\n", "p.csv:2: (dx, dy, dz) is 0");
  bad("--ray", "x,y,z\n1,2,3\n", "p.csv:1: there is no column dx");
  const std::string points = folder.file("p.csv", "x,y,z\n0,0,0\n");
  expect_failure(search("--closest", cube, points, folder / "o.csv", {"--ray", points}), 2,
                 "2 of --at, --closest and --ray are given; one is right");
  expect_failure(run_limes({"evaluate", cube, "--scheme", "catmull-clark", "-o", folder / "o.csv"}),
                 2, "0 of --at, --closest and --ray are given");
}

}  // namespace
}  // namespace limes::test
