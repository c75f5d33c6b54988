#pragma once

#include <span>
#include <vector>

#include "limes/limit/surface_tree.h"

namespace limes {

/// A point of a limit surface and where it is: parameters as in LimitBasis.
struct ClosestHit {
  FaceId face;
  int corner;
  Vec2 uv;
  Vec3 point;
  double distance;  ///< from the query, as exact as the query and the points are given
};

/// The point of the surface that is closest to q.
///
/// Global: no point of the surface is closer by more than 1e-13 of the surface's size (and an ulp
/// of the distance), whatever the surface looks like and wherever q is. Where the distance has one
/// regular minimum, the point is right to rounding. Of points equally close to 1e-15 of the size
/// it is one of the lowest face, there of the lowest corner. See docs/theory/closest-point.md.
/// @throws InputError if q is not finite
[[nodiscard]] ClosestHit closest_point(const SurfaceTree& tree, const Vec3& q);

/// The same for many, in parallel: hits[i] is bitwise closest_point(tree, queries[i]).
/// @throws InputError that names the first query that is not finite
[[nodiscard]] std::vector<ClosestHit> closest_points(const SurfaceTree& tree,
                                                     std::span<const Vec3> queries);

}  // namespace limes
