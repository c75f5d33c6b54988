#pragma once

#include <vector>

#include "limes/study/shell_solution.h"

namespace limes {

/// Squared error of every face in the energy norm by the estimator that [adapt] names: residual_estimate(),
/// or the resultants of the elements are compared with recovered ones [zienkiewicz_1992],
///
///     integral of |N* - N|^2 + 12/t^2 |M* - M|^2 over E t, and of |Q* - Q|^2 over k G t,
///
/// where |.|^2 is (1 + nu) A : A - nu (tr A)^2, for shear Q . Q. Recovery fits resultants at the centres of
/// the elements around a node, turned into the plane normal to its director by the shortest turn
/// (recovery.h); it crosses no kink, no seam and no border between materials.
[[nodiscard]] std::vector<double> estimate_error(const ShellModel& model,
                                                 const ShellSolution& solution);

}  // namespace limes
