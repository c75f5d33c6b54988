#include "limes/limit/tile_coefficients.h"

#include <cmath>

namespace limes {
namespace {

using Line = std::array<Vec3, 4>;
/// c[i][j]: coefficient of s^i t^j.
using Polynomial = std::array<Line, 4>;

/// Row k of A times the points.
Vec3 row_times(const SparseMatrix& A, int row, const std::vector<Vec3>& points) {
  const int* outer = A.outerIndexPtr();
  const int* column = A.innerIndexPtr();
  const double* value = A.valuePtr();
  double x = 0, y = 0, z = 0;
  for (int e = outer[row]; e < outer[row + 1]; ++e) {
    const Vec3& p = points[static_cast<std::size_t>(column[e])];
    x += value[e] * p.x();
    y += value[e] * p.y();
    z += value[e] * p.z();
  }
  return {x, y, z};
}

/// Entry (i, j) of a grid in the frame that begins at its corner `turn`.
int turned_entry(int turn, int i, int j) {
  switch (turn) {
    case 0:
      return 4 * j + i;
    case 1:
      return 4 * i + 3 - j;
    case 2:
      return 4 * (3 - j) + 3 - i;
    default:
      return 4 * (3 - i) + j;
  }
}

/// Lines of the grid: r1, r0 - r1, r2 - r1, r3 - r1 in each of four columns.
std::array<Line, 4> grid_lines(const SparseMatrix& grid, int turn, const LocalControls& controls) {
  std::array<Line, 4> lines;
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto point = [&](int j) {
      return row_times(grid, turned_entry(turn, i, j), controls.points);
    };
    lines[0][at] = point(1);
    lines[1][at] = point(0) - lines[0][at];
    lines[2][at] = point(2) - lines[0][at];
    lines[3][at] = point(3) - lines[0][at];
  }
  return lines;
}

std::array<Line, 4> mapped_lines(const Eigen::Matrix4d& W, const std::array<Line, 4>& lines) {
  std::array<Line, 4> out;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 4; ++i) {
      out[k][i] = Vec3::Zero();
      for (std::size_t l = 0; l < 4; ++l)
        out[k][i] += W(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)) * lines[l][i];
    }
  return out;
}

/// From B-splines to powers, across the lines and along them.
Polynomial powers(const std::array<Line, 4>& lines) {
  std::array<Line, 4> across;  // by power of t
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& d0 = lines[1][i];
    const Vec3& d2 = lines[2][i];
    const Vec3& d3 = lines[3][i];
    const Vec3 sum = d0 + d2;
    across[0][i] = lines[0][i] + sum / 6.0;
    across[1][i] = (d2 - d0) / 2.0;
    across[2][i] = sum / 2.0;
    across[3][i] = (d3 - d0 - 3.0 * d2) / 6.0;
  }
  Polynomial c;
  for (std::size_t j = 0; j < 4; ++j) {
    const Line& g = across[j];
    const Vec3 d0 = g[0] - g[1];
    const Vec3 d2 = g[2] - g[1];
    const Vec3 d3 = g[3] - g[1];
    const Vec3 sum = d0 + d2;
    c[0][j] = g[1] + sum / 6.0;
    c[1][j] = (d2 - d0) / 2.0;
    c[2][j] = sum / 2.0;
    c[3][j] = (d3 - d0 - 3.0 * d2) / 6.0;
  }
  return c;
}

/// p(1 - t) from p(t).
void reflect(Vec3& c0, Vec3& c1, Vec3& c2, Vec3& c3) {
  c0 += c1 + c2 + c3;
  c1 = -(c1 + 2.0 * c2 + 3.0 * c3);
  c2 += 3.0 * c3;
  c3 = -c3;
}

/// From a frame that begins at corner `rotation` to u and v.
Polynomial turned_back(Polynomial c, int rotation) {
  if (rotation >= 2)  // s runs against its parameter
    for (std::size_t j = 0; j < 4; ++j)
      reflect(c[0][j], c[1][j], c[2][j], c[3][j]);
  if (rotation == 1 || rotation == 2)
    for (Line& line : c)
      reflect(line[0], line[1], line[2], line[3]);
  if (rotation % 2 == 1)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        std::swap(c[i][j], c[j][i]);
  return c;
}

}  // namespace

void refine_controls(const RefinedKind& parent, int child, const LocalControls& controls,
                     LocalControls& out) {
  const SparseMatrix& A = parent.children[static_cast<std::size_t>(child)].A;
  out.points.resize(static_cast<std::size_t>(A.rows()));
  // Rows of A sum to one: a common point can be taken out at any time.
  const Vec3 first = row_times(A, 0, controls.points);
  out.base = controls.base + first;
  out.points[0] = Vec3::Zero();
  for (int row = 1; row < static_cast<int>(A.rows()); ++row)
    out.points[static_cast<std::size_t>(row)] = row_times(A, row, controls.points) - first;
}

void tile_coefficients(const SparseMatrix& grid, int turn, const Eigen::Matrix4d* rows,
                       int rotation, const TileTree::Rectangle& rectangle,
                       const LocalControls& controls, double* out) {
  std::array<Line, 4> lines = grid_lines(grid, turn, controls);
  if (rows) lines = mapped_lines(*rows, lines);
  const Polynomial c = turned_back(powers(lines), rotation);
  const double scale_u = std::ldexp(1.0, rectangle.ku);
  const double scale_v = std::ldexp(1.0, rectangle.kv);
  double along_u = 1.0;
  for (std::size_t i = 0; i < 4; ++i, along_u *= scale_u) {
    double scale = along_u;
    for (std::size_t j = 0; j < 4; ++j, scale *= scale_v) {
      double* to = out + 4 * (4 * i + j);
      for (int k = 0; k < 3; ++k)
        to[k] = scale * c[i][j][k];
      to[3] = 0;
    }
  }
  for (int k = 0; k < 3; ++k)
    out[k] += controls.base[k];
  out[3] = rectangle.u;
  out[7] = rectangle.v;
}

void TileFiller::fill(const RingKinds& kinds, const TileTree& tree,
                      std::span<const VertexId> controls, std::span<const Vec3> points,
                      double* out) {
  if (squares_.size() < tree.squares.size()) squares_.resize(tree.squares.size());
  LocalControls& face = squares_[0];
  face.base = points[static_cast<std::size_t>(controls[0].value)];
  face.points.resize(controls.size());
  for (std::size_t k = 0; k < controls.size(); ++k)
    face.points[k] = points[static_cast<std::size_t>(controls[k].value)] - face.base;
  for (std::size_t i = 1; i < tree.squares.size(); ++i) {
    const TileTree::Square& square = tree.squares[i];
    const auto parent = static_cast<std::size_t>(square.parent);
    refine_controls(kinds.refined(tree.squares[parent].kind), square.child, squares_[parent],
                    squares_[i]);
  }
  double* to = out;
  for (const TileTree::Tile& tile : tree.tiles) {
    const auto square = static_cast<std::size_t>(tile.square);
    const Eigen::Matrix4d* rows =
        tile.rows < 0 ? nullptr : &tree.row_maps[static_cast<std::size_t>(tile.rows)];
    tile_coefficients(tree.grids[static_cast<std::size_t>(tile.grid)], tile.turn, rows,
                      (tree.squares[square].rotation + tile.turn) % 4, tile.rectangle,
                      squares_[square], to);
    to += TileTree::numbers_per_tile;
  }
  for (const TileTree::Deep& deep : tree.deep) {
    const LocalControls& at = squares_[static_cast<std::size_t>(deep.square)];
    double* numbers = out + deep.first;
    const auto put = [&](const Vec3& x) {
      for (int k = 0; k < 3; ++k)
        *numbers++ = x[k];
    };
    put(at.base);
    for (const Vec3& x : at.points)
      put(x);
  }
}

}  // namespace limes
