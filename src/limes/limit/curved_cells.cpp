#include "limes/limit/curved_cells.h"

#include <algorithm>
#include <limits>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

constexpr int max_depth = 40;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Converts one face.
class FaceCells {
 public:
  FaceCells(const LimitSurface& surface, FaceId face, double tolerance, CurvedCells& out)
      : surface_(surface),
        shape_(cell_shape(surface.basis().scheme().split)),
        face_(face),
        tolerance_(tolerance),
        out_(out) {}

  void convert() {
    const LimitBasis& basis = surface_.basis();
    const int kind = basis.kind(face_);
    const int num_quadrants = basis.num_quadrants(face_);
    for (int corner = 0; corner < num_quadrants; ++corner) {
      const int quadrant =
          num_quadrants == 1
              ? kind
              : basis.kinds().refined(kind).children[static_cast<std::size_t>(corner)].kind;
      visit({quadrant, 0, 0}, {face_, corner, Vec2::Zero(), 1.0, false, 0.0});
    }
  }

 private:
  /// A cell on the way down: its kind, whose corner 0 is the cell's corner `rotation`.
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
    const int num_corners = shape_.triangle ? 3 : 4;
    for (int q = 0; q < num_corners; ++q) {
      const auto corner = static_cast<std::size_t>(q);
      const int child = (q - step.rotation + num_corners) % num_corners;
      visit_part(step, child, q, cell,
                 shape_.triangle ? triangle_corners[corner] : square_corners[corner], 0.5);
    }
    // Upside down; its first corner lies opposite the triangle's.
    if (shape_.triangle) visit_part(step, 3, (step.rotation + 2) % 3, cell, Vec2(1, 1), -0.5);
  }
  void visit_part(const Step& step, int child, int rotation, const CurvedCells::Cell& cell,
                  const Vec2& origin, double size) {
    const RefinedKind& kind = surface_.basis().kinds().refined(step.kind);
    CurvedCells::Cell part = cell;
    part.origin += 0.5 * cell.size * origin;
    part.size *= size;
    part.deviation = 0.0;
    visit({kind.children[static_cast<std::size_t>(child)].kind, rotation, step.depth + 1}, part);
  }

  [[nodiscard]] static Vec2 parameters(const CurvedCells::Cell& cell, const Vec2& st) {
    return cell.origin + cell.size * st;
  }

  /// Stops once it is larger than `enough`.
  [[nodiscard]] double deviation(const CurvedCells::Cell& cell, double enough) const {
    const auto at = [&](const Vec2& st) {
      return surface_.position(face_, cell.corner, parameters(cell, st));
    };
    Eigen::Matrix<double, Eigen::Dynamic, 3> nodes(shape_.num_nodes(), 3);
    for (std::size_t k = 0; k < shape_.nodes.size(); ++k)
      nodes.row(static_cast<Eigen::Index>(k)) = at(shape_.nodes[k]).transpose();
    double largest = 0;
    for (std::size_t k = 0; k < shape_.samples.size(); ++k) {
      const Vec3 x = (shape_.sample_weights.row(static_cast<Eigen::Index>(k)) * nodes).transpose();
      largest = std::max(largest, (x - at(shape_.samples[k])).norm());
      if (largest > enough) break;
    }
    return largest;
  }

  void append(const CurvedCells::Cell& cell) {
    out_.cells.push_back(cell);
    for (const Vec2& node : shape_.nodes) {
      const SurfacePoint p = surface_.evaluate(face_, cell.corner, parameters(cell, node));
      out_.points.push_back(p.x);
      out_.normals.push_back(p.normal.value_or(Vec3::Constant(nan)));
      out_.mean.push_back(p.curvature ? p.curvature->mean : nan);
      out_.gauss.push_back(p.curvature ? p.curvature->gauss : nan);
    }
  }

  const LimitSurface& surface_;
  const CellShape& shape_;
  FaceId face_;
  double tolerance_;
  CurvedCells& out_;
};

template <class T>
void append(std::vector<T>& all, const std::vector<T>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

template <class T>
std::vector<T> cells_to_bernstein(const CellShape& shape, std::span<const T> nodes) {
  const auto n = static_cast<std::size_t>(shape.num_nodes());
  LIMES_ASSERT(nodes.size() % n == 0);
  std::vector<T> coefficients;
  coefficients.reserve(nodes.size());
  for (std::size_t cell = 0; cell < nodes.size(); cell += n)
    for (std::size_t row = 0; row < n; ++row) {
      const auto weight = [&](std::size_t k) {
        return shape.to_bernstein(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
      };
      T sum = weight(0) * nodes[cell];
      for (std::size_t k = 1; k < n; ++k)
        sum += weight(k) * nodes[cell + k];
      coefficients.push_back(sum);
    }
  return coefficients;
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

std::vector<double> bernstein_coefficients(const CellShape& shape, std::span<const double> nodes) {
  return cells_to_bernstein(shape, nodes);
}
std::vector<Vec3> bernstein_coefficients(const CellShape& shape, std::span<const Vec3> nodes) {
  return cells_to_bernstein(shape, nodes);
}

}  // namespace limes
