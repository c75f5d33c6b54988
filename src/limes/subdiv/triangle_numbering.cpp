#include "limes/subdiv/triangle_numbering.h"

#include "limes/core/error.h"
#include "limes/subdiv/split.h"
#include "limes/subdiv/triangle_grid.h"
#include "limes/subdiv/triangle_sides.h"

namespace limes {
namespace {

using EdgeNode = TriangleNumbering::EdgeNode;

EdgeNode edge_node(GridPoint from, GridPoint to, HalfedgeId h, int side, int edge_length) {
  const int i = (from.i + to.i) / 2;
  const int j = (from.j + to.j) / 2;
  EdgeNode e{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j), -1, 0,
             static_cast<std::uint16_t>(h.value)};
  const auto on_side = [&](int s, int along) {
    e.side = static_cast<std::int8_t>(s);
    e.step = static_cast<std::uint8_t>(along / edge_length);
  };
  if (from.j == 0 && to.j == 0) on_side(0, i);
  if (from.i + from.j == side && to.i + to.j == side) on_side(1, j);
  if (from.i == 0 && to.i == 0) on_side(2, side - j);
  return e;
}

/// Axis of the ring's first edge by vertex: that of the first face at the vertex.
std::vector<std::uint8_t> ring_axes(const Topology& topology, const std::vector<GridPoint>& nodes,
                                    int edge_length) {
  std::vector<std::uint8_t> axes(TriangleGrid::num_places, 0);
  std::vector<bool> known(nodes.size(), false);
  const auto axis = [&](GridPoint step) {
    for (int k = 0; k < 6; ++k) {
      const GridPoint d = edge_length * triangle_direction(k);
      if (d.i == step.i && d.j == step.j) return k % 3;
    }
    LIMES_ASSERT(!"an edge of the grid");
    return 0;
  };
  for (int h = 0; h < topology.num_corners(); ++h) {
    const auto v = static_cast<std::size_t>(topology.corner(HalfedgeId(h)).value);
    if (known[v]) continue;
    known[v] = true;
    const auto to = static_cast<std::size_t>(topology.corner(topology.next(HalfedgeId(h))).value);
    const int place = TriangleGrid::place(nodes[v].i / edge_length, nodes[v].j / edge_length);
    axes[static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(axis(nodes[to] - nodes[v]));
  }
  return axes;
}

}  // namespace

TriangleNumbering::TriangleNumbering(int depth) : depth_(depth) {
  LIMES_ASSERT(depth >= 1 && depth <= max_depth);
  Topology topology(3, 3, {VertexId(0), VertexId(1), VertexId(2)});
  std::vector<GridPoint> nodes{{0, 0}, {side(), 0}, {0, side()}};  // by vertex
  for (int birth = 1; birth <= depth; ++birth) {
    const int edge_length = side() >> (birth - 1);
    const Adjacency grid(topology, Adjacency::Check::edges);
    const auto node = [&](VertexId v) { return nodes[static_cast<std::size_t>(v.value)]; };
    Step step;
    step.axes = ring_axes(topology, nodes, edge_length);
    for (int e = 0; e < grid.num_edges(); ++e) {
      const HalfedgeId h = grid.halfedge(EdgeId(e));
      step.edges.push_back(edge_node(node(grid.from(h)), node(grid.to(h)), h, side(), edge_length));
    }
    for (int h = 0; h < topology.num_corners(); ++h)
      step.edge_at_corner.push_back(static_cast<std::uint16_t>(grid.edge(HalfedgeId(h)).value));
    for (const EdgeNode& e : step.edges)
      nodes.push_back({e.i, e.j});
    steps_.push_back(std::move(step));
    topology = split_topology(grid, Split::triangles);
  }
}

}  // namespace limes
