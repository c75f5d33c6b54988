#pragma once

#include <array>
#include <functional>

#include "limes/core/ids.h"
#include "limes/core/types.h"

namespace limes {

/// Moves a new vertex onto a surface, from halfway between others.
/// @param face  of the control mesh, in which the vertex lies
/// @param edge  a side of that face on which it lies; invalid: it lies inside
/// @return      the same for both faces of an edge
using Placement = std::function<Vec3(const Vec3& x, FaceId face, HalfedgeId edge)>;

/// Centre of a quad between its sides, each given by its middle: bilinear transfinite interpolation. The
/// mean of the corners would come too close to a side that bulges into the quad, or cross it.
[[nodiscard]] inline Vec3 between_sides(const std::array<Vec3, 4>& corners,
                                        const std::array<Vec3, 4>& middles) {
  return ((middles[0] + middles[2]) + (middles[1] + middles[3])) / 2 -
         ((corners[0] + corners[2]) + (corners[1] + corners[3])) / 4;
}

}  // namespace limes
