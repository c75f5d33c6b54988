#pragma once

#include <array>

#include "limes/limit/surface_ray.h"

namespace limes {

/// The first hit found so far, in coordinates (a, b, t) in which the ray is a = b = 0.
class FirstSoFar {
 public:
  /// @param t_min, t_max  range of interest  @param tolerance  length, as near as counts as on it
  FirstSoFar(double t_min, double t_max, double tolerance)
      : t_min_(t_min), t_(t_max), tolerance_(tolerance) {}

  [[nodiscard]] double tolerance() const { return tolerance_; }
  /// The range in which a hit would matter.
  [[nodiscard]] double smallest() const { return t_min_ - tolerance_; }
  [[nodiscard]] double largest() const { return t_ + tolerance_; }
  [[nodiscard]] bool found() const { return place_.face.valid(); }

  /// Whether points of a square of which none has a smaller t than `t` do not matter.
  [[nodiscard]] bool excludes(double t, const SquarePlace& place) const {
    return t > largest() || (found() && t >= t_ && !goes_before(place));
  }
  void offer(double t, const SquarePlace& place, const Vec2& uv, const Vec3& x, RayHit::Side side);

  [[nodiscard]] double t() const { return t_; }
  [[nodiscard]] const SquarePlace& place() const { return place_; }
  [[nodiscard]] const Vec2& uv() const { return uv_; }
  [[nodiscard]] const Vec3& x() const { return x_; }  ///< (a, b, t) of the surface's point
  [[nodiscard]] RayHit::Side side() const { return side_; }

 private:
  [[nodiscard]] bool goes_before(const SquarePlace& place) const {
    return place.face < place_.face || (place.face == place_.face && place.corner < place_.corner);
  }

  double t_min_, t_, tolerance_;
  SquarePlace place_;
  Vec2 uv_ = Vec2::Zero();
  Vec3 x_ = Vec3::Zero();
  RayHit::Side side_ = RayHit::Side::edge_on;
};

/// Whether the ray misses a box in (a, b, t), or can meet it only where it does not matter.
[[nodiscard]] bool misses(const Bounds& box, const SquarePlace& place, const FirstSoFar& first);

/// Searches a patch for the first hit.
/// @param patch  its coefficients in (a, b, t)
void search_patch(const BezierPatch& patch, const SquarePlace& place, FirstSoFar& first);

}  // namespace limes
