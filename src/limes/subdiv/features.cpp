#include "limes/subdiv/features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limes/core/error.h"
#include "limes/subdiv/crease.h"

namespace limes {
namespace {

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
  if (features.sector_stencils && !features.vertices.empty()) {
    angles_.resize(static_cast<std::size_t>(adjacency.topology().num_vertices()), 0.0);
    for (const SharpVertex& v : features.vertices)
      angles_[v.vertex] = v.angle;
  }
}

double Sharpness::angle(VertexId v) const {
  const bool corner = !angles_.empty() && angles_[v] > 0.0;
  return corner ? angles_[v] : std::numbers::pi;
}

void measure_corners(const Adjacency& adjacency, std::span<const Vec3> points, Features& features) {
  features.sector_stencils = true;
  const auto at = [&](VertexId v) { return points[static_cast<std::size_t>(v.value)]; };
  for (SharpVertex& corner : features.vertices) {
    if (!is_infinite(corner.sharpness) || !adjacency.is_boundary(corner.vertex)) continue;
    corner.angle = 0.0;
    for (HalfedgeId h = adjacency.ring_start(corner.vertex); h.valid();
         h = adjacency.ring_next(h)) {
      const Vec3 a = at(adjacency.to(h)) - at(corner.vertex);
      const Vec3 b = at(adjacency.from(adjacency.prev(h))) - at(corner.vertex);
      corner.angle += std::atan2(a.cross(b).norm(), a.dot(b));
    }
  }
}

}  // namespace limes
