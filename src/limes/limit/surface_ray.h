#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "limes/limit/surface_tree.h"

namespace limes {

/// The points origin + t direction, t_min <= t <= t_max. The direction may have any length but 0.
struct Ray {
  Vec3 origin, direction;
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();
};

/// Where a ray meets a limit surface: parameters as in LimitBasis.
struct RayHit {
  /// Where the ray comes from: the side that normals point to (front), the other, or neither, where
  /// the ray is tangent to the surface or the surface has no normal.
  enum class Side { front, back, edge_on };

  double t;
  FaceId face;
  int corner;
  Vec2 uv;
  Vec3 point;  ///< of the surface
  Side side;
};

/// The first point of the surface on the ray, seen from either side.
///
/// "On the ray" means within 1e-13 of the surface's size (and rounding of the ray's origin), so that
/// no ray slips through between faces; the same holds for the ends of the range of t. Where a ray
/// touches the surface, or runs in it, the hit is the first point that is so close. Of hits at the
/// same t, to 1e-13 of the size, it is the one of the lowest face, there of the lowest corner.
/// @throws InputError for a ray whose numbers are not finite (t_min and t_max may be infinite), with
///         direction 0 or t_min > t_max
[[nodiscard]] std::optional<RayHit> first_hit(const SurfaceTree& tree, const Ray& ray);

/// The same for many, in parallel: hits[i] is bitwise first_hit(tree, rays[i]).
/// @throws InputError that names the first ray that is none
[[nodiscard]] std::vector<std::optional<RayHit>> first_hits(const SurfaceTree& tree,
                                                            std::span<const Ray> rays);

}  // namespace limes
