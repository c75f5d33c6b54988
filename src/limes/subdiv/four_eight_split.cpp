#include <algorithm>

#include "limes/core/error.h"
#include "limes/subdiv/bisect.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/splits.h"

namespace limes {
namespace {

using Kind = ChildVertex::Kind;

void add_old_vertices(const Topology& parent, ExplicitSplit& split) {
  for (int v = 0; v < parent.num_vertices(); ++v)
    split.vertices.push_back({Kind::vertex, 0, v});
}

/// A vertex in every face, which is the first corner of the triangles to its sides.
ExplicitSplit centre_split(const Adjacency& parent) {
  const Topology& topology = parent.topology();
  const std::int64_t num_vertices = std::int64_t{topology.num_vertices()} + topology.num_faces();
  require_numbers(num_vertices, topology.num_corners(), 3);
  ExplicitSplit split;
  add_old_vertices(topology, split);
  std::vector<VertexId> corners;
  corners.reserve(static_cast<std::size_t>(topology.num_corners()) * 3);
  for (int f = 0; f < topology.num_faces(); ++f) {
    split.vertices.push_back({Kind::face, 0, f});
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      corners.insert(corners.end(), {VertexId(std::int64_t{topology.num_vertices()} + f), face[i],
                                     face[i + 1 == face.size() ? 0 : i + 1]});
      split.parents.emplace_back(f);
    }
  }
  split.topology = Topology(static_cast<int>(num_vertices), 3, std::move(corners));
  return split;
}

/// A vertex in the edge opposite the first corner of every triangle.
ExplicitSplit newest_vertex_split(const Adjacency& parent) {
  const std::vector<EdgeId> edges = newest_vertex_edges(parent);
  Bisection step = bisect(parent, edges, FirstCorner::newest);
  ExplicitSplit split;
  add_old_vertices(parent.topology(), split);
  for (const EdgeId e : edges)
    split.vertices.push_back({Kind::edge, 0, e.value});
  split.topology = std::move(step.child);
  split.parents = std::move(step.parent_face.vector());
  return split;
}

}  // namespace

ExplicitSplit four_eight_split(const Adjacency& parent, int level) {
  return level == 0 ? centre_split(parent) : newest_vertex_split(parent);
}

Features four_eight_features(const Adjacency& parent, const Features& features,
                             const ExplicitSplit& split) {
  const bool decays = four_eight_splits_creases(features.level);
  Features child = features.without_tags(1);
  for (const SharpVertex& v : features.vertices)
    if (const float s = decays ? decayed(v.sharpness) : v.sharpness; is_sharp(s))
      child.vertices.push_back({v.vertex, s});
  if (features.edges.empty()) return child;

  IdArray<EdgeId, VertexId> middle(static_cast<std::size_t>(parent.num_edges()));
  for (std::size_t i = 0; i < split.vertices.size(); ++i)
    if (split.vertices[i].kind == Kind::edge)
      middle[EdgeId(split.vertices[i].from)] = VertexId(static_cast<std::int64_t>(i));
  const Adjacency fine(split.topology, Adjacency::Check::edges);
  const auto add = [&](VertexId a, VertexId b, float sharpness) {
    if (is_sharp(sharpness)) child.edges.push_back({find_edge(fine, a, b), sharpness});
  };
  const Sharpness sharpness(parent, features);
  NeighbourhoodWalk walk(parent, features, sharpness);
  for (const SharpEdge& e : features.edges) {
    const HalfedgeId h = e.halfedge;
    const VertexId a = parent.from(h), b = parent.to(h), between = middle[parent.edge(h)];
    LIMES_ASSERT(between.valid() == decays);
    if (!decays) {
      add(a, b, e.sharpness);
    } else {
      add(a, between, walk.child_sharpness_at_start(h));
      add(between, b, walk.child_sharpness_at_start(parent.twin(h)));
    }
  }
  std::sort(child.edges.begin(), child.edges.end(),
            [](const SharpEdge& x, const SharpEdge& y) { return x.halfedge < y.halfedge; });
  return child;
}

}  // namespace limes
