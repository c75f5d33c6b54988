#include <cmath>
#include <numbers>

#include "limes/subdiv/crease.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/sharp_vertex.h"

namespace limes {

// Loop subdivision of triangles [loop_1987] with Loop's own weights at extraordinary vertices or
// Warren's, and the creases, corners and boundaries of [derose_1998] as OpenSubdiv defines them.

namespace {

/// Weight of each neighbour of a vertex of valence n, [loop_1987] section 3:
/// (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n, which is 1/16 for n = 6.
double neighbour_weight(std::size_t valence) {
  if (valence == 6) return 0.0625;  // without the rounding of the cosine
  const double n = static_cast<double>(valence);
  const double b = 0.375 + 0.25 * std::cos(2.0 * std::numbers::pi / n);
  return (0.625 - b * b) / n;
}

/// The same by [warren_weimer_2001]: no cosine, nearly the same surface.
double neighbour_weight_warren(std::size_t valence) {
  return valence == 3 ? 0.1875 : 0.375 / static_cast<double>(valence);
}

template <double weight(std::size_t)>
void smooth_vertex(const VertexNeighbourhood& v, double scale, Stencil& out) {
  const std::size_t n = v.faces.size();
  const double w = weight(n);
  out.add(scale * (1.0 - static_cast<double>(n) * w), v.vertex);
  out.add(scale * w, v.neighbours);
}

}  // namespace

void loop_edge(const EdgeNeighbourhood& n, const RuleOptions&, Stencil& out) {
  if (is_sharp(n.sharpness) && n.child_sharp) {
    out.add(0.5, n.ends);
    return;
  }
  const double sharp = static_cast<double>(n.sharpness);
  out.add(sharp * 0.5 + (1.0 - sharp) * 0.375, n.ends);
  out.add((1.0 - sharp) * 0.125, n.opposite);
}

void loop_vertex(const VertexNeighbourhood& v, const RuleOptions& options, Stencil& out) {
  const bool warren = options.weights == ExtraordinaryWeights::warren;
  add_vertex_rule(
      v, warren ? smooth_vertex<neighbour_weight_warren> : smooth_vertex<neighbour_weight>, out);
}

}  // namespace limes
