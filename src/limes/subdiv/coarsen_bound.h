#pragma once

#include <span>

#include "limes/core/types.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/quadrisection_labels.h"

namespace limes {

/// How far at least some vertex of a refined mesh must move before a step of Catmull-Clark can have
/// made it, and the face point that tells.
struct ResidualBound {
  double distance = 0;
  VertexId worst = {};
};

/// Compares face points with the means of old corners from the closed form of docs/theory/coarsen.md,
/// where all corners are smooth and of valence n != 3. If every vertex is at most r away from a
/// refined mesh, an old vertex from there is wrong by at most r (n + 5) / |n - 3|; so the residual of
/// solve_positions() is never smaller than this bound. Linear time.
[[nodiscard]] ResidualBound residual_bound(const Adjacency& fine, const Unsplit& coarse,
                                           const Adjacency& adjacency, const Features& features,
                                           std::span<const Vec3> fine_points);

}  // namespace limes
