#include <array>

#include "limes/core/error.h"
#include "limes/subdiv/splits.h"

namespace limes {
namespace {

using Kind = ChildVertex::Kind;

/// The new vertices of a step and what each old edge finds on its two sides.
struct NewVertices {
  std::vector<ChildVertex> vertices;
  std::vector<std::array<VertexId, 2>> thirds;  // by edge; where the boundary is cut
  std::vector<VertexId> centres;                // by face; invalid where its boundary edge is cut
};

NewVertices number_vertices(const Adjacency& parent, bool cut_boundary) {
  const Topology& topology = parent.topology();
  NewVertices made;
  const auto add = [&](Kind kind, int part, int from) {
    made.vertices.push_back({kind, static_cast<std::int8_t>(part), from});
    return VertexId(std::int64_t(made.vertices.size()) - 1);
  };
  for (int v = 0; v < topology.num_vertices(); ++v)
    add(Kind::vertex, 0, v);
  std::vector<bool> cut(static_cast<std::size_t>(topology.num_faces()), false);
  if (cut_boundary) {
    made.thirds.resize(static_cast<std::size_t>(parent.num_edges()));
    for (int e = 0; e < parent.num_edges(); ++e) {
      if (!parent.is_boundary(EdgeId(e))) continue;
      for (int part = 0; part < 2; ++part)
        made.thirds[static_cast<std::size_t>(e)][static_cast<std::size_t>(part)] =
            add(Kind::edge, part, e);
      cut[static_cast<std::size_t>(parent.face(parent.halfedge(EdgeId(e))).value)] = true;
    }
  }
  made.centres.resize(static_cast<std::size_t>(topology.num_faces()));
  for (int f = 0; f < topology.num_faces(); ++f)
    if (!cut[static_cast<std::size_t>(f)])
      made.centres[static_cast<std::size_t>(f)] = add(Kind::face, 0, f);
  return made;
}

/// The new vertex that a face puts on its side of h: its centre, or the nearer third of its boundary
/// edge.
VertexId apex(const Adjacency& parent, const NewVertices& made, HalfedgeId h) {
  const VertexId centre = made.centres[static_cast<std::size_t>(parent.face(h).value)];
  if (centre.valid()) return centre;
  const HalfedgeId before = parent.prev(h);
  const bool after_boundary = !parent.twin(before).valid();
  const HalfedgeId boundary = after_boundary ? before : parent.next(h);
  const auto& thirds = made.thirds[static_cast<std::size_t>(parent.edge(boundary).value)];
  return thirds[after_boundary ? 1 : 0];
}

}  // namespace

ExplicitSplit sqrt3_split(const Adjacency& parent, bool cut_boundary) {
  const Topology& topology = parent.topology();
  require_numbers(std::int64_t{topology.num_vertices()} + topology.num_faces(),
                  std::int64_t{topology.num_corners()}, 3);
  NewVertices made = number_vertices(parent, cut_boundary);
  std::vector<VertexId> corners;
  std::vector<FaceId> parents;
  for (int i = 0; i < topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    const HalfedgeId twin = parent.twin(h);
    parents.push_back(parent.face(h));
    if (twin.valid()) {
      corners.insert(corners.end(),
                     {parent.from(h), apex(parent, made, twin), apex(parent, made, h)});
    } else if (cut_boundary) {
      const auto& thirds = made.thirds[static_cast<std::size_t>(parent.edge(h).value)];
      corners.insert(corners.end(), {thirds[0], thirds[1], parent.from(parent.prev(h))});
    } else {
      corners.insert(corners.end(), {parent.from(h), parent.to(h), apex(parent, made, h)});
    }
  }
  const int num_vertices = static_cast<int>(made.vertices.size());
  return {Topology(num_vertices, 3, std::move(corners)), std::move(made.vertices),
          std::move(parents)};
}

}  // namespace limes
