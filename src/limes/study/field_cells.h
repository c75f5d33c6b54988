#pragma once

#include <functional>

#include "limes/study/plane_solution.h"

namespace limes {

/// States on a grid of (n + 1)^2 points of one tile of one element, u fastest.
struct FieldCell {
  int element;
  ParameterTile tile;
  std::vector<PlaneState> states;
};

/// Hands over every tile of every element, in order.
/// @param n      intervals per direction on each tile
/// @param depth  rings of tiles around extraordinary vertices
void for_each_field_cell(const PlaneModel& model, const PlaneSolution& solution, int n, int depth,
                         const std::function<void(const FieldCell&)>& use);

}  // namespace limes
