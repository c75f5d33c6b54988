#include <algorithm>

#include "limes/subdiv/crease.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/sharp_vertex.h"
#include "limes/subdiv/splits.h"

namespace limes {

// 4-8 subdivision [velho_zorin_2001]: the first step puts a vertex into every face, each later one into
// the edge opposite the newest vertex of every triangle (four_eight_split). Smooth rules: a new vertex
// is the mean of the corners around it, an old one moves half way to the mean of its neighbours. Edges
// that are split in the step do not count: they are the diagonals of quads. On the regular mesh
// that is the four-directional box spline of class C4; one step has the mask (1 2 1) x (1 2 1) / 8.
//
// Boundaries and creases are cubic B-splines. They are split every second step, beginning with the
// second; in the others their vertices stay, and sharpness does not decay.

void four_eight_face(const FaceNeighbourhood& n, const RuleOptions&, Stencil& out) {
  out.add(1.0 / static_cast<double>(n.corners.size()), n.corners);
}

void four_eight_edge(const EdgeNeighbourhood& n, const RuleOptions&, Stencil& out) {
  if (is_sharp(n.sharpness) && n.child_sharp) return out.add(0.5, n.ends);
  const double sharp = static_cast<double>(n.sharpness);
  out.add(sharp * 0.5 + (1.0 - sharp) * 0.25, n.ends);
  out.add((1.0 - sharp) * 0.25, n.opposite);
}

namespace {

/// A vertex of the last step has only older neighbours: it is numbered after them.
bool is_newest(const VertexNeighbourhood& v) {
  return std::all_of(v.neighbours.begin(), v.neighbours.end(),
                     [&](VertexId n) { return n < v.vertex; });
}

/// The other ends of edges that stay whole, after the first step. All, around a vertex of the last step;
/// else the vertices of the last step, which alternate with the others and have the highest numbers.
std::vector<VertexId> whole_neighbours(const VertexNeighbourhood& v) {
  const auto newest = std::max_element(v.neighbours.begin(), v.neighbours.end());
  const std::size_t stride = is_newest(v) ? 1 : 2;
  std::vector<VertexId> whole;
  for (auto i = static_cast<std::size_t>(newest - v.neighbours.begin()) % stride;
       i < v.neighbours.size(); i += stride)
    whole.push_back(v.neighbours[i]);
  return whole;
}

void pull_half_way(const VertexNeighbourhood& v, std::span<const VertexId> to, double scale,
                   Stencil& out) {
  out.add(scale * 0.5, v.vertex);
  out.add(scale * 0.5 / static_cast<double>(to.size()), to);
}

void first_step_vertex(const VertexNeighbourhood& v, double scale, Stencil& out) {
  pull_half_way(v, v.neighbours, scale, out);
}
void later_vertex(const VertexNeighbourhood& v, double scale, Stencil& out) {
  pull_half_way(v, whole_neighbours(v), scale, out);
}

/// The rule where no sharp edge is split: what is sharp stays, and what is about to be smooth stays as
/// far as it is sharp.
void waiting_vertex(const VertexNeighbourhood& v, SmoothVertexRule smooth, Stencil& out) {
  const auto is_smooth = [](VertexRule rule) {
    return rule == VertexRule::smooth || rule == VertexRule::dart;
  };
  if (is_smooth(vertex_rule(v.sharpness, v.edge_sharpness))) return smooth(v, 1.0, out);
  if (!is_smooth(vertex_rule(v.child_sharpness, v.child_edge_sharpness)))
    return out.add(1.0, v.vertex);
  const double weight = static_cast<double>(
      transition_weight(v.sharpness, v.child_sharpness, v.edge_sharpness, v.child_edge_sharpness));
  out.add(weight, v.vertex);
  smooth(v, 1.0 - weight, out);
}

}  // namespace

void four_eight_vertex(const VertexNeighbourhood& v, const RuleOptions& options, Stencil& out) {
  const SmoothVertexRule smooth = options.level == 0 ? first_step_vertex : later_vertex;
  if (four_eight_splits_creases(options.level))
    add_vertex_rule(v, smooth, out);
  else
    waiting_vertex(v, smooth, out);
}

}  // namespace limes
