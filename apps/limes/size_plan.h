#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "limes/mesh/topology.h"
#include "limes/subdiv/scheme.h"

namespace limes::app {

/// Counts of a mesh; 64 bits, because they are asked before the mesh is made.
struct MeshSize {
  std::int64_t vertices, edges, faces, corners;
};
[[nodiscard]] MeshSize size_of(const Topology& topology);
/// After one step of a scheme.
/// @param level  steps made before
[[nodiscard]] MeshSize refined_size(const MeshSize& size, const Scheme& scheme, int level);

/// Why work of this size cannot be done: more things than can be numbered, or more memory than it may
/// use; empty if it can.
/// @param corners,vertices  of all meshes that it holds numbered together
[[nodiscard]] std::string obstacle(std::int64_t corners, std::int64_t vertices, double bytes,
                                   std::int64_t memory_limit);

/// What a refinement does besides the steps themselves.
struct RefinementExtras {
  bool limit_points = false;
  bool vtu = false;         ///< the writer holds all arrays
  int steps_per_level = 1;  ///< of the scheme
};

/// Refuses a refinement before any work is done: more corners than can be numbered, or more memory
/// than there is.
/// @throws InputError saying how large the mesh would be and how many levels are possible
void require_feasible(const Topology& topology, const Scheme& scheme, int levels,
                      const RefinementExtras& extras, std::int64_t memory_limit,
                      std::string_view file);

}  // namespace limes::app
