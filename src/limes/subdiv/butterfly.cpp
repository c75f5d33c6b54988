#include <cmath>
#include <numbers>

#include "limes/subdiv/schemes.h"

namespace limes {

// The modified butterfly scheme [zorin_schroeder_sweldens_1996]: interpolatory, on triangles.

namespace {

/// Adds scale times the rule of an edge at an interior vertex of valence other than 6, section 3.
void add_extraordinary(const Spokes& ring, double scale, Stencil& out) {
  const int size = ring.size();
  const double n = static_cast<double>(size);
  const auto weight = [&](int j) {
    if (size == 3) return j == 0 ? 5.0 / 12.0 : -1.0 / 12.0;
    if (size == 4) return j == 0 ? 3.0 / 8.0 : (j == 2 ? -1.0 / 8.0 : 0.0);
    const double angle = 2.0 * std::numbers::pi * j / n;
    return (0.25 + std::cos(angle) + 0.5 * std::cos(2.0 * angle)) / n;
  };
  out.add(scale * 0.75, ring.centre);
  for (int j = 0; j < size; ++j)
    out.add(scale * weight(j), ring.end(j));
}

/// Adds a wing of the eight-point rule: the far corner of the face beyond side (ring.centre, third),
/// where `third` is the edge's neighbour in direction `turn` (+-1); beyond the boundary the point
/// that completes the parallelogram.
void add_wing(const Spokes& ring, VertexId other, int turn, double weight, Stencil& out) {
  const int third = ring.first + turn;
  const int wing = ring.first + 2 * turn;
  const bool missing = ring.boundary && (wing < 0 || wing >= ring.size());
  if (!missing) return out.add(weight, ring.end(2 * turn));
  const std::array<VertexId, 2> sum{ring.centre, ring.ends[static_cast<std::size_t>(third)]};
  out.add(weight, sum);
  out.add(-weight, other);
}

void add_regular(const EdgeNeighbourhood& edge, Stencil& out) {
  constexpr double wing = -1.0 / 16.0;
  out.add(0.5, edge.ends);
  out.add(0.125, edge.opposite);
  for (std::size_t i = 0; i < 2; ++i)
    for (const int turn : {1, -1})
      add_wing(edge.rings[i], edge.ends[1 - i], turn, wing, out);
}

/// The four-point rule along the boundary.
void add_boundary(const EdgeNeighbourhood& edge, Stencil& out) {
  const std::array<VertexId, 2> beyond{edge.rings[0].ends.back(), edge.rings[1].ends.front()};
  out.add(9.0 / 16.0, edge.ends);
  out.add(-1.0 / 16.0, beyond);
}

bool is_extraordinary(const Spokes& ring) {
  return !ring.boundary && ring.size() != 6;
}

}  // namespace

void butterfly_edge(const EdgeNeighbourhood& edge, const RuleOptions&, Stencil& out) {
  if (edge.num_faces == 1) return add_boundary(edge, out);
  const int extraordinary =
      int{is_extraordinary(edge.rings[0])} + int{is_extraordinary(edge.rings[1])};
  if (extraordinary == 0) return add_regular(edge, out);
  for (const Spokes& ring : edge.rings)
    if (is_extraordinary(ring)) add_extraordinary(ring, 1.0 / extraordinary, out);
}

}  // namespace limes
