#include "limes/limit/cell_shape.h"

#include <Eigen/LU>
#include <array>

#include "limes/math/box_spline.h"

namespace limes {
namespace {

constexpr std::array<double, 9> sample_parameters{
    0.5, 1.0 / 9.0, 8.0 / 9.0, 2.0 / 9.0, 7.0 / 9.0, 1.0 / 24.0, 23.0 / 24.0, 0.0, 1.0};

/// The cubic Lagrange polynomials of the nodes 0, 1/3, 2/3, 1.
std::array<double, 4> lagrange(double t) {
  const double a = t, b = 3.0 * t - 1.0, c = 3.0 * t - 2.0, d = t - 1.0;
  return {-b * c * d / 2.0, 9.0 * a * c * d / 2.0, -9.0 * a * b * d / 2.0, a * b * c / 2.0};
}

CellShape square() {
  CellShape shape{3, {}, MatrixX(16, 16), {}, {}, false};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      shape.nodes.emplace_back(i / 3.0, j / 3.0);
  Eigen::Matrix4d C;  // of the cubic through values at 0, 1/3, 2/3, 1
  C << 6, 0, 0, 0, -5, 18, -9, 2, 2, -9, 18, -5, 0, 0, 0, 6;
  C /= 6.0;
  for (int j = 0; j < 4; ++j)
    for (int l = 0; l < 4; ++l)
      shape.to_bernstein.block<4, 4>(4 * j, 4 * l) = C(j, l) * C;
  for (const double t : sample_parameters)
    for (const double s : sample_parameters)
      shape.samples.emplace_back(s, t);
  shape.sample_weights.resize(static_cast<Eigen::Index>(shape.samples.size()), 16);
  for (std::size_t k = 0; k < shape.samples.size(); ++k) {
    const auto along_u = lagrange(shape.samples[k].x());
    const auto along_v = lagrange(shape.samples[k].y());
    for (std::size_t n = 0; n < 16; ++n)
      shape.sample_weights(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(n)) =
          along_u[n % 4] * along_v[n / 4];
  }
  return shape;
}

CellShape triangle() {
  CellShape shape{4, {}, {}, {}, {}, true};
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i + j <= 4; ++i)
      shape.nodes.emplace_back(i / 4.0, j / 4.0);
  const auto bernstein = [](const std::vector<Vec2>& points) {
    MatrixX B(static_cast<Eigen::Index>(points.size()), 15);
    for (std::size_t k = 0; k < points.size(); ++k)
      B.row(static_cast<Eigen::Index>(k)) = quartic_bernstein(points[k]).col(0).transpose();
    return B;
  };
  shape.to_bernstein = bernstein(shape.nodes).fullPivLu().inverse();
  shape.samples.emplace_back(1.0 / 3.0, 1.0 / 3.0);
  for (const double t : sample_parameters)
    for (const double s : sample_parameters)
      if (s + t <= 1) shape.samples.emplace_back(s, t);
  shape.sample_weights = bernstein(shape.samples) * shape.to_bernstein;
  return shape;
}

}  // namespace

const CellShape& cell_shape(Split split) {
  static const CellShape squares = square();
  static const CellShape triangles = triangle();
  return split == Split::triangles ? triangles : squares;
}

}  // namespace limes
