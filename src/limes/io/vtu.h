#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "limes/core/types.h"
#include "limes/io/io.h"

namespace limes {

/// VTK's numbers for the kinds of cells we write.
enum class VtkCell : std::uint8_t {
  triangle = 5,
  polygon = 7,
  quad = 9,
  lagrange_triangle = 69,
  lagrange_quad = 70,
  bezier_triangle = 76,
  bezier_quad = 77
};

/// A named field: `components` values per point or cell, one after the other.
struct VtuArray {
  std::string name;
  int components;
  std::variant<std::vector<double>, std::vector<std::int64_t>> values;
};

/// What a .vtu file holds. On Bezier cells points and point data are Bernstein coefficients.
struct VtuGrid {
  std::vector<Vec3> points;
  std::vector<std::int64_t> connectivity;  ///< points of all cells, cell after cell
  std::vector<std::int64_t> offsets;       ///< one past the last point of each cell
  std::vector<VtkCell> types;

  std::vector<VtuArray> point_data;
  std::vector<VtuArray> cell_data;

  /// Polynomial degree of each cell; empty: left out (VTK then tells it from the number of points).
  std::vector<int> degrees;
  /// Weight of each point of rational Bezier cells; empty: not rational.
  std::vector<double> rational_weights;

  void add_cell(VtkCell type, std::span<const std::int64_t> cell_points);
};

/// Writes an unstructured grid: VTK XML version 1.0, raw appended data, zlib blocks, UInt64 headers.
/// ParaView, VTK and meshio read it. In ParaView curved cells look straight until "Nonlinear
/// Subdivision Level" is 3 or 4.
void write_vtu(const ByteSink& sink, const VtuGrid& grid);
/// The same to a file. @throws OutputError
void write_vtu(const std::filesystem::path& file, const VtuGrid& grid);

/// Where the points of a Lagrange (70) or Bezier (77) quad of degree p >= 1 lie: grid indices
/// (i, j), 0 <= i, j <= p, in VTK's order: corners, edges v=0, u=p, v=p, u=0 each in increasing
/// parameter, interior rows with i fastest.
[[nodiscard]] std::vector<std::array<int, 2>> vtk_quad_points(int degree);

/// The same for a Lagrange (69) or Bezier (76) triangle: (i, j) with i + j <= p, where i counts
/// towards the second corner and j towards the third. Corners, edges 1-2, 2-3, 3-1 each in this
/// direction, then the interior as a triangle of degree p - 3.
[[nodiscard]] std::vector<std::array<int, 2>> vtk_triangle_points(int degree);

}  // namespace limes
