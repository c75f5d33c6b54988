#pragma once

#include "limes/space/constraints.h"
#include "limes/study/plane_model.h"

namespace limes {

/// A rectangular cell whose left and right, bottom and top boundaries match.
struct PeriodicCell {
  double width, height;
  struct Pair {
    HalfedgeId low, high;  ///< sides on the left and right, or on the bottom and top
  };
  std::vector<Pair> pairs;

  [[nodiscard]] double area() const { return width * height; }  ///< holes included
};

/// Finds the sides on the model's bounding box and pairs them.
/// @throws InputError that names the first vertex or side without a partner
[[nodiscard]] PeriodicCell find_periodic_cell(const PlaneModel& model);

/// Constraints that make a field periodic, and two that take out its translation.
[[nodiscard]] std::vector<ConstraintRow> periodic_constraints(const PlaneModel& model,
                                                              const PeriodicCell& cell);

}  // namespace limes
