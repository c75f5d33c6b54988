#include "limes/subdiv/quad_numbering.h"

#include "limes/core/error.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

using Node = QuadNumbering::Node;
using EdgeNode = QuadNumbering::EdgeNode;

Node middle(Node a, Node b) {
  return {static_cast<std::uint8_t>((a.i + b.i) / 2), static_cast<std::uint8_t>((a.j + b.j) / 2)};
}

EdgeNode edge_node(Node from, Node to, HalfedgeId h, int side, int edge_length) {
  EdgeNode e{middle(from, to), -1, 0, static_cast<std::uint16_t>(h.value)};
  const auto on_side = [&](int s, int along) {
    e.side = static_cast<std::int8_t>(s);
    e.step = static_cast<std::uint8_t>(along / edge_length);
  };
  if (from.j == 0 && to.j == 0) on_side(0, e.node.i);
  if (from.i == side && to.i == side) on_side(1, e.node.j);
  if (from.j == side && to.j == side) on_side(2, side - e.node.i);
  if (from.i == 0 && to.i == 0) on_side(3, side - e.node.j);
  return e;
}

}  // namespace

QuadNumbering::QuadNumbering(int depth) : depth_(depth) {
  LIMES_ASSERT(depth >= 1 && depth <= max_depth);
  const auto full = static_cast<std::uint8_t>(side());
  Topology topology(4, 4, {VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  std::vector<Node> nodes{{0, 0}, {full, 0}, {full, full}, {0, full}};  // by vertex
  for (int birth = 1; birth <= depth; ++birth) {
    const Adjacency grid(topology, Adjacency::Check::edges);
    const auto node = [&](VertexId v) { return nodes[static_cast<std::size_t>(v.value)]; };
    Step step;
    for (int e = 0; e < grid.num_edges(); ++e) {
      const HalfedgeId h = grid.halfedge(EdgeId(e));
      step.edges.push_back(
          edge_node(node(grid.from(h)), node(grid.to(h)), h, side(), side() >> (birth - 1)));
    }
    for (int h = 0; h < topology.num_corners(); ++h)
      step.edge_at_corner.push_back(static_cast<std::uint16_t>(grid.edge(HalfedgeId(h)).value));
    for (int f = 0; f < topology.num_faces(); ++f) {
      const auto v = topology.face(FaceId(f));
      step.faces.push_back(middle(node(v[0]), node(v[2])));
    }
    for (const EdgeNode& e : step.edges)
      nodes.push_back(e.node);
    nodes.insert(nodes.end(), step.faces.begin(), step.faces.end());
    steps_.push_back(std::move(step));
    topology = quadrisect(grid);
  }
}

}  // namespace limes
