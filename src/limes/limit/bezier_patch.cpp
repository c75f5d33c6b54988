#include "limes/limit/bezier_patch.h"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

/// Columns: the cubic Bernstein polynomials, their first and second derivatives.
Eigen::Matrix<double, 4, 3> bernstein(double t) {
  const double s = 1.0 - t;
  Eigen::Matrix<double, 4, 3> B;
  B.col(0) << s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t;
  B.col(1) << -3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t;
  B.col(2) << 6.0 * s, 6.0 * (t - 2.0 * s), 6.0 * (s - 2.0 * t), 6.0 * t;
  return B;
}

using Line = std::array<Eigen::RowVector3d, 4>;

/// De Casteljau's algorithm at 1/2; both halves.
std::array<Line, 2> halves(const Line& c) {
  const Eigen::RowVector3d c01 = 0.5 * (c[0] + c[1]), c12 = 0.5 * (c[1] + c[2]),
                           c23 = 0.5 * (c[2] + c[3]);
  const Eigen::RowVector3d c012 = 0.5 * (c01 + c12), c123 = 0.5 * (c12 + c23);
  const Eigen::RowVector3d middle = 0.5 * (c012 + c123);
  return {Line{c[0], c01, c012, middle}, Line{middle, c123, c23, c[3]}};
}

}  // namespace

Eigen::Matrix<double, 16, Eigen::Dynamic> bernstein_rows(
    const Eigen::Matrix<double, 16, Eigen::Dynamic, Eigen::RowMajor>& bspline) {
  Eigen::Matrix4d C;  // uniform cubic B-spline to Bernstein
  C << 1, 4, 1, 0, 0, 4, 2, 0, 0, 2, 4, 0, 0, 1, 4, 1;
  C /= 6.0;
  Eigen::Matrix<double, 16, 16> tensor;
  for (int j = 0; j < 4; ++j)
    for (int l = 0; l < 4; ++l)
      tensor.block<4, 4>(4 * j, 4 * l) = C(j, l) * C;
  return tensor * bspline;
}

PatchJet evaluate(const BezierPatch& patch, const Vec2& uv) {
  const Eigen::Matrix<double, 4, 3> U = bernstein(uv.x());
  const Eigen::Matrix<double, 4, 3> V = bernstein(uv.y());
  PatchJet jet;
  for (int d = 0; d < 3; ++d) {
    const Eigen::Map<const Eigen::Matrix4d> c(patch.col(d).data());
    const Eigen::Matrix<double, 4, 3> lines = c.lazyProduct(V);
    jet.x[d] = U.col(0).dot(lines.col(0));
    jet.xu[d] = U.col(1).dot(lines.col(0));
    jet.xv[d] = U.col(0).dot(lines.col(1));
    jet.xuu[d] = U.col(2).dot(lines.col(0));
    jet.xuv[d] = U.col(1).dot(lines.col(1));
    jet.xvv[d] = U.col(0).dot(lines.col(2));
  }
  return jet;
}

std::array<BezierPatch, 2> halves(const BezierPatch& patch, int direction) {
  const int along = direction == 0 ? 1 : 4;
  const int across = direction == 0 ? 4 : 1;
  std::array<BezierPatch, 2> result;
  for (int line = 0; line < 4; ++line) {
    Line c;
    for (int k = 0; k < 4; ++k)
      c[static_cast<std::size_t>(k)] = patch.row(across * line + along * k);
    const std::array<Line, 2> parts = halves(c);
    for (std::size_t half = 0; half < 2; ++half)
      for (int k = 0; k < 4; ++k)
        result[half].row(across * line + along * k) = parts[half][static_cast<std::size_t>(k)];
  }
  return result;
}

Vec2 extents(const BezierPatch& patch) {
  Vec2 longest = Vec2::Zero();
  for (int line = 0; line < 4; ++line) {
    Vec2 length = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
      length.x() += (patch.row(4 * line + k + 1) - patch.row(4 * line + k)).norm();
      length.y() += (patch.row(4 * (k + 1) + line) - patch.row(4 * k + line)).norm();
    }
    longest = longest.cwiseMax(length);
  }
  return longest;
}

}  // namespace limes
