#pragma once

#include <array>

#include "limes/core/types.h"

namespace limes {

/// A bicubic polynomial on [0, 1]^2 by its Bernstein coefficients, (16, 3): row 4 j + i belongs to
/// degree i in u and j in v. The patch lies in the convex hull of its coefficients.
using BezierPatch = Eigen::Matrix<double, 16, 3>;

/// Bernstein coefficients of the patch whose B-spline control points are the rows of `bspline`,
/// (16, k), in the order of PatchGrid; any columns.
[[nodiscard]] Eigen::Matrix<double, 16, Eigen::Dynamic> bernstein_rows(
    const Eigen::Matrix<double, 16, Eigen::Dynamic, Eigen::RowMajor>& bspline);

/// Value and derivatives at one point.
struct PatchJet {
  Vec3 x, xu, xv, xuu, xuv, xvv;
};
[[nodiscard]] PatchJet evaluate(const BezierPatch& patch, const Vec2& uv);

/// The two halves, each on [0, 1]^2 again. @param direction  0: cut at u = 1/2; 1: at v = 1/2
[[nodiscard]] std::array<BezierPatch, 2> halves(const BezierPatch& patch, int direction);

/// Upper bounds for the lengths of the lines of the patch along u and along v.
[[nodiscard]] Vec2 extents(const BezierPatch& patch);

}  // namespace limes
