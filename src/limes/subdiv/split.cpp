#include "limes/subdiv/split.h"

#include <algorithm>
#include <array>

#include "limes/core/error.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/neighbourhood.h"
#include "limes/subdiv/splits.h"

namespace limes {

namespace {

Topology split_triangles(const Adjacency& parent) {
  const Topology& topology = parent.topology();
  const std::int64_t num_vertices = num_split_vertices(parent, Split::triangles);
  require_numbers(num_vertices, num_split_faces(topology, Split::triangles), 3);
  std::vector<VertexId> corners(std::size_t{4} * static_cast<std::size_t>(topology.num_corners()));
  const QuadrisectionIds ids = quadrisection_ids(parent);
  for_each_index(topology.num_faces(), [&](std::int64_t f) {
    const auto v = topology.face(FaceId(f));
    std::array<VertexId, 3> e;
    for (int i = 0; i < 3; ++i)
      e[static_cast<std::size_t>(i)] = ids.of_edge(parent.edge(topology.halfedge(FaceId(f), i)));
    const std::array<VertexId, 12> children{v[0], e[0], e[2], v[1], e[1], e[0],
                                            v[2], e[2], e[1], e[0], e[1], e[2]};
    std::copy(children.begin(), children.end(), corners.begin() + 12 * f);
  });
  return {static_cast<int>(num_vertices), 3, std::move(corners)};
}

}  // namespace

Topology quadrisect(const Adjacency& parent) {
  const Topology& topology = parent.topology();
  const QuadrisectionIds ids = quadrisection_ids(parent);
  const std::int64_t num_vertices = num_split_vertices(parent, Split::quads);
  require_numbers(num_vertices, topology.num_corners(), 4);
  const std::int64_t num_corners = std::int64_t{4} * topology.num_corners();

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

Topology split_topology(const Adjacency& parent, Split split) {
  return split == Split::quads ? quadrisect(parent) : split_triangles(parent);
}

std::int64_t num_split_vertices(const Adjacency& parent, Split split) {
  const std::int64_t old_and_edges =
      std::int64_t{parent.topology().num_vertices()} + parent.num_edges();
  return split == Split::quads ? old_and_edges + parent.topology().num_faces() : old_and_edges;
}

std::int64_t num_split_faces(const Topology& parent, Split split) {
  return split == Split::quads ? parent.num_corners() : std::int64_t{4} * parent.num_faces();
}

FaceRange descendants(const Topology& control, FaceId f, Split split, int levels) {
  if (levels == 0) return {f.value, std::int64_t{f.value} + 1};
  if (split == Split::triangles) {
    const int shift = 2 * levels;
    return {std::int64_t{f.value} << shift, (std::int64_t{f.value} + 1) << shift};
  }
  const std::int64_t first = control.halfedge(f, 0).value;
  const int shift = 2 * (levels - 1);
  return {first << shift, (first + control.face_size(f)) << shift};
}

std::vector<bool> descendants(const Topology& control, const std::vector<bool>& marked, Split split,
                              int levels) {
  std::vector<bool> all;
  for (int f = 0; f < control.num_faces(); ++f) {
    const FaceRange d = descendants(control, FaceId(f), split, levels);
    all.insert(all.end(), static_cast<std::size_t>(d.end - d.begin),
               marked[static_cast<std::size_t>(f)]);
  }
  return all;
}

namespace {

/// The child halfedges that run along the half of h at its start, and at its end.
HalfedgeId half_at_start(const Adjacency& parent, HalfedgeId h, Split split) {
  if (split == Split::quads) return HalfedgeId(4 * std::int64_t{h.value});
  return HalfedgeId(12 * std::int64_t{parent.face(h).value} + 3 * parent.corner_index(h));
}
HalfedgeId half_at_end(const Adjacency& parent, HalfedgeId h, Split split) {
  const HalfedgeId next = parent.next(h);
  if (split == Split::quads) return HalfedgeId(4 * std::int64_t{next.value} + 3);
  return HalfedgeId(12 * std::int64_t{parent.face(h).value} + 3 * parent.corner_index(next) + 2);
}

/// The lower of a child halfedge and its twin; the twin runs along the same half of the parent's
/// twin.
HalfedgeId first_of_edge(HalfedgeId a, HalfedgeId b) {
  return std::min(a, b);
}

}  // namespace

Vec2 in_ancestor(Vec2 uv, std::int64_t path, int levels) {
  for (int level = 0; level < levels; ++level, path >>= 2) {
    Vec2 from_middle = uv / 2 - Vec2(0.5, 0.5);  // of the parent; child i turns by i right angles
    for (std::int64_t i = 0; i < (path & 3); ++i)
      from_middle = Vec2(-from_middle.y(), from_middle.x());
    uv = Vec2(0.5, 0.5) + from_middle;
  }
  return uv;
}

Features split_features(const Adjacency& parent, const Features& features, Split split) {
  Features child = features.without_tags(1);
  for (const SharpVertex& v : features.vertices)
    if (is_sharp(decayed(v.sharpness)))
      child.vertices.push_back({v.vertex, decayed(v.sharpness), v.angle});
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
      child.edges.push_back(
          {first_of_edge(half_at_start(parent, h, split), half_at_end(parent, twin, split)),
           at_start});
    if (is_sharp(at_end))
      child.edges.push_back(
          {first_of_edge(half_at_end(parent, h, split), half_at_start(parent, twin, split)),
           at_end});
  }
  std::sort(child.edges.begin(), child.edges.end(),
            [](const SharpEdge& x, const SharpEdge& y) { return x.halfedge < y.halfedge; });
  return child;
}

}  // namespace limes
