#pragma once

#include "limes/limit/distance_objective.h"
#include "limes/limit/surface_squares.h"

namespace limes {

/// The best point found so far in the search for the minimum of an objective over a surface.
///
/// Values count as equal when their distances agree to 1e-15 of the surface's size. Of equal ones a
/// free point, where F is stationary, comes before one that is held by sides of its square: then
/// the true minimum may lie across, too near to be told from the values. After that the lower face
/// comes first, then the lower corner.
class ClosestSoFar {
 public:
  explicit ClosestSoFar(const DistanceObjective& objective)
      : objective_(&objective), tie_(0.01 * objective.tolerance()) {}

  /// Whether nothing in a square can matter if F is at least `lower_bound` there: it is no better
  /// than what is known, to the tolerance, and no equal that comes before it.
  [[nodiscard]] bool excludes(double lower_bound, const SquarePlace& place) const {
    return held_ > 0 || goes_before(place) ? lower_bound > largest_ : lower_bound >= smallest_;
  }
  /// F at a distance that is better by the tolerance.
  [[nodiscard]] double smallest() const { return smallest_; }
  /// The largest F that may still matter.
  [[nodiscard]] double largest() const { return largest_; }

  /// @param y     the point relative to the objective's origin
  /// @param held  how many sides hold it, 0 to 2
  void offer(const Vec3& y, const SquarePlace& place, const Vec2& uv, int held);

  [[nodiscard]] const SquarePlace& place() const { return place_; }
  [[nodiscard]] const Vec2& uv() const { return uv_; }
  [[nodiscard]] const Vec3& y() const { return y_; }
  [[nodiscard]] double value() const { return value_; }

 private:
  [[nodiscard]] bool goes_before(const SquarePlace& place) const {
    return place.face < place_.face || (place.face == place_.face && place.corner < place_.corner);
  }

  const DistanceObjective* objective_;
  double tie_;
  double value_ = std::numeric_limits<double>::infinity();
  double smallest_ = std::numeric_limits<double>::infinity();  // value minus the tolerance
  double better_ = std::numeric_limits<double>::infinity();    // value minus a tie
  double largest_ = std::numeric_limits<double>::infinity();   // value plus a tie
  int held_ = 0;
  SquarePlace place_;
  Vec2 uv_ = Vec2::Zero();
  Vec3 y_ = Vec3::Zero();
};

/// Searches a patch. Afterwards no point of the patch has a distance that is smaller than that of
/// `best` by more than the tolerance (docs/theory/closest-point.md).
/// @param shift  centre of the patch's coefficients relative to the objective's origin
void search_patch(const BezierPatch& patch, const Vec3& shift, const SquarePlace& place,
                  const DistanceObjective& objective, ClosestSoFar& best);

}  // namespace limes
