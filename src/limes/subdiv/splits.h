#pragma once

#include "limes/subdiv/explicit_split.h"

namespace limes {

// The splits behind explicit_split(), one file each.

[[nodiscard]] ExplicitSplit dual_split(const Adjacency& parent);
[[nodiscard]] ExplicitSplit mid_edge_split(const Adjacency& parent);
/// @param cut_boundary  cut boundary edges into three: every second step
[[nodiscard]] ExplicitSplit sqrt3_split(const Adjacency& parent, bool cut_boundary);

/// @throws InputError if there are more vertices, or corners of faces with so many each, than ids
void require_numbers(std::int64_t num_vertices, std::int64_t num_faces, int face_size);

}  // namespace limes
