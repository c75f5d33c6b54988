#include "limes/limit/curved_cells.h"

#include <algorithm>
#include <array>
#include <limits>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

constexpr int max_depth = 40;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The cubic Lagrange polynomials of the nodes 0, 1/3, 2/3, 1.
std::array<double, 4> lagrange(double t) {
  const double a = t, b = 3.0 * t - 1.0, c = 3.0 * t - 2.0, d = t - 1.0;
  return {-b * c * d / 2.0, 9.0 * a * c * d / 2.0, -9.0 * a * b * d / 2.0, a * b * c / 2.0};
}

/// Where cells are compared with the surface, in both directions: between the nodes, and close to
/// the borders, where the polynomial near an extraordinary vertex is worst.
constexpr std::array<double, 9> sample_parameters{
    0.5, 1.0 / 9.0, 8.0 / 9.0, 2.0 / 9.0, 7.0 / 9.0, 1.0 / 24.0, 23.0 / 24.0, 0.0, 1.0};

/// Converts one face.
class FaceCells {
 public:
  FaceCells(const LimitSurface& surface, FaceId face, double tolerance, CurvedCells& out)
      : surface_(surface), face_(face), tolerance_(tolerance), out_(out) {}

  void convert() {
    const LimitBasis& basis = surface_.basis();
    const int kind = basis.kind(face_);
    const bool quad = basis.topology().face_size(face_) == 4;
    for (int corner = 0; corner < basis.num_quadrants(face_); ++corner) {
      const int quadrant =
          quad ? kind : basis.kinds().refined(kind).children[static_cast<std::size_t>(corner)].kind;
      visit({quadrant, 0, 0}, {face_, corner, Vec2::Zero(), 1.0, false, 0.0});
    }
  }

 private:
  /// A square on the way down: its kind, whose corner 0 is the square's corner `rotation`.
  struct Step {
    int kind, rotation, depth;
  };

  void visit(const Step& step, CurvedCells::Cell cell) {
    cell.exact = surface_.basis().kinds()[step.kind].patch.has_value();
    if (!cell.exact) {
      const bool can_split = step.depth < max_depth;
      cell.deviation = deviation(cell, can_split ? tolerance_ : infinity);
      if (can_split && cell.deviation > tolerance_) return split(step, cell);
    }
    append(cell);
  }

  void split(const Step& step, const CurvedCells::Cell& cell) {
    const RefinedKind& kind = surface_.basis().kinds().refined(step.kind);
    const double half = 0.5 * cell.size;
    for (int q = 0; q < 4; ++q) {
      const int child = (q - step.rotation + 4) % 4;
      CurvedCells::Cell part = cell;
      part.origin += half * square_corners[static_cast<std::size_t>(q)];
      part.size = half;
      part.deviation = 0.0;
      visit({kind.children[static_cast<std::size_t>(child)].kind, q, step.depth + 1}, part);
    }
  }

  [[nodiscard]] static Vec2 parameters(const CurvedCells::Cell& cell, double s, double t) {
    return cell.origin + cell.size * Vec2(s, t);
  }

  /// Stops once it is larger than `enough`.
  [[nodiscard]] double deviation(const CurvedCells::Cell& cell, double enough) const {
    std::array<Vec3, CurvedCells::nodes_per_cell> nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      nodes[k] = surface_.position(face_, cell.corner, node(cell, k));
    double largest = 0;
    for (const double t : sample_parameters) {
      const auto along_v = lagrange(t);
      for (const double s : sample_parameters) {
        const auto along_u = lagrange(s);
        Vec3 x = -surface_.position(face_, cell.corner, parameters(cell, s, t));
        for (std::size_t k = 0; k < nodes.size(); ++k)
          x += along_u[k % 4] * along_v[k / 4] * nodes[k];
        largest = std::max(largest, x.norm());
        if (largest > enough) return largest;
      }
    }
    return largest;
  }

  [[nodiscard]] static Vec2 node(const CurvedCells::Cell& cell, std::size_t k) {
    // 3 / 3 is 1: nodes at the far border lie exactly on it
    return parameters(cell, static_cast<double>(k % 4) / 3.0, static_cast<double>(k / 4) / 3.0);
  }

  void append(const CurvedCells::Cell& cell) {
    out_.cells.push_back(cell);
    for (std::size_t k = 0; k < CurvedCells::nodes_per_cell; ++k) {
      const SurfacePoint p = surface_.evaluate(face_, cell.corner, node(cell, k));
      out_.points.push_back(p.x);
      out_.normals.push_back(p.normal.value_or(Vec3::Constant(nan)));
      out_.mean.push_back(p.curvature ? p.curvature->mean : nan);
      out_.gauss.push_back(p.curvature ? p.curvature->gauss : nan);
    }
  }

  const LimitSurface& surface_;
  FaceId face_;
  double tolerance_;
  CurvedCells& out_;
};

template <class T>
void append(std::vector<T>& all, const std::vector<T>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

/// f at 0, 1/3, 2/3, 1 becomes the Bernstein coefficients of the cubic through it.
template <class T>
void cubic_bernstein(T& f0, T& f1, T& f2, T& f3) {
  const T b1 = (-5.0 * f0 + 18.0 * f1 - 9.0 * f2 + 2.0 * f3) / 6.0;
  const T b2 = (2.0 * f0 - 9.0 * f1 + 18.0 * f2 - 5.0 * f3) / 6.0;
  f1 = b1;
  f2 = b2;
}

template <class T>
std::vector<T> cells_to_bernstein(std::span<const T> nodes) {
  LIMES_ASSERT(nodes.size() % CurvedCells::nodes_per_cell == 0);
  std::vector<T> c(nodes.begin(), nodes.end());
  for (std::size_t row = 0; row < c.size(); row += 4)
    cubic_bernstein(c[row], c[row + 1], c[row + 2], c[row + 3]);
  for (std::size_t cell = 0; cell < c.size(); cell += CurvedCells::nodes_per_cell)
    for (std::size_t k = cell; k < cell + 4; ++k)
      cubic_bernstein(c[k], c[k + 4], c[k + 8], c[k + 12]);
  return c;
}

}  // namespace

double CurvedCells::deviation() const {
  double largest = 0;
  for (const Cell& cell : cells)
    largest = std::max(largest, cell.deviation);
  return largest;
}

CurvedCells curved_cells(const LimitSurface& surface, std::span<const FaceId> faces,
                         double tolerance) {
  LIMES_ASSERT(tolerance > 0);
  std::vector<CurvedCells> parts(faces.size());
  for_each_block(
      static_cast<std::int64_t>(faces.size()), 16, [&](std::int64_t begin, std::int64_t end) {
        check_interrupt();
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          FaceCells(surface, faces[i], tolerance, parts[i]).convert();
      });
  CurvedCells all;
  for (CurvedCells& part : parts) {
    append(all.cells, part.cells);
    append(all.points, part.points);
    append(all.normals, part.normals);
    append(all.mean, part.mean);
    append(all.gauss, part.gauss);
    part = {};
  }
  return all;
}

std::vector<double> bernstein_coefficients(std::span<const double> nodes) {
  return cells_to_bernstein(nodes);
}
std::vector<Vec3> bernstein_coefficients(std::span<const Vec3> nodes) {
  return cells_to_bernstein(nodes);
}

}  // namespace limes
