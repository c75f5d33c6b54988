#pragma once

#include <span>

#include "limes/core/id_array.h"
#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"

namespace limes {

struct Directors {
  IdArray<HalfedgeId, Vec3> at_corner;  ///< unit length
  IdArray<VertexId, char> smooth;       ///< 1: all corners of the vertex share one
};

/// Means of corner normals around every vertex. Where the normals of two faces that share an edge at
/// the vertex differ by more than the kink angle, the mean ends there and another begins.
/// @param corner_normal  unit normal at each corner of each face
/// @param kink_angle     in degrees
[[nodiscard]] Directors mean_directors(const Adjacency& adjacency,
                                       const IdArray<HalfedgeId, Vec3>& corner_normal,
                                       double kink_angle);

}  // namespace limes
