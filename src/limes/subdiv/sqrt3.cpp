#include <cmath>
#include <numbers>

#include "limes/subdiv/schemes.h"

namespace limes {

// Square-root-of-three subdivision [kobbelt_2000]: every triangle gets a vertex in its middle, old
// edges are flipped. At the boundary edges are cut into three, every second step.

void sqrt3_face(const FaceNeighbourhood& face, const RuleOptions&, Stencil& out) {
  out.add(1.0 / 3.0, face.corners);
}

namespace {

/// The neighbours of a boundary vertex along the boundary: before and after in the boundary's own
/// direction, with the surface on its left.
struct BoundaryNeighbours {
  VertexId before, after;
};
BoundaryNeighbours along_boundary(std::span<const VertexId> ring) {
  return {ring.back(), ring.front()};
}

}  // namespace

/// Thirds of a boundary edge, [kobbelt_2000] section 5.
void sqrt3_edge(const EdgeNeighbourhood& edge, const RuleOptions&, Stencil& out) {
  const Spokes& near = edge.rings[static_cast<std::size_t>(edge.part)];
  const BoundaryNeighbours n = along_boundary(near.ends);
  const VertexId across = edge.part == 0 ? n.after : n.before;
  const VertexId beyond = edge.part == 0 ? n.before : n.after;
  out.add(16.0 / 27.0, near.centre);
  out.add(10.0 / 27.0, across);
  out.add(1.0 / 27.0, beyond);
}

/// alpha = (4 - 2 cos(2 pi / n)) / 9, [kobbelt_2000] eq. (3) with the value chosen in section 4.
void sqrt3_vertex(const VertexNeighbourhood& v, const RuleOptions& options, Stencil& out) {
  const std::size_t size = v.neighbours.size();
  if (size > v.faces.size()) {  // on the boundary
    const bool cut = options.level % 2 == 1;
    if (!cut) return out.add(1.0, v.vertex);
    const BoundaryNeighbours n = along_boundary(v.neighbours);
    const std::array<VertexId, 2> pair{n.before, n.after};
    out.add(19.0 / 27.0, v.vertex);
    return out.add(4.0 / 27.0, pair);
  }
  const double n = static_cast<double>(size);
  const double alpha = (4.0 - 2.0 * std::cos(2.0 * std::numbers::pi / n)) / 9.0;
  out.add(1.0 - alpha, v.vertex);
  out.add(alpha / n, v.neighbours);
}

}  // namespace limes
