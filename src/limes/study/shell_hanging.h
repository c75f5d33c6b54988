#pragma once

#include <vector>

#include "limes/space/constraints.h"
#include "limes/study/shell_model.h"

namespace limes {

/// The unknowns of hanging nodes as combinations of those of the ends of their sides (fem/hanging.h): the others
/// keep theirs, u = H u', and u' counts for nothing at hanging nodes. Ends do not hang themselves: leaves around
/// a vertex differ by at most one level. H^T carries forces at hanging nodes to the ends of their sides, with
/// the same resultant.
/// @return  (num_unknowns, num_unknowns)
[[nodiscard]] SparseMatrix hanging_transfer(const ShellModel& model);

/// Conditions on u as such on u'.
[[nodiscard]] std::vector<ConstraintRow> carried(const std::vector<ConstraintRow>& rows,
                                                 const SparseMatrix& H);

}  // namespace limes
