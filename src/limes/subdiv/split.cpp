#include "limes/subdiv/split.h"

#include <algorithm>
#include <limits>

#include "limes/core/error.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/neighbourhood.h"

namespace limes {

Topology quadrisect(const Adjacency& parent) {
  const Topology& topology = parent.topology();
  const QuadrisectionIds ids = quadrisection_ids(parent);
  const std::int64_t num_vertices =
      std::int64_t{ids.num_vertices} + ids.num_edges + topology.num_faces();
  const std::int64_t num_corners = std::int64_t{4} * topology.num_corners();
  if (std::max(num_vertices, num_corners) > std::numeric_limits<std::int32_t>::max())
    throw InputError("refinement would have {} faces; at most {} can be numbered",
                     topology.num_corners(), std::numeric_limits<std::int32_t>::max() / 4);

  std::vector<VertexId> corners(static_cast<std::size_t>(num_corners));
  for_each_index(topology.num_faces(), [&](std::int64_t i) {
    const FaceId f(i);
    const int n = topology.face_size(f);
    const int first = topology.halfedge(f, 0).value;
    VertexId* out = corners.data() + std::size_t{4} * static_cast<std::size_t>(first);
    VertexId previous = ids.of_edge(parent.edge(HalfedgeId(first + n - 1)));
    for (int k = 0; k < n; ++k, out += 4) {
      const HalfedgeId h(first + k);
      const VertexId edge = ids.of_edge(parent.edge(h));
      out[0] = ids.of_vertex(topology.corner(h));
      out[1] = edge;
      out[2] = ids.of_face(f);
      out[3] = previous;
      previous = edge;
    }
  });
  return {static_cast<int>(num_vertices), 4, std::move(corners)};
}

namespace {

/// The child halfedges that run along the half of h at its start, and at its end.
HalfedgeId half_at_start(HalfedgeId h) {
  return HalfedgeId(4 * std::int64_t{h.value});
}
HalfedgeId half_at_end(const Adjacency& parent, HalfedgeId h) {
  return HalfedgeId(4 * std::int64_t{parent.next(h).value} + 3);
}

/// The lower of a child halfedge and its twin; the twin runs along the same half of the parent's
/// twin.
HalfedgeId first_of_edge(HalfedgeId a, HalfedgeId b) {
  return std::min(a, b);
}

}  // namespace

Features quadrisect_features(const Adjacency& parent, const Features& features) {
  Features child;
  child.crease_method = features.crease_method;
  child.smooth_triangles = features.smooth_triangles;
  for (const SharpVertex& v : features.vertices)
    if (is_sharp(decayed(v.sharpness))) child.vertices.push_back({v.vertex, decayed(v.sharpness)});
  if (features.edges.empty()) return child;

  const Sharpness sharpness(parent, features);
  NeighbourhoodWalk walk(parent, features, sharpness);
  for (const SharpEdge& e : features.edges) {
    const HalfedgeId h = e.halfedge;
    const HalfedgeId twin = parent.twin(h);
    if (!twin.valid()) continue;
    const float at_start = walk.child_sharpness_at_start(h);
    const float at_end = walk.child_sharpness_at_start(twin);
    if (is_sharp(at_start))
      child.edges.push_back({first_of_edge(half_at_start(h), half_at_end(parent, twin)), at_start});
    if (is_sharp(at_end))
      child.edges.push_back({first_of_edge(half_at_end(parent, h), half_at_start(twin)), at_end});
  }
  std::sort(child.edges.begin(), child.edges.end(),
            [](const SharpEdge& x, const SharpEdge& y) { return x.halfedge < y.halfedge; });
  return child;
}

}  // namespace limes
