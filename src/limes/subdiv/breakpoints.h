#pragma once

#include <span>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/features.h"

namespace limes {

/// Where the curves of an open net (open_net.h) break.
enum class CornerRule {
  by_angle,  ///< where they turn by more than breakpoint_angle
  none,      ///< only where the surface leaves no choice, see add_breakpoints()
  all        ///< where a part has a single face
};

/// In degrees, between the directions of the two curve edges at a vertex.
constexpr double breakpoint_angle = 30.0;

/// Adds the breakpoints of a control mesh to its features, as infinitely sharp vertices, which
/// refined meshes inherit. Curve vertices with equal positions belong together, so that parts that
/// meet in a seam keep meeting there: if one breaks, all do. Whatever the rule, they break where the
/// curves that meet there have one or more than two directions; and, unless it is none, where three
/// or more parts (connected pieces of the mesh) meet.
/// @param points  one per vertex
void add_breakpoints(const Adjacency& mesh, std::span<const Vec3> points, CornerRule rule,
                     Features& features);

}  // namespace limes
