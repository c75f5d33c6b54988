#include "limes/subdiv/schemes.h"

namespace limes {

// Faces split at midpoints and centroids; nothing moves. Face points are those of Catmull-Clark.

void linear_edge(const EdgeNeighbourhood& n, const RuleOptions&, Stencil& out) {
  out.add(0.5, n.ends);
}

void linear_vertex(const VertexNeighbourhood& n, const RuleOptions&, Stencil& out) {
  out.add(1.0, n.vertex);
}

}  // namespace limes
