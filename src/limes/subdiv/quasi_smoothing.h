#pragma once

#include <span>

#include "limes/core/types.h"
#include "limes/subdiv/bisect.h"

namespace limes {

/// How a quasi 4-8 surface ends at its boundary.
enum class QuasiBoundary {
  curve_normal,  ///< moves like `curve`, but along the surface normal only: a flat surface stays as wide
  curve,         ///< cubic B-spline of the boundary vertices
  fixed          ///< stays; new vertices in the middle of their edges
};

/// What tagged edges and vertices do.
enum class QuasiTags {
  held,  ///< they are not smoothed: edges stay straight, [velho_quasi48] section 4.3
  curves  ///< tagged edges are creases, cubic B-splines: a vertex with one is smooth (dart), with two
          ///< moves along them, with more, or tagged itself, stays
};

struct QuasiSmoothingRules {
  QuasiBoundary boundary = QuasiBoundary::curve_normal;
  QuasiTags tags = QuasiTags::held;
};

/// The tags of a mesh, dense: empty, or one entry per edge and vertex.
struct QuasiMarks {
  IdArray<EdgeId, char> edges;
  IdArray<VertexId, char> vertices;

  [[nodiscard]] bool edge(EdgeId e) const { return !edges.empty() && edges[e]; }
  [[nodiscard]] bool vertex(VertexId v) const { return !vertices.empty() && vertices[v]; }
};

/// Algorithm 2 of [velho_quasi48]: a new vertex is the mean of its four neighbours, an old one moves half
/// way to the mean of the new ones around it. Both are written from the positions before the step:
/// the order does not matter.
/// @param coarse  one per vertex of the parent
/// @param fine    one per vertex of step.child, written; the same bits for any number of threads
void quasi_smoothing(const Adjacency& parent, const Bisection& step, const QuasiMarks& marks,
                     const QuasiSmoothingRules& rules, std::span<const Vec3> coarse,
                     std::span<Vec3> fine);

}  // namespace limes
