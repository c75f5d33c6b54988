#pragma once

#include <span>

#include "limes/core/types.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/quadrisection_labels.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Old positions of a coarse mesh from those of its refinement.
struct CoarsePositions {
  std::vector<Vec3> points;  ///< by coarse vertex
  double residual;           ///< largest distance between refined and given vertices
  VertexId worst;            ///< the fine vertex where it is reached
  bool unique;               ///< see has_unique_positions()
};

/// Least squares on S x = y with the operator S of the coarse mesh, by catmull-clark or loop.
/// @param fine_points  y, by fine vertex
[[nodiscard]] CoarsePositions solve_positions(const Adjacency& fine, const Unsplit& coarse,
                                              const Adjacency& adjacency, const Features& features,
                                              const Scheme& scheme,
                                              std::span<const Vec3> fine_points);

/// The same for an interpolatory scheme, whose old vertices stay.
[[nodiscard]] CoarsePositions kept_positions(const Adjacency& fine, const Unsplit& coarse,
                                             const Adjacency& adjacency, const Features& features,
                                             const Scheme& scheme,
                                             std::span<const Vec3> fine_points);

/// Whether the S of catmull-clark has full column rank, for a connected mesh. Where S x = 0, the edge rule makes the ends
/// of every edge opposite, x_b = -x_a; then the vertex rule leaves (n - 3)/n x at smooth vertices,
/// x/2 on creases, x at corners. So exactly the meshes without boundary, crease vertices and
/// corners whose vertices all have three edges, and whose edges can be walked in even loops only
/// (cube, hexagonal prism, ...), forget something: the same step, forwards and backwards.
[[nodiscard]] bool has_unique_positions(const Adjacency& adjacency, const Features& features);

}  // namespace limes
