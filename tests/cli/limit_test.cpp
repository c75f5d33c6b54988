// The cells of 'limes limit', decoded from the file and evaluated between their nodes, against the
// surface itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.h"
#include "cli/vtu_reader.h"
#include "io/vtk_order.h"
#include "limes/io/io.h"
#include "limes/limit/limit_surface.h"
#include "limes/subdiv/schemes.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;

double bernstein(int i, double t) {
  constexpr std::array<int, 4> binomial{1, 3, 3, 1};
  return binomial[static_cast<std::size_t>(i)] * std::pow(t, i) * std::pow(1 - t, 3 - i);
}

double lagrange(int i, double t) {
  double value = 1;
  for (int k = 0; k < 4; ++k)
    if (k != i) value *= (3 * t - k) / (i - k);
  return value;
}

/// A point of a cell of a file.
Vec3 cell_point(const VtuArrays& vtu, std::size_t cell, double s, double t) {
  const bool bezier = vtu.at("types")[cell] == 77;
  Vec3 x = Vec3::Zero();
  for (std::size_t k = 0; k < 16; ++k) {
    const auto point = static_cast<std::size_t>(vtu.at("connectivity")[16 * cell + k]);
    const auto [i, j] = cubic_quad_points[k];
    const double weight =
        bezier ? bernstein(i, s) * bernstein(j, t) : lagrange(i, s) * lagrange(j, t);
    for (int c = 0; c < 3; ++c)
      x[c] += weight * vtu.at("Points")[3 * point + static_cast<std::size_t>(c)];
  }
  return x;
}

Result limit(const std::string& mesh, const std::string& out,
             const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"limit", mesh, "-o", out, "--scheme", "catmull-clark"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_limes(arguments);
}

class Cells : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Limit, Cells, testing::Values("lagrange", "bezier"));

TEST_P(Cells, AreExactWhereTheSurfaceIsBicubic) {
  const TempFolder folder;
  const std::string file = folder / "torus.vtu";
  ASSERT_EQ(limit(data_file("torus.obj"), file, {"--cells", GetParam()}).exit_code, 0);
  const VtuArrays vtu = read_vtu_arrays(file);
  const Mesh mesh = read_mesh(data_file("torus.obj")).mesh;
  const LimitBasis basis(mesh.topology, {}, find_scheme("catmull-clark"));
  const LimitSurface surface(basis, mesh.points.span());
  ASSERT_EQ(vtu.at("types").size(), 48U);
  EXPECT_EQ(vtu.at("types")[0], std::string(GetParam()) == "bezier" ? 77 : 70);
  for (std::size_t cell = 0; cell < 48; ++cell) {
    EXPECT_EQ(vtu.at("face")[cell], static_cast<double>(cell));
    EXPECT_EQ(vtu.at("corner")[cell], 0);
    for (const double s : {0.0, 0.17, 0.5, 0.93})
      for (const double t : {0.08, 0.6, 1.0}) {
        const Vec3 exact = surface.position(FaceId(cell), 0, {s, t});
        EXPECT_LT((cell_point(vtu, cell, s, t) - exact).norm(), 1e-14);
      }
  }
}

/// The squares of a face that cells cover are found again from their corners on the surface.
TEST_P(Cells, StayWithinTheReportedDeviation) {
  const TempFolder folder;
  const std::string file = folder / "cube.vtu";
  const Result result =
      limit(data_file("cube.obj"), file, {"--cells", GetParam(), "--tolerance", "1e-5", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  const double diagonal = std::sqrt(12.0);
  EXPECT_LE(json["deviation"], 1e-5 * diagonal);
  EXPECT_GT(json["deviation"], 0.0);

  const VtuArrays vtu = read_vtu_arrays(file);
  const std::size_t num_cells = vtu.at("types").size();
  EXPECT_EQ(json["cells"], num_cells);
  const Mesh mesh = read_mesh(data_file("cube.obj")).mesh;
  const LimitBasis basis(mesh.topology, {}, find_scheme("catmull-clark"));
  const LimitSurface surface(basis, mesh.points.span());
  // Cells come face by face, quadrant by quadrant: walk the same squares, from their area 1 down.
  double covered = 0, largest = 0;
  for (std::size_t cell = 0; cell < num_cells; ++cell) {
    const FaceId face(static_cast<std::int64_t>(vtu.at("face")[cell]));
    // Invert the cell's first corner and width by searching dyadic squares.
    bool found = false;
    for (double size = 1; size > 1e-4 && !found; size /= 2)
      for (const double a : {0.0, size, 1 - 2 * size, 1 - size})
        for (const double b : {0.0, size, 1 - 2 * size, 1 - size}) {
          if (found || a < 0 || b < 0) continue;
          const auto at = [&](double s, double t) {
            return surface.position(face, 0, {a + size * s, b + size * t});
          };
          if ((cell_point(vtu, cell, 0, 0) - at(0, 0)).norm() > 1e-12 ||
              (cell_point(vtu, cell, 1, 1) - at(1, 1)).norm() > 1e-12)
            continue;
          found = true;
          covered += size * size;
          for (double s = 0.02; s < 1; s += 0.06)
            for (double t = 0.02; t < 1; t += 0.06)
              largest = std::max(largest, (cell_point(vtu, cell, s, t) - at(s, t)).norm());
        }
    EXPECT_TRUE(found) << "cell " << cell;
  }
  EXPECT_DOUBLE_EQ(covered, 6.0);  // every face exactly once
  EXPECT_LT(largest, 1.2 * json["deviation"].get<double>());
  EXPECT_GT(largest, 0.5 * json["deviation"].get<double>());
}

TEST(Limit, NormalsAndCurvaturesAreNodalSamples) {
  const TempFolder folder;
  const std::string file = folder / "cube.vtu";
  ASSERT_EQ(limit(data_file("cube.obj"), file).exit_code, 0);
  const VtuArrays vtu = read_vtu_arrays(file);
  const auto& normal = vtu.at("normal");
  const auto& points = vtu.at("Points");
  const auto& mean = vtu.at("mean_curvature");
  int missing = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const Vec3 n(normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]);
    const Vec3 x(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    EXPECT_NEAR(n.norm(), 1.0, 1e-12);
    EXPECT_GT(n.dot(x), 0.0);  // out of a convex body around the origin
    if (std::isnan(mean[i]))
      ++missing;
    else
      EXPECT_GT(mean[i], 0.0);
  }
  EXPECT_EQ(missing, 24);  // only at the eight corners, in three faces each
}

TEST(Limit, LeavesHolesOutAndCutsPolygonsIntoQuadrants) {
  const TempFolder folder;
  const std::string mesh =
      folder.file("m.obj", read_file(data_file("cube.obj")) + "t hole 1/0/0 2\n");
  ASSERT_EQ(limit(mesh, folder / "hole.vtu").exit_code, 0);
  const VtuArrays hole = read_vtu_arrays(folder / "hole.vtu");
  const std::set<double> faces(hole.at("face").begin(), hole.at("face").end());
  EXPECT_EQ(faces, (std::set<double>{0, 1, 3, 4, 5}));

  const std::string tetrahedron = folder.file(
      "t.obj", "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 4\nf 1 3 2\nf 1 4 3\nf 2 3 4\n");
  ASSERT_EQ(limit(tetrahedron, folder / "t.vtu", {"--tolerance", "0.5"}).exit_code, 0);
  const VtuArrays coarse = read_vtu_arrays(folder / "t.vtu");
  EXPECT_EQ(coarse.at("corner"), (std::vector<double>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}));
}

TEST(Limit, SameBytesForAnyNumberOfThreads) {
  const TempFolder folder;
  ASSERT_EQ(
      limit(data_file("pawn.obj"), folder / "1.vtu", {"--threads", "1", "--tolerance", "1e-4"})
          .exit_code,
      0);
  ASSERT_EQ(
      limit(data_file("pawn.obj"), folder / "2.vtu", {"--threads", "2", "--tolerance", "1e-4"})
          .exit_code,
      0);
  EXPECT_TRUE(read_file(folder / "1.vtu") == read_file(folder / "2.vtu"));
}

TEST(Limit, StopsAtTheMemoryLimit) {
  // How many cells there will be is not known beforehand: hundreds of megabytes for this mesh.
  const TempFolder folder;
  const Result result = limit(data_file("pawn.obj"), folder / "x.vtu", {"--memory-limit", "40M"});
  expect_failure(result, 3,
                 "stopped at the memory limit of 40.0 MiB; raise --memory-limit or work on less");
  EXPECT_LT(result.peak_memory,
            std::max(run_limes({"schemes"}).peak_memory, std::int64_t{40} << 20) + (8 << 20));
  EXPECT_TRUE(folder.list().empty());
}

TEST(Limit, NeedsAFaceWithASurface) {
  const TempFolder folder;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  const std::string mesh = folder.file("square.obj", square);
  expect_failure(limit(mesh, folder / "x.vtu", {"--boundary", "none"}), 3, "square.obj: no face");
  const std::string hole = folder.file("hole.obj", square + "t hole 1/0/0 0\n");
  expect_failure(limit(hole, folder / "x.vtu"), 3, "hole.obj: no face");
  expect_failure(run_limes({"refine", mesh, "-o", folder / "x.obj", "--scheme", "catmull-clark",
                            "--levels", "1", "--boundary", "none"}),
                 3, "square.obj: every face touches the boundary");
  EXPECT_EQ(folder.list(), (std::vector<std::string>{"hole.obj", "square.obj"}));
}

TEST(Limit, SaysWhenEveryCellIsExact) {
  const TempFolder folder;
  const Result torus = limit(data_file("torus.obj"), folder / "torus.vtu");
  EXPECT_EQ(torus.out, (folder / "torus.vtu") + ": 48 cells, all exact\n");
}

TEST(Limit, ChecksItsOptions) {
  expect_failure(limit(data_file("cube.obj"), "x.obj"), 2, "does not end in .vtu");
  expect_failure(limit(data_file("cube.obj"), "x.vtu", {"--cells", "nurbs"}), 2,
                 "known are lagrange, bezier");
  for (const char* tolerance : {"0", "-1", "small"})
    expect_failure(limit(data_file("cube.obj"), "x.vtu", {"--tolerance", tolerance}), 2,
                   "--tolerance");
}

}  // namespace
}  // namespace limes::test
