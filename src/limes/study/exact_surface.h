#pragma once

#include <span>

#include "limes/problem/surface_settings.h"

namespace limes {

/// The nearest point of the exact surface (of a cone its apex, where that is nearest); of a graph the one above or below, of a formula the one that
/// steps along its gradient lead to.
/// @throws InputError "what" if x is on the axis or at the centre, where no point is nearest, or the
///         steps lead nowhere
[[nodiscard]] Vec3 project(const GeometrySettings& surface, const Vec3& x);

/// A point that all surfaces have in common, near x: shortest steps that solve their linear parts
/// (Gauss-Newton), so that three surfaces give a point, two a curve and one a surface.
/// @throws InputError "what" if they do not meet near x
[[nodiscard]] Vec3 project(std::span<const GeometrySettings* const> surfaces, const Vec3& x);

/// Unit vectors along all surfaces at once, orthogonal to each other, as columns: two for one surface,
/// one along a curve, none at a point. Surfaces that touch at x count as one.
[[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic> directions_on(
    std::span<const GeometrySettings* const> surfaces, const Vec3& x);

/// Unit normal at (or above) a point, away from the axis, centre or middle of the tube, or to where a formula grows.
[[nodiscard]] Vec3 outward_normal(const GeometrySettings& surface, const Vec3& x);

}  // namespace limes
