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

EdgeNode edge_node(Node from, Node to, int side, int edge_length) {
  EdgeNode e{middle(from, to), from, to, -1, 0};
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
    std::vector<EdgeNode> edges;
    for (int e = 0; e < grid.num_edges(); ++e) {
      const HalfedgeId h = grid.halfedge(EdgeId(e));
      edges.push_back(
          edge_node(node(grid.from(h)), node(grid.to(h)), side(), side() >> (birth - 1)));
    }
    std::vector<Node> faces;
    for (int f = 0; f < topology.num_faces(); ++f) {
      const auto v = topology.face(FaceId(f));
      faces.push_back(middle(node(v[0]), node(v[2])));
      if (birth < depth) continue;
      Cell cell{{node(v[0]), node(v[1]), node(v[2]), node(v[3])}, {}, faces.back()};
      for (std::size_t k = 0; k < 4; ++k)
        cell.edges[k] = middle(cell.corners[k], cell.corners[(k + 1) % 4]);
      cells_.push_back(cell);
    }
    for (const EdgeNode& e : edges)
      nodes.push_back(e.node);
    nodes.insert(nodes.end(), faces.begin(), faces.end());
    edges_.push_back(std::move(edges));
    faces_.push_back(std::move(faces));
    topology = quadrisect(grid);
  }
}

std::vector<EdgeNode> QuadNumbering::edge_run(int birth, OwnedSides owned) const {
  std::vector<EdgeNode> run;
  for (const EdgeNode& e : edges_[static_cast<std::size_t>(birth - 1)])
    if (e.side < 0 || ((owned >> e.side) & 1U) != 0) run.push_back(e);
  return run;
}

}  // namespace limes
