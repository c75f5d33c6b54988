#pragma once

#include "limes/subdiv/explicit_split.h"

namespace limes {

// The splits behind explicit_split(), one file each.

[[nodiscard]] ExplicitSplit dual_split(const Adjacency& parent);
[[nodiscard]] ExplicitSplit mid_edge_split(const Adjacency& parent);
/// @param cut_boundary  cut boundary edges into three: every second step
[[nodiscard]] ExplicitSplit sqrt3_split(const Adjacency& parent, bool cut_boundary);

/// @param level  steps made since the control mesh
[[nodiscard]] ExplicitSplit four_eight_split(const Adjacency& parent, int level);
/// Whether this step puts vertices into sharp and boundary edges. The others leave them and their
/// sharpness as they are.
[[nodiscard]] constexpr bool four_eight_splits_creases(int level) {
  return level % 2 == 1;
}
/// Tags after the step.
[[nodiscard]] Features four_eight_features(const Adjacency& parent, const Features& features,
                                           const ExplicitSplit& split);

/// @throws InputError if there are more vertices, or corners of faces with so many each, than ids
void require_numbers(std::int64_t num_vertices, std::int64_t num_faces, int face_size);

}  // namespace limes
