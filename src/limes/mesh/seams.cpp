#include "limes/mesh/seams.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "limes/core/error.h"
#include "limes/mesh/pieces.h"

namespace limes {
namespace {

using Edge = std::array<VertexId, 2>;

/// The boundary of a part: its edges in order of the halfedges, and its vertices.
struct Rim {
  std::vector<Edge> edges;
  std::set<VertexId> vertices;

  Rim(const Adjacency& adjacency, const FaceGroup& part) {
    for (const FaceId f : part.faces)
      for (int i = 0; i < adjacency.topology().face_size(f); ++i) {
        const HalfedgeId h = adjacency.topology().halfedge(f, i);
        if (adjacency.twin(h).valid()) continue;
        edges.push_back({adjacency.from(h), adjacency.to(h)});
        vertices.insert(edges.back().begin(), edges.back().end());
      }
  }
};

struct Near {
  VertexId vertex;
  double distance = std::numeric_limits<double>::infinity();
};

Near nearest(const Mesh& mesh, const Rim& rim, const Vec3& x) {
  Near out;
  for (const VertexId v : rim.vertices)
    if (const double d = (mesh.points[v] - x).norm(); d < out.distance) out = {v, d};
  return out;
}

double distance_from_edge(const Mesh& mesh, const Edge& e, const Vec3& x) {
  const Vec3 a = mesh.points[e[0]], d = mesh.points[e[1]] - a;
  const double t = std::clamp((x - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (x - a - t * d).norm();
}

/// Vertices of `from` tied to vertices of `to`. Those that only come close, or lie on an edge of `to`,
/// are errors: the polygons were meant to be one.
std::map<VertexId, VertexId> partners(const Mesh& mesh, const FaceGroup& from_part, const Rim& from,
                                      const FaceGroup& to_part, const Rim& to, double tolerance) {
  constexpr double close = 0.02;  // over the length of the edge
  std::map<VertexId, VertexId> out;
  for (const VertexId v : from.vertices) {
    const Vec3& x = mesh.points[v];
    const Near near = nearest(mesh, to, x);
    if (near.distance <= tolerance) {
      out.emplace(v, near.vertex);
      continue;
    }
    for (const Edge& e : to.edges) {
      const double length = (mesh.points[e[1]] - mesh.points[e[0]]).norm();
      if (distance_from_edge(mesh, e, x) > std::max(tolerance, close * length)) continue;
      throw InputError(
          "part '{}' has the vertex {} on the edge between vertices {} and {} of part '{}', whose "
          "nearest vertex {} is {:.6g} away; vertices on a seam must be in the same places",
          from_part.name, v.value, e[0].value, e[1].value, to_part.name, near.vertex.value,
          near.distance);
    }
  }
  return out;
}

/// Vertex in the middle of the edge between two vertices.
VertexId middle(const Adjacency& coarse, const Edge& e) {
  const HalfedgeId h = find_edge(coarse, e[0], e[1]);
  return VertexId(coarse.topology().num_vertices() + coarse.edge(h).value);
}

}  // namespace

std::vector<TiedEdge> tie_parts(const Mesh& mesh, const Adjacency& adjacency,
                                const FaceGroup& first, const FaceGroup& second, double tolerance) {
  const Rim a(adjacency, first), b(adjacency, second);
  const auto to_b = partners(mesh, first, a, second, b, tolerance);
  (void)partners(mesh, second, b, first, a, tolerance);
  const std::set<Edge> edges_of_b(b.edges.begin(), b.edges.end());
  std::vector<TiedEdge> out;
  for (const Edge& e : a.edges) {
    const auto p = to_b.find(e[0]), q = to_b.find(e[1]);
    if (p == to_b.end() || q == to_b.end()) continue;
    const Edge other{p->second, q->second};
    const bool is_edge = edges_of_b.contains(other) || edges_of_b.contains({other[1], other[0]});
    if (other != e && is_edge) out.push_back({e, other});
  }
  return out;
}

std::vector<std::array<VertexId, 2>> split_edges(const Adjacency& coarse,
                                                 std::span<const std::array<VertexId, 2>> edges) {
  std::vector<Edge> out;
  for (const Edge& e : edges) {
    const VertexId m = middle(coarse, e);
    out.push_back({e[0], m});
    out.push_back({m, e[1]});
  }
  return out;
}

std::vector<TiedEdge> split_edges(const Adjacency& coarse, std::span<const TiedEdge> edges) {
  std::vector<TiedEdge> out;
  for (const TiedEdge& e : edges) {
    const VertexId m = middle(coarse, e.ends), n = middle(coarse, e.tied);
    out.push_back({{e.ends[0], m}, {e.tied[0], n}});
    out.push_back({{m, e.ends[1]}, {n, e.tied[1]}});
  }
  return out;
}

IdArray<VertexId, VertexId> tied_nodes(int num_vertices, std::span<const TiedEdge> edges) {
  DisjointSets sets(num_vertices);
  for (const TiedEdge& e : edges)
    for (std::size_t i = 0; i < 2; ++i)
      sets.join(e.ends[i].value, e.tied[i].value);
  IdArray<VertexId, VertexId> out(static_cast<std::size_t>(num_vertices));
  for (int v = 0; v < num_vertices; ++v)
    out[VertexId(v)] = VertexId(sets.find(v));
  return out;
}

}  // namespace limes
