#include "limes/subdiv/features.h"

#include <algorithm>

#include "limes/core/error.h"

namespace limes {
namespace {

/// Edge between a and b, or an invalid halfedge.
HalfedgeId find_edge(const Adjacency& adjacency, VertexId a, VertexId b) {
  const HalfedgeId start = adjacency.ring_start(a);
  for (HalfedgeId h = start; h.valid();) {
    if (adjacency.to(h) == b) return adjacency.halfedge(adjacency.edge(h));
    const HalfedgeId in = adjacency.prev(h);
    if (adjacency.from(in) == b) return adjacency.halfedge(adjacency.edge(in));
    h = adjacency.ring_next(h);
    if (h == start) break;
  }
  return {};
}

void require_vertex(const Adjacency& adjacency, VertexId v, const char* tag) {
  const int n = adjacency.topology().num_vertices();
  if (v.value < 0 || v.value >= n)
    throw InputError("{} tag: vertex {} does not exist; the mesh has vertices 0 to {}", tag,
                     v.value, n - 1);
}

void sort_and_merge(std::vector<SharpEdge>& edges) {
  std::stable_sort(edges.begin(), edges.end(),
                   [](const SharpEdge& x, const SharpEdge& y) { return x.halfedge < y.halfedge; });
  // A tag given twice: the last one counts, as in OpenSubdiv.
  auto out = edges.begin();
  for (auto it = edges.begin(); it != edges.end(); ++it) {
    if (out != edges.begin() && (out - 1)->halfedge == it->halfedge)
      *(out - 1) = *it;
    else
      *out++ = *it;
  }
  edges.erase(out, edges.end());
}

}  // namespace

Features resolve_tags(const Adjacency& adjacency, const Tags& tags, BoundaryRule boundary) {
  Features features;
  features.crease_method = tags.crease_method;
  features.smooth_triangles = tags.smooth_triangles;

  for (const CreaseTag& tag : tags.creases) {
    require_vertex(adjacency, tag.a, "crease");
    require_vertex(adjacency, tag.b, "crease");
    const HalfedgeId h = find_edge(adjacency, tag.a, tag.b);
    if (!h.valid())
      throw InputError("crease tag: no edge joins vertices {} and {}", tag.a.value, tag.b.value);
    if (tag.sharpness > 0 && adjacency.twin(h).valid())
      features.edges.push_back({h, tag.sharpness});
  }
  sort_and_merge(features.edges);

  std::vector<float> sharpness;
  if (!tags.corners.empty() || boundary == BoundaryRule::edges_and_corners)
    sharpness.assign(static_cast<std::size_t>(adjacency.topology().num_vertices()), 0.0F);
  for (const CornerTag& tag : tags.corners) {
    require_vertex(adjacency, tag.vertex, "corner");
    sharpness[static_cast<std::size_t>(tag.vertex.value)] = std::max(tag.sharpness, 0.0F);
  }
  for (std::size_t i = 0; i < sharpness.size(); ++i) {
    const VertexId v(static_cast<std::int64_t>(i));
    const bool corner = boundary == BoundaryRule::edges_and_corners && adjacency.is_boundary(v) &&
                        adjacency.num_ring_faces(v) == 1;
    const float s = corner ? infinite_sharpness : sharpness[i];
    if (s > 0) features.vertices.push_back({v, s});
  }
  return features;
}

Tags tags_of(const Topology& topology, const Features& features) {
  Tags tags;
  tags.crease_method = features.crease_method;
  tags.smooth_triangles = features.smooth_triangles;
  for (const SharpEdge& e : features.edges)
    tags.creases.push_back(
        {topology.corner(e.halfedge), topology.corner(topology.next(e.halfedge)), e.sharpness});
  for (const SharpVertex& v : features.vertices)
    tags.corners.push_back({v.vertex, v.sharpness});
  return tags;
}

Sharpness::Sharpness(const Adjacency& adjacency, const Features& features)
    : adjacency_(&adjacency) {
  if (!features.edges.empty()) {
    edges_.resize(static_cast<std::size_t>(adjacency.num_edges()), 0.0F);
    for (const SharpEdge& e : features.edges)
      edges_[adjacency.edge(e.halfedge)] = e.sharpness;
  }
  if (!features.vertices.empty()) {
    vertices_.resize(static_cast<std::size_t>(adjacency.topology().num_vertices()), 0.0F);
    for (const SharpVertex& v : features.vertices)
      vertices_[v.vertex] = v.sharpness;
  }
}

}  // namespace limes
