// `evaluate`, `limit` and `refine --limit` with the triangles of loop.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"
#include "cli/vtu_reader.h"
#include "limes/core/text.h"
#include "limes/io/io.h"
#include "limes/limit/limit_surface.h"
#include "limes/subdiv/schemes.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;

// All vertices of valence 3, or 4.
constexpr const char* tetrahedron =
    "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 4\nf 1 3 2\nf 1 4 3\nf 2 3 4\n";
constexpr const char* octahedron =
    "v 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\nv 0 0 -1\n"
    "f 1 2 3\nf 2 4 3\nf 4 5 3\nf 5 1 3\nf 2 1 6\nf 4 2 6\nf 5 4 6\nf 1 5 6\n";

std::vector<std::vector<std::string>> rows_of(const std::string& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(read_file(file));
  for (std::string line; std::getline(stream, line);) {
    rows.emplace_back(1);
    for (const char c : line)
      if (c == ',')
        rows.back().emplace_back();
      else
        rows.back().back() += c;
  }
  return rows;
}

void expect_numbers(const std::vector<std::string>& row, std::size_t first,
                    const std::vector<double>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto value = parse_real(row.at(first + i));
    ASSERT_TRUE(value.has_value()) << "field " << first + i << ": " << row[first + i];
    EXPECT_NEAR(*value, expected[i], 1e-14) << "field " << first + i;
  }
}

Result evaluate(const std::string& mesh, const std::string& points, const std::string& out) {
  return run_limes({"evaluate", mesh, "--at", points, "-o", out, "--scheme", "loop"});
}

TEST(LoopEvaluate, KnownPointsOfTheTetrahedron) {
  const TempFolder folder;
  const std::string mesh = folder.file("t.obj", tetrahedron);
  const std::string points =
      folder.file("p.csv", "face,corner,u,v\n0,0,0,0\n0,0,1,0\n0,0,0,1\n0,0,0.5,0\n");
  ASSERT_EQ(evaluate(mesh, points, folder / "o.csv").exit_code, 0);
  const auto rows = rows_of(folder / "o.csv");
  ASSERT_EQ(rows.size(), 5U);
  // Valence 3: weights 2/5 and 1/5 of the others, whose sum is -V.
  expect_numbers(rows[1], 0, {0.2, 0.2, 0.2});
  expect_numbers(rows[2], 0, {-0.2, -0.2, 0.2});
  expect_numbers(rows[3], 0, {0.2, -0.2, -0.2});
  for (std::size_t i = 3; i < 18; ++i)
    EXPECT_EQ(rows[1].at(i), "");
  const double normal = std::sqrt(1.0 / 3.0);
  expect_numbers(rows[1], 18, {normal, normal, normal});
  // Middle of the side between a and b: (a + b)/4 after a step, then valence 6 with 1/4 of a and b
  // and four middles of sides around, whose sum is (a + b)/4 + (a + b)/2 - (a + b)/2: 7/48 (a + b).
  expect_numbers(rows[4], 0, {0, 0, 7.0 / 24});
  expect_numbers(rows[4], 18, {0, 0, 1});
}

TEST(LoopEvaluate, KnownPointsOfTheOctahedron) {
  const TempFolder folder;
  const std::string mesh = folder.file("o.obj", octahedron);
  const std::string points = folder.file("p.csv", "face,corner,u,v\n0,0,0,1\n");
  ASSERT_EQ(evaluate(mesh, points, folder / "o.csv").exit_code, 0);
  // Valence 4: w = 31/256, weight of a neighbour 1/(4 + 3/(8 w)) = 31/220; they sum to zero.
  expect_numbers(rows_of(folder / "o.csv").at(1), 0, {0, 0, 24.0 / 55});
}

/// An affine piece: derivatives are the sides, curvatures are zero.
TEST(LoopEvaluate, DerivativesAreThoseOfTheWeights) {
  const TempFolder folder;
  const std::string mesh =
      folder.file("m.obj",
                  "v 0 0 1\nv 3 0 1\nv 1 2 1\nf 1 2 3\nt corner 1/1/0 0 10\nt corner 1/1/0 1 10\n"
                  "t corner 1/1/0 2 10\n");
  const std::string points =
      folder.file("p.csv", "face,corner,u,v\n0,0,0.25,0.5\n0,0,0.3,0.7\n0,0,0,0\n");
  ASSERT_EQ(evaluate(mesh, points, folder / "o.csv").exit_code, 0);
  const auto rows = rows_of(folder / "o.csv");
  expect_numbers(rows.at(1), 0, {1.25, 1, 1, 3, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
  expect_numbers(rows.at(2), 0, {1.6, 1.4, 1, 3, 0, 0, 1, 2, 0});
  expect_numbers(rows.at(3), 0, {0, 0, 1, 3, 0, 0, 1, 2, 0});
  expect_numbers(rows.at(1), 21, {0, 0});
}

TEST(LoopEvaluate, NamesBadPointsByTheirLine) {
  const TempFolder folder;
  const std::string mesh = folder.file("t.obj", tetrahedron);
  const auto bad = [&](const std::string& row, const std::string& reason) {
    const std::string points = folder.file("p.csv", "face,corner,u,v\n" + row + "\n");
    expect_failure(evaluate(mesh, points, folder / "o.csv"), 3, reason);
  };
  bad("0,0,0.6,0.5",
      "p.csv:2: (u, v) = (0.6, 0.5) lies outside face 0; u, v >= 0, u + v <= 1 is inside");
  bad("0,0,-0.1,0.5", "p.csv:2: (u, v) = (-0.1, 0.5) lies outside face 0");
  bad("0,1,0,0", "p.csv:2: corner 1 does not exist; 0 is right");
  bad("4,0,0,0", "p.csv:2: face 4 does not exist");
}

TEST(LoopEvaluate, SearchesAndElementsSayTheyNeedSquares) {
  const TempFolder folder;
  const std::string mesh = folder.file("t.obj", tetrahedron);
  const std::string points = folder.file("p.csv", "x,y,z\n0,0,2\n");
  expect_failure(run_limes({"evaluate", mesh, "--closest", points, "-o", folder / "o.csv",
                            "--scheme", "loop"}),
                 3, "closest points and rays cannot be had with the triangles of loop");
  (void)folder.file("plane.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string problem = folder.file("p.toml", R"([mesh]
file = "plane.obj"
scheme = "loop"
[material]
young = 1.0
poisson = 0.3
[model]
kind = "plane-stress"
[[support]]
where = "x < 0"
fix = ["ux", "uy"]
)");
  expect_failure(run_limes({"solve", problem}), 3,
                 problem + ":3: there are no plane elements of the scheme \"loop\"");
}

TEST(LoopRefine, MovesVerticesToTheirLimits) {
  const TempFolder folder;
  const std::string mesh = folder.file("t.obj", tetrahedron);
  for (const char* levels : {"0", "2"}) {
    const std::string out = folder / "fine.obj";
    ASSERT_EQ(
        run_limes({"refine", mesh, "-o", out, "--scheme", "loop", "--levels", levels, "--limit"})
            .exit_code,
        0);
    const Mesh fine = read_mesh(out).mesh;
    EXPECT_LE((fine.points[VertexId(0)] - Vec3(0.2, 0.2, 0.2)).norm(), 1e-15);
  }
}

/// Where VTK puts the 15 points (i, j) of a triangle of degree 4, from the documentation of
/// vtkHigherOrderTriangle: corners, edges, inside.
constexpr std::array<std::array<int, 2>, 15> quartic_triangle_points{{
    {0, 0},
    {4, 0},
    {0, 4},  // corners
    {1, 0},
    {2, 0},
    {3, 0},
    {3, 1},
    {2, 2},
    {1, 3},
    {0, 3},
    {0, 2},
    {0, 1},  // edges
    {1, 1},
    {2, 1},
    {1, 2}  // inside
}};

/// Product over m < n of (4 x - m) / (n - m): 1 at x = n/4.
double lagrange(int n, double x) {
  double value = 1;
  for (int m = 0; m < n; ++m)
    value *= (4 * x - m) / (n - m);
  return value;
}

double weight(bool bezier, int i, int j, double u, double v) {
  const int k = 4 - i - j;
  const double w = 1 - u - v;
  if (!bezier) return lagrange(i, u) * lagrange(j, v) * lagrange(k, w);
  const auto factorial = [](int n) { return std::tgamma(n + 1); };
  return 24 / (factorial(i) * factorial(j) * factorial(k)) * std::pow(u, i) * std::pow(v, j) *
         std::pow(w, k);
}

Vec3 cell_point(const VtuArrays& vtu, std::size_t cell, double u, double v) {
  Vec3 x = Vec3::Zero();
  for (std::size_t k = 0; k < 15; ++k) {
    const auto point = static_cast<std::size_t>(vtu.at("connectivity")[15 * cell + k]);
    const auto [i, j] = quartic_triangle_points[k];
    for (std::size_t c = 0; c < 3; ++c)
      x[static_cast<Eigen::Index>(c)] +=
          weight(vtu.at("types")[cell] == 76, i, j, u, v) * vtu.at("Points")[3 * point + c];
  }
  return x;
}

class LoopCells : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Limit, LoopCells, testing::Values("lagrange", "bezier"));

/// The triangles of a face that cells cover are found again from their corners on the surface.
TEST_P(LoopCells, StayWithinTheReportedDeviation) {
  const TempFolder folder;
  const std::string file = folder / "o.vtu";
  const std::string obj = folder.file("o.obj", octahedron);
  const Result result = run_limes({"limit", obj, "-o", file, "--scheme", "loop", "--cells",
                                   GetParam(), "--tolerance", "1e-3", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  const double deviation = json["deviation"];
  EXPECT_LE(deviation, 1e-3 * std::sqrt(12.0));
  const VtuArrays vtu = read_vtu_arrays(file);
  const std::size_t num_cells = vtu.at("types").size();
  EXPECT_EQ(json["cells"], num_cells);
  const Mesh mesh = read_mesh(obj).mesh;
  const LimitBasis basis(mesh.topology, {}, find_scheme("loop"));
  const LimitSurface surface(basis, mesh.points.span());
  double covered = 0, largest = 0;
  std::size_t num_exact = 0;
  for (std::size_t cell = 0; cell < num_cells; ++cell) {
    EXPECT_EQ(vtu.at("types")[cell], std::string(GetParam()) == "bezier" ? 76 : 69);
    const FaceId face(static_cast<std::int64_t>(vtu.at("face")[cell]));
    bool found = false;
    for (double size = 1; size > 1e-2 && !found; size /= 2)
      for (double a = 0; a <= 1 && !found; a += size)
        for (double b = 0; a + b <= 1 && !found; b += size)
          for (const double way : {size, -size}) {
            const auto at = [&](double s, double t) {
              return surface.position(face, 0, {a + way * s, b + way * t});
            };
            if (found || std::min(a, b) + way < 0 || a + b + way > 1) continue;
            if ((cell_point(vtu, cell, 0, 0) - at(0, 0)).norm() > 1e-12 ||
                (cell_point(vtu, cell, 1, 0) - at(1, 0)).norm() > 1e-12 ||
                (cell_point(vtu, cell, 0, 1) - at(0, 1)).norm() > 1e-12)
              continue;
            found = true;
            covered += size * size;
            double worst = 0;
            for (double s = 0.02; s < 1; s += 0.06)
              for (double t = 0.02; s + t < 1; t += 0.06)
                worst = std::max(worst, (cell_point(vtu, cell, s, t) - at(s, t)).norm());
            num_exact += worst < 1e-13;
            largest = std::max(largest, worst);
          }
    EXPECT_TRUE(found) << "cell " << cell;
  }
  EXPECT_DOUBLE_EQ(covered, 8.0);  // every face exactly once
  EXPECT_EQ(json["exact_cells"], num_exact);
  EXPECT_LT(largest, 1.2 * deviation);
  EXPECT_GT(largest, 0.5 * deviation);
}

TEST(LoopLimit, SameBytesForAnyNumberOfThreads) {
  const TempFolder folder;
  const std::string obj = folder.file("o.obj", octahedron);
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(run_limes({"limit", obj, "-o", folder / (threads + std::string(".vtu")), "--scheme",
                         "loop", "--threads", threads})
                  .exit_code,
              0);
  EXPECT_TRUE(read_file(folder / "1.vtu") == read_file(folder / "2.vtu"));
}

TEST(LoopSchemes, HasABoxSplineLimit) {
  const Json json = Json::parse(run_limes({"schemes", "--json"}).out);
  const auto found = std::find_if(json["schemes"].begin(), json["schemes"].end(),
                                  [](const Json& scheme) { return scheme["name"] == "loop"; });
  ASSERT_NE(found, json["schemes"].end());
  EXPECT_EQ((*found)["limit"], "box spline");
}

}  // namespace
}  // namespace limes::test
