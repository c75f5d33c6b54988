#include "limes/subdiv/sharp_vertex.h"

#include "limes/subdiv/crease.h"

namespace limes {
namespace {

void crease_vertex(const VertexNeighbourhood& v, std::span<const float> edge_sharpness,
                   double scale, Stencil& out) {
  const auto [first, last] = crease_ends(edge_sharpness);
  const std::array<VertexId, 2> ends = {v.neighbours[first], v.neighbours[last]};
  out.add(scale * 0.75, v.vertex);
  out.add(scale * 0.125, ends);
}

void add_rule(VertexRule rule, const VertexNeighbourhood& v, std::span<const float> edge_sharpness,
              double scale, SmoothVertexRule smooth, Stencil& out) {
  switch (rule) {
    case VertexRule::smooth:
    case VertexRule::dart:
      return smooth(v, scale, out);
    case VertexRule::crease:
      return crease_vertex(v, edge_sharpness, scale, out);
    case VertexRule::corner:
      return out.add(scale, v.vertex);
  }
}

}  // namespace

void add_vertex_rule(const VertexNeighbourhood& v, SmoothVertexRule smooth, Stencil& out) {
  const VertexRule rule = vertex_rule(v.sharpness, v.edge_sharpness);
  if (rule == VertexRule::smooth || rule == VertexRule::dart)
    return add_rule(rule, v, v.edge_sharpness, 1.0, smooth, out);
  const VertexRule child_rule = vertex_rule(v.child_sharpness, v.child_edge_sharpness);
  if (rule == child_rule) return add_rule(rule, v, v.edge_sharpness, 1.0, smooth, out);
  const double weight = static_cast<double>(
      transition_weight(v.sharpness, v.child_sharpness, v.edge_sharpness, v.child_edge_sharpness));
  add_rule(rule, v, v.edge_sharpness, weight, smooth, out);
  add_rule(child_rule, v, v.child_edge_sharpness, 1.0 - weight, smooth, out);
}

}  // namespace limes
