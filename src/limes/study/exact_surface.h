#pragma once

#include "limes/study/problem.h"

namespace limes {

/// The nearest point of the exact surface; of a graph the one above or below.
/// @throws InputError "what" if x is on the axis or at the centre, where no point is nearest
[[nodiscard]] Vec3 project(const GeometrySettings& surface, const Vec3& x);

/// Unit normal at (or above) a point, away from the axis or centre.
[[nodiscard]] Vec3 outward_normal(const GeometrySettings& surface, const Vec3& x);

}  // namespace limes
