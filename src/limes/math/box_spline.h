#pragma once

#include "limes/core/types.h"

namespace limes {

// Polynomials of degree 4 on the triangle with the corners (0, 0), (1, 0), (0, 1) and the barycentric
// coordinates w = 1 - u - v, u, v. Bernstein polynomial (i, j) is 4!/(i! j! k!) u^i v^j w^k with
// i + j + k = 4; number triangle_index(i, j) in a list that is sorted by j, then i.

[[nodiscard]] constexpr int triangle_index(int i, int j) {
  return j * (11 - j) / 2 + i;
}

/// The 15 Bernstein polynomials at a point, one a row. Columns: value, d/du, d/dv, d2/du2, d2/dudv,
/// d2/dv2.
[[nodiscard]] Eigen::Matrix<double, 15, 6> quartic_bernstein(const Vec2& uv);

/// The twelve quartic box splines that live on the triangle, as rows of Bernstein coefficients,
/// (12, 15), [stam_triangles_1998] appendix A. Row box_spline_index(i, j) belongs to the control point
/// i (1, 0) + j (0, 1) of the regular triangulation whose triangle this is.
[[nodiscard]] const Eigen::Matrix<double, 12, 15>& box_spline_coefficients();

/// Control points in the order of j, then i:
///
///          10  11              (-1, 2) (0, 2)
///         7   8   9          (-1, 1) (0, 1) (1, 1)
///       3   4   5   6      (-1, 0) (0, 0) (1, 0) (2, 0)
///         0   1   2            (0, -1) (1, -1) (2, -1)
[[nodiscard]] constexpr int box_spline_index(int i, int j) {
  constexpr int first[] = {0, 4, 8, 11};  // place of i = 0
  return first[j + 1] + i;
}

}  // namespace limes
