#pragma once

#include <functional>
#include <span>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"

namespace limes {

/// The matrix of a linear map of vertex values that is known by its action only. Many impulses are sent at
/// once, far enough apart that every result shows which of them it is from.
/// @param distance  edges between two vertices that one result may depend on, at most
/// @param act       (one value per vertex of the mesh) -> num_results values; components do not mix
[[nodiscard]] SparseMatrix matrix_of_action(
    const Adjacency& mesh, int distance, int num_results,
    const std::function<void(std::span<const Vec3>, std::span<Vec3>)>& act);

}  // namespace limes
