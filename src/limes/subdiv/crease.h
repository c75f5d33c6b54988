#pragma once

#include <array>
#include <span>

#include "limes/mesh/tags.h"

namespace limes {

// Boundary, corner and sharpness rules shared by the schemes: which rule a vertex follows, and how
// sharpness decays from level to level. [derose_1998] with OpenSubdiv's conventions (a semi-sharp
// rule blends with the next level's over the last level, vertex sharpness is independent of edges).

/// Which rule a vertex follows, from the sharp edges that meet there.
enum class VertexRule {
  smooth,  ///< no sharp edge
  dart,    ///< one: moves like a smooth vertex
  crease,  ///< two: moves with the crease curve
  corner   ///< more, or a sharp vertex: stays
};

[[nodiscard]] inline bool is_sharp(float sharpness) {
  return sharpness > 0.0F;
}
[[nodiscard]] inline bool is_infinite(float sharpness) {
  return sharpness >= infinite_sharpness;
}

[[nodiscard]] VertexRule vertex_rule(float vertex_sharpness, std::span<const float> edge_sharpness);

/// Sharpness on the next level of a vertex, or of an edge with the uniform method.
[[nodiscard]] float decayed(float sharpness);

/// Sharpness of the half of an edge that touches a vertex, on the next level.
/// @param edge  position of the edge in edge_sharpness, the edges around that vertex
[[nodiscard]] float decayed_at_vertex(CreaseMethod method, std::size_t edge,
                                      std::span<const float> edge_sharpness);

/// Weight of this level's rule in the last step before it becomes the next level's rule, in [0, 1]:
/// the mean of the sharpnesses that vanish in this step.
[[nodiscard]] float transition_weight(float vertex_sharpness, float child_vertex_sharpness,
                                      std::span<const float> edge_sharpness,
                                      std::span<const float> child_edge_sharpness);

/// Positions of the first and the last sharp edge in ring order.
/// Precondition: at least one is sharp.
[[nodiscard]] std::array<std::size_t, 2> crease_ends(std::span<const float> edge_sharpness);

}  // namespace limes
