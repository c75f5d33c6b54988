#pragma once

#include <string>

#include "limes/problem/selection.h"
#include "limes/space/constraints.h"
#include "limes/study/plane_model.h"

namespace limes {

/// Constraints on the unknowns 2 a + i, and where they come from.
struct Constraints {
  std::vector<ConstraintRow> rows;
  /// Rows [first, last) of a support.
  struct Source {
    std::string where;
    int first, last;
  };
  std::vector<Source> sources;
};

/// Sides of the domain that a selection means: those of Selection::boundary_edges(), and along holes
/// those whose ends are both selected.
[[nodiscard]] std::vector<HalfedgeId> selected_sides(const PlaneModel& model,
                                                     const Selection& chosen);

/// The same condition on both components of a vector field.
[[nodiscard]] std::vector<ConstraintRow> on_both_components(
    const std::vector<ConstraintRow>& scalar);

/// Supports of a problem: boundary sides both of whose ends are selected are held along their whole
/// length, other selected vertices at their limit points.
/// @throws InputError for an empty selection or a component that plane models do not have
[[nodiscard]] Constraints support_constraints(const PlaneModel& model);

/// Finds the rigid motions that the constraints leave free, part by part (parts are pieces that no
/// element or constraint joins).
/// @throws InputError that names the motion and the place
void require_no_rigid_motion(const PlaneModel& model, const std::vector<ConstraintRow>& rows);

}  // namespace limes
