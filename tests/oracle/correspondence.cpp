#include "oracle/correspondence.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace limes::oracle {
namespace {

using Edge = std::pair<int, int>;

Edge edge_of(int a, int b) {
  return std::minmax(a, b);
}

/// Number of every edge by first appearance in (face, corner) order.
std::map<Edge, int> numbered_edges(const Topology& topology) {
  std::map<Edge, int> edges;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.emplace(edge_of(face[i].value, face[(i + 1) % face.size()].value),
                    static_cast<int>(edges.size()));
  }
  return edges;
}

}  // namespace

Correspondence identity(const Topology& topology) {
  Correspondence c;
  for (int v = 0; v < topology.num_vertices(); ++v)
    c.vertex.push_back(v);
  for (int f = 0; f < topology.num_faces(); ++f)
    c.face.push_back(f);
  c.turn.assign(c.face.size(), 0);
  return c;
}

Correspondence descend(const Correspondence& parent, const osd::Far::TopologyLevel& their_parent,
                       const osd::Far::TopologyLevel& their_child, const Topology& our_parent,
                       const Topology& our_child, std::string& wrong) {
  const auto complain = [&](const std::string& what) {
    if (wrong.empty()) wrong = what;
  };
  const std::map<Edge, int> edges = numbered_edges(our_parent);
  const int num_edges = static_cast<int>(edges.size());
  const int num_vertices = our_parent.num_vertices();

  Correspondence child;
  child.vertex.assign(static_cast<std::size_t>(their_child.GetNumVertices()), -1);
  child.face.assign(static_cast<std::size_t>(their_child.GetNumFaces()), -1);
  child.turn.assign(child.face.size(), 0);
  if (their_child.GetNumVertices() != our_child.num_vertices())
    complain(
        fmt::format("{} vertices, not {}", our_child.num_vertices(), their_child.GetNumVertices()));
  if (their_child.GetNumFaces() != our_child.num_faces())
    complain(fmt::format("{} faces, not {}", our_child.num_faces(), their_child.GetNumFaces()));
  if (!wrong.empty()) return child;

  const auto ours = [&](int their_vertex) {
    return parent.vertex[static_cast<std::size_t>(their_vertex)];
  };
  for (int v = 0; v < their_parent.GetNumVertices(); ++v)
    child.vertex[static_cast<std::size_t>(their_parent.GetVertexChildVertex(v))] = ours(v);
  for (int e = 0; e < their_parent.GetNumEdges(); ++e) {
    const auto ends = their_parent.GetEdgeVertices(e);
    child.vertex[static_cast<std::size_t>(their_parent.GetEdgeChildVertex(e))] =
        num_vertices + edges.at(edge_of(ours(ends[0]), ours(ends[1])));
  }
  const bool triangles = our_child.uniform_face_size() == 3;
  for (int f = 0; f < their_parent.GetNumFaces() && !triangles; ++f)
    child.vertex[static_cast<std::size_t>(their_parent.GetFaceChildVertex(f))] =
        num_vertices + num_edges + parent.face[static_cast<std::size_t>(f)];

  for (int f = 0; f < their_parent.GetNumFaces(); ++f) {
    const auto at = static_cast<std::size_t>(f);
    const FaceId our_face(parent.face[at]);
    const auto corners = our_parent.face(our_face);
    const int n = static_cast<int>(corners.size());
    const auto corner = [&](int i) { return corners[static_cast<std::size_t>((i + n) % n)].value; };
    const auto edge = [&](int i) {
      return num_vertices + edges.at(edge_of(corner(i), corner(i + 1)));
    };
    const auto their_children = their_parent.GetFaceChildFaces(f);
    for (int i = 0; i < their_children.size(); ++i) {
      const bool middle = i == n;                            // of a triangle
      const int k = middle ? n : (i + parent.turn[at]) % n;  // our corner
      const FaceId our(triangles ? 4 * our_face.value + k
                                 : our_parent.halfedge(our_face, 0).value + k);
      const auto theirs = static_cast<std::size_t>(their_children[i]);
      child.face[theirs] = our.value;
      const std::vector<int> promised =
          middle      ? std::vector<int>{edge(0), edge(1), edge(2)}
          : triangles ? std::vector<int>{corner(k), edge(k), edge(k - 1)}
                      : std::vector<int>{corner(k), edge(k),
                                         num_vertices + num_edges + our_face.value, edge(k - 1)};
      const std::size_t size = promised.size();
      const auto got = our_child.face(our);
      for (std::size_t j = 0; j < size; ++j)
        if (got[j].value != promised[j])
          complain(fmt::format("child face {} has vertex {} at corner {}, not {}", our.value,
                               got[j].value, j, promised[j]));
      // theirs: the same face, perhaps turned
      const auto their_corners = their_child.GetFaceVertices(their_children[i]);
      std::vector<int> mapped;
      for (const int v : their_corners)
        mapped.push_back(child.vertex[static_cast<std::size_t>(v)]);
      const auto first = std::find(promised.begin(), promised.end(), mapped[0]);
      const int turn = static_cast<int>(first - promised.begin());
      child.turn[theirs] = turn;
      for (std::size_t j = 0; j < size; ++j)
        if (mapped[j] != promised[(j + static_cast<std::size_t>(turn)) % size])
          complain(fmt::format("child face {} joins other vertices than OpenSubdiv's {}", our.value,
                               their_children[i]));
    }
  }
  return child;
}

}  // namespace limes::oracle
