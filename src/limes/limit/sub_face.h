#pragma once

#include "limes/core/types.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// The parameters of a point in a sub-face, and how they depend on those of the face.
struct LocalPoint {
  Vec2 uv;
  Mat2 J = Mat2::Identity();  ///< d(local)/d(face)
};

/// The child (see RefinedKind) of a regular face that holds a point. Borders belong to the child
/// that is farther from corner 0, so that only corner 0 itself stays with child 0 forever.
[[nodiscard]] int child_at(Split split, const Vec2& uv);

/// The point in the parameters of a child.
[[nodiscard]] LocalPoint into_child(Split split, const LocalPoint& p, int child);

}  // namespace limes
