#pragma once

#include <array>
#include <span>
#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/topology.h"

namespace limes {

/// A mesh's faces as triangles. `source` says which face a triangle is from.
struct Triangulation {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> source;  ///< ascending
};

/// Which cuts are allowed.
enum class Cuts {
  any,       ///< for drawing
  new_edges  ///< no cut joins vertices that have an edge: a surface stays one
};

/// Cuts corners off, the one with the shortest cut first, where the rest stays simple, so that also
/// hollow faces are covered once; a quad falls along its shorter diagonal. Of cuts as long as each
/// other (1e-9) the one at the lowest vertex is taken. Triangles stay as they are.
/// @throws InputError if a face has no cut that is allowed
[[nodiscard]] Triangulation triangulate(const Topology& topology, std::span<const Vec3> points,
                                        Cuts cuts = Cuts::any);

}  // namespace limes
