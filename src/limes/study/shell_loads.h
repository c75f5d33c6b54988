#pragma once

#include <functional>

#include "limes/study/shell_model.h"

namespace limes {

/// Sum of the problem's loads, one entry per unknown of the shell.
/// @throws InputError for selections that meet nothing, and for moments about the director of a
///         smooth node, which no shell carries
[[nodiscard]] VectorX assemble_shell_loads(const ShellModel& model);

/// The same loads at single points; forces and moments at vertices are no part of it. Called by one thread
/// at a time, because it evaluates expressions. The model must outlive it.
struct ShellLoadDensity {
  /// Force per area. @param normal  of the surface there
  std::function<Vec3(FaceId face, const Vec3& x, const Vec3& normal)> on_face;
  /// Force per length of a side's chord, of sides on a border.
  std::function<Vec3(HalfedgeId side, const Vec3& x)> on_side;
};
/// @throws InputError as above, the functions for a formula without a value
[[nodiscard]] ShellLoadDensity shell_load_density(const ShellModel& model);

}  // namespace limes
