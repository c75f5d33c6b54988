#include "limes/io/vtu.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <set>

#include "io/expect.h"
#include "io/vtk_order.h"

namespace limes {
namespace {

namespace fs = std::filesystem;

/// What dump_vtu.py, which shares no code with the writer, finds in a file.
std::string dump(const VtuGrid& grid) {
  const fs::path file =
      fs::temp_directory_path() / fmt::format("limes-vtu-{}.vtu", static_cast<long>(getpid()));
  write_vtu(file, grid);
  const fs::path script = fs::path(LIMES_TEST_DATA_DIR).parent_path() / "io" / "dump_vtu.py";
  std::FILE* const pipe =
      popen(fmt::format("python3 '{}' '{}' 2>&1", script.string(), file.string()).c_str(), "r");
  std::string text;
  std::array<char, 4096> piece;
  for (std::size_t n; (n = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;)
    text.append(piece.data(), n);
  EXPECT_EQ(pclose(pipe), 0) << text;
  fs::remove(file);
  return text;
}

TEST(Vtu, EverythingAGridHolds) {
  VtuGrid grid;
  grid.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0.1), Vec3(0, 1, -2e-300)};
  grid.add_cell(VtkCell::triangle, std::vector<std::int64_t>{0, 1, 2});
  grid.add_cell(VtkCell::bezier_quad, std::vector<std::int64_t>{0, 1, 2, 3});
  grid.point_data = {{"a<&\">b", 1, std::vector<double>{0, 0.5, 1, 1e22}},
                     {"v", 2, std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, -8}}};
  grid.cell_data = {{"part", 1, std::vector<std::int64_t>{7, 9}}};
  grid.degrees = {1, 1};
  grid.rational_weights = {1, 1, 0.5, 2};
  EXPECT_EQ(dump(grid),
            "4 2\n"
            "Points Float64 Points 3 0.0 0.0 0.0 1.0 0.0 0.0 1.0 1.0 0.1 0.0 1.0 -2e-300\n"
            "Cells Int64 connectivity 1 0 1 2 0 1 2 3\n"
            "Cells Int64 offsets 1 3 7\n"
            "Cells UInt8 types 1 5 77\n"
            "PointData Float64 a<&\">b 1 0.0 0.5 1.0 1e+22\n"
            "PointData Int64 v 2 1 2 3 4 5 6 7 -8\n"
            "PointData RationalWeights Float64 RationalWeights 1 1.0 1.0 0.5 2.0\n"
            "CellData Int64 part 1 7 9\n"
            "CellData HigherOrderDegrees Float64 HigherOrderDegrees 3 1.0 1.0 0.0 1.0 1.0 0.0\n");
}

TEST(Vtu, AnEmptyGrid) {
  EXPECT_EQ(dump(VtuGrid()),
            "0 0\nPoints Float64 Points 3\nCells Int64 connectivity 1\nCells Int64 offsets 1\n"
            "Cells UInt8 types 1\n");
}

TEST(Vtu, SeveralBlocksAndOneThatIsFull) {
  // 131072 doubles fill a block of 1 MiB exactly, the points fill three, the offsets one and a bit
  VtuGrid grid;
  std::vector<double> full(131072);
  std::int64_t full_sum = 0, point_sum = 0, offset_sum = 0;
  for (std::int64_t i = 0; i < 131072; ++i) {
    full[static_cast<std::size_t>(i)] = double(i % 1000);
    grid.points.push_back(Vec3(0, 0, double(i % 777)));
    full_sum += (i + 1) * (i % 1000);
    point_sum += (3 * i + 3) * (i % 777);
  }
  for (std::int64_t i = 0; i < 131073; ++i) {
    grid.add_cell(VtkCell::triangle, std::vector<std::int64_t>{0, 1, 2});
    offset_sum += (i + 1) * (3 * i + 3);
  }
  grid.point_data = {{"full", 1, full}};
  const std::string text = dump(grid);
  EXPECT_EQ(
      text.rfind(fmt::format("131072 131073\nPoints Float64 Points 3 393216 {}\n", point_sum), 0),
      0U)
      << text;
  EXPECT_NE(text.find(fmt::format("Cells Int64 offsets 1 131073 {}\n", offset_sum)),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(fmt::format("PointData Float64 full 1 131072 {}\n", full_sum)),
            std::string::npos)
      << text;
}

TEST(Vtu, CellsOfAMesh) {
  const Mesh mesh =
      read_off("OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n3 0 1 2\n4 0 1 2 3\n5 0 1 2 3 4\n",
               "f")
          .mesh;
  VtuGrid grid;
  grid.points = mesh.points.vector();
  grid.add_cell(VtkCell::triangle, std::vector<std::int64_t>{0, 1, 2});
  grid.add_cell(VtkCell::quad, std::vector<std::int64_t>{0, 1, 2, 3});
  grid.add_cell(VtkCell::polygon, std::vector<std::int64_t>{0, 1, 2, 3, 4});
  std::string bytes;
  write_vtu([&](std::string_view piece) { bytes += piece; }, grid);
  EXPECT_EQ(written(write_vtu, mesh), bytes);
}

// The order of points in VTK's curved cells, from the documentation of vtkHigherOrderQuadrilateral
// and vtkHigherOrderTriangle, worked out by hand.

using Grid = std::vector<std::array<int, 2>>;

TEST(Vtu, PointsOfCurvedQuads) {
  EXPECT_EQ(vtk_quad_points(1), (Grid{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(vtk_quad_points(2),
            (Grid{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}));
  EXPECT_EQ(vtk_quad_points(3), Grid(cubic_quad_points.begin(), cubic_quad_points.end()));
}

TEST(Vtu, PointsOfCurvedTriangles) {
  EXPECT_EQ(vtk_triangle_points(1), (Grid{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(vtk_triangle_points(2), (Grid{{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(vtk_triangle_points(3),
            (Grid{{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}));
  EXPECT_EQ(vtk_triangle_points(4), (Grid{{0, 0},
                                          {4, 0},
                                          {0, 4},
                                          {1, 0},
                                          {2, 0},
                                          {3, 0},
                                          {3, 1},
                                          {2, 2},
                                          {1, 3},
                                          {0, 3},
                                          {0, 2},
                                          {0, 1},
                                          {1, 1},
                                          {2, 1},
                                          {1, 2}}));
}

TEST(Vtu, CurvedCellsNameEveryPointOnce) {
  for (int p = 1; p <= 12; ++p) {
    const Grid quad = vtk_quad_points(p), triangle = vtk_triangle_points(p);
    EXPECT_EQ(std::set(quad.begin(), quad.end()).size(),
              static_cast<std::size_t>((p + 1) * (p + 1)));
    EXPECT_EQ(quad.size(), static_cast<std::size_t>((p + 1) * (p + 1)));
    EXPECT_EQ(triangle.size(), static_cast<std::size_t>((p + 1) * (p + 2) / 2));
    EXPECT_EQ(std::set(triangle.begin(), triangle.end()).size(), triangle.size());
    for (const auto& [i, j] : triangle)
      EXPECT_TRUE(i >= 0 && j >= 0 && i + j <= p);
  }
}

}  // namespace
}  // namespace limes
