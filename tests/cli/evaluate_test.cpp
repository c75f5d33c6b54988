#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"
#include "limes/core/text.h"

namespace limes::test {
namespace {

Result evaluate(const std::string& mesh, const std::string& points, const std::string& out,
                const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"evaluate", mesh, "--at", points, "-o", out, "--scheme"};
  const bool has_scheme = !more.empty() && more[0] == "linear";
  arguments.push_back(has_scheme ? "linear" : "catmull-clark");
  arguments.insert(arguments.end(), more.begin() + (has_scheme ? 1 : 0), more.end());
  return run_limes(arguments);
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result(1);
  for (const char c : line)
    if (c == ',')
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(stream, line);)
    result.push_back(line);
  return result;
}

double number(const std::string& field) {
  const auto value = parse_real(field);
  EXPECT_TRUE(value.has_value()) << field;
  return value.value_or(std::nan(""));
}

TEST(Evaluate, KnownPointsOfTheCube) {
  const TempFolder folder;
  const std::string points = folder.file("p.csv", "face,corner,u,v\n1,0,0.5,0.5\n1,0,0,0\n");
  ASSERT_EQ(evaluate(data_file("cube.obj"), points, folder / "o.csv").exit_code, 0);
  const auto rows = lines(read_file(folder / "o.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0],
            "x,y,z,xu,yu,zu,xv,yv,zv,xuu,yuu,zuu,xuv,yuv,zuv,xvv,yvv,zvv,nx,ny,nz,mean,gauss");
  // The middle of face 1 (z > 0): after one step a face point (0,0,1) of valence 4 with edge points
  // at distance 3/4 in z and corners at 5/9: (16 + 16 * 3/4 + 4 * 5/9) / 36 = 68/81.
  const auto middle = fields(rows[1]);
  ASSERT_EQ(middle.size(), 23U);
  EXPECT_NEAR(number(middle[0]), 0.0, 1e-15);
  EXPECT_NEAR(number(middle[2]), 68.0 / 81.0, 1e-14);
  EXPECT_NEAR(number(middle[20]), 1.0, 1e-14);  // nz
  EXPECT_GT(number(middle[21]), 0.0);           // mean curvature of a convex body
  // A corner: position and normal exist, derivatives and curvatures do not.
  const auto corner = fields(rows[2]);
  ASSERT_EQ(corner.size(), 23U);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(std::abs(number(corner[static_cast<std::size_t>(i)])), 0.5, 1e-14);
  for (std::size_t i = 3; i < 18; ++i)
    EXPECT_EQ(corner[i], "");
  EXPECT_NEAR(std::abs(number(corner[18])), std::sqrt(1.0 / 3.0), 1e-14);
  EXPECT_EQ(corner[21], "");
  EXPECT_EQ(corner[22], "");
}

TEST(Evaluate, DerivativesAreThoseOfTheParameters) {
  const TempFolder folder;
  // Differences of positions against the printed derivatives, on a triangle's quadrant and a quad.
  const std::string mesh = data_file("rook.obj");
  for (const char* face : {"0,0", "3,0", "776,1"}) {
    std::string csv = "face,corner,u,v\n";
    constexpr double h = 1e-5;
    for (const auto& [du, dv] :
         std::vector<std::pair<double, double>>{{0, 0}, {h, 0}, {-h, 0}, {0, h}, {0, -h}})
      csv += std::string(face) + "," + format_real(0.3 + du) + "," + format_real(0.6 + dv) + "\n";
    const Result run = evaluate(mesh, folder.file("p.csv", csv), folder / "o.csv");
    if (run.exit_code == 3) continue;  // a quad has one corner only
    const auto rows = lines(read_file(folder / "o.csv"));
    ASSERT_EQ(rows.size(), 6U);
    const auto value = [&](std::size_t row, std::size_t column) {
      return number(fields(rows[row])[column]);
    };
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR((value(2, c) - value(3, c)) / (2 * h), value(1, 3 + c), 1e-8);
      EXPECT_NEAR((value(4, c) - value(5, c)) / (2 * h), value(1, 6 + c), 1e-8);
      EXPECT_NEAR((value(2, 3 + c) - value(3, 3 + c)) / (2 * h), value(1, 9 + c), 1e-7);
      EXPECT_NEAR((value(4, 3 + c) - value(5, 3 + c)) / (2 * h), value(1, 12 + c), 1e-7);
      EXPECT_NEAR((value(4, 6 + c) - value(5, 6 + c)) / (2 * h), value(1, 15 + c), 1e-7);
    }
  }
}

TEST(Evaluate, TakesColumnsInAnyOrderAndAnyLineEnd) {
  const TempFolder folder;
  const std::string plain = folder.file("1.csv", "face,corner,u,v\n2,0,0.25,0.75\n");
  const std::string mixed =
      folder.file("2.csv", "\xEF\xBB\xBFv, id ,face,u,corner\r\n\r\n0.75,first,2.0,+.25,0\r\n");
  ASSERT_EQ(evaluate(data_file("cube.obj"), plain, folder / "a.csv").exit_code, 0);
  const Result result = evaluate(data_file("cube.obj"), mixed, folder / "b.csv");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_file(folder / "a.csv"), read_file(folder / "b.csv"));
}

TEST(Evaluate, NamesBadPointsByTheirLine) {
  const TempFolder folder;
  const auto bad = [&](const std::string& row, const std::string& reason,
                       const std::string& head = "face,corner,u,v") {
    const std::string points = folder.file("p.csv", head + "\n0,0,0.5,0.5\n" + row + "\n");
    expect_failure(evaluate(data_file("cube.obj"), points, folder / "o.csv"), 3, reason);
  };
  bad("6,0,0,0", "p.csv:3: face 6 does not exist; 0 to 5 is right");
  bad("-1,0,0,0", "p.csv:3: face -1");
  bad("1.5,0,0,0", "p.csv:3: face is 1.5; a whole number is right");
  bad("0,1,0,0", "p.csv:3: corner 1 does not exist");
  bad("0,0,1.01,0", "p.csv:3: (u, v) = (1.01, 0) lies outside face 0");
  bad("0,0,0,-1e-9", "p.csv:3:");
  bad("0,0,nan,0", "p.csv:3: u is 'nan'");
  bad("0,0,0", "p.csv:3: 3 fields; the head has 4 columns");
  bad("0,0,0,0", "p.csv:1: there is no column corner", "face,c,u,v");
  bad("0,0,0,0", "p.csv:1: column u appears twice", "face,corner,u,u,v");
  expect_failure(evaluate(data_file("cube.obj"), folder.file("e.csv", ""), folder / "o.csv"), 3,
                 "e.csv: empty");
  expect_failure(evaluate(data_file("cube.obj"), folder / "none.csv", folder / "o.csv"), 3,
                 "none.csv: No such file");
  EXPECT_EQ(folder.list(), (std::vector<std::string>{"e.csv", "p.csv"}));
}

TEST(Evaluate, SameBytesForAnyNumberOfThreadsAndNumbersRoundTrip) {
  const TempFolder folder;
  std::string csv = "face,corner,u,v\n";
  for (int i = 0; i < 5000; ++i)
    csv += std::to_string(i % 588) + ",0," + format_real((i % 71) / 70.0) + "," +
           format_real((i % 53) / 52.0) + "\n";
  const std::string points = folder.file("p.csv", csv);
  const std::string mesh = data_file("pawn.obj");
  const Result one = evaluate(mesh, points, folder / "1.csv", {"--threads", "1", "--json"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(nlohmann::json::parse(one.out)["points"], 5000);
  ASSERT_EQ(evaluate(mesh, points, folder / "2.csv", {"--threads", "2"}).exit_code, 0);
  const std::string text = read_file(folder / "1.csv");
  EXPECT_TRUE(text == read_file(folder / "2.csv"));
  const auto rows = lines(text);
  ASSERT_EQ(rows.size(), 5001U);
  for (const std::size_t r : {std::size_t{1}, std::size_t{777}, std::size_t{5000}})
    for (const std::string& field : fields(rows[r]))
      if (!field.empty()) {
        EXPECT_EQ(format_real(number(field)), field);  // the shortest form
      }
}

TEST(Evaluate, FacesThatTheBoundaryRuleDropsHaveNoSurface) {
  const TempFolder folder;
  const std::string mesh = folder.file("q.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const std::string points = folder.file("p.csv", "face,corner,u,v\n0,0,0.5,0.5\n");
  expect_failure(evaluate(mesh, points, folder / "o.csv", {"--boundary", "none"}), 3,
                 "p.csv:2: face 0 touches the boundary");
  EXPECT_EQ(evaluate(mesh, points, folder / "o.csv").exit_code, 0);
  EXPECT_EQ(evaluate(mesh, points, folder / "o.csv", {"linear"}).exit_code, 0);
}

TEST(Evaluate, StandardOutputGetsTheTableAndNothingElse) {
  const TempFolder folder;
  const std::string points = folder.file("p.csv", "face,corner,u,v\n1,0,0.5,0.5\n");
  const Result file = evaluate(data_file("cube.obj"), points, folder / "o.csv");
  EXPECT_EQ(file.out, (folder / "o.csv") + ": 1 point\n");
  const Result direct = evaluate(data_file("cube.obj"), points, "/dev/stdout");
  EXPECT_EQ(direct.exit_code, 0) << direct.err;
  EXPECT_EQ(direct.out, read_file(folder / "o.csv"));
  // The table and --json cannot share it.
  expect_failure(run_limes({"evaluate", data_file("cube.obj"), "--scheme", "catmull-clark", "--at",
                            points, "-o", "/dev/stdout", "--json"}),
                 2, "where --json prints");
  // The same through a pipe, and behind what a file holds already.
  const auto shell = [&](const std::string& redirection) {
    const std::string command = std::string(LIMES_EXECUTABLE) + " evaluate " +
                                data_file("cube.obj") + " --scheme catmull-clark --at " + points +
                                " -o /dev/stdout " + redirection;
    EXPECT_EQ(std::system(command.c_str()), 0);
  };
  shell("| cat > " + (folder / "pipe.csv"));
  EXPECT_EQ(read_file(folder / "pipe.csv"), direct.out);
  const std::string notes = folder.file("notes.csv", "first\n");
  shell(">> " + notes);
  EXPECT_EQ(read_file(notes), "first\n" + direct.out);
}

}  // namespace
}  // namespace limes::test
