#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/id_array.h"
#include "limes/subdiv/splits.h"

namespace limes {
namespace {

using Kind = ChildVertex::Kind;

/// Faces of different sizes, one after the other.
class FaceList {
 public:
  void add(VertexId v) { corners_.push_back(v); }
  void end_face(FaceId parent) {
    require_numbers(std::int64_t(corners_.size()), std::int64_t(parents_.size()), 1);
    offsets_.push_back(static_cast<int>(corners_.size()));
    parents_.push_back(parent);
  }
  [[nodiscard]] ExplicitSplit take(std::vector<ChildVertex> vertices) {
    const int n = static_cast<int>(vertices.size());
    return {Topology(n, std::move(offsets_), std::move(corners_)), std::move(vertices),
            std::move(parents_)};
  }

 private:
  std::vector<int> offsets_{0};
  std::vector<VertexId> corners_;
  std::vector<FaceId> parents_;
};

/// One face around every interior vertex; of_spoke is the new vertex on an outgoing halfedge.
template <class OfSpoke>
void add_vertex_faces(const Adjacency& parent, const OfSpoke& of_spoke, FaceList& faces) {
  for (int i = 0; i < parent.topology().num_vertices(); ++i) {
    const VertexId v(i);
    const HalfedgeId start = parent.ring_start(v);
    if (!start.valid() || parent.is_boundary(v)) continue;
    if (parent.num_ring_faces(v) < 3)
      throw InputError(
          "vertex {} has two faces; dual schemes make a face around it, which "
          "needs three",
          i);
    HalfedgeId h = start;
    do {
      faces.add(of_spoke(h));
      h = parent.ring_next(h);
    } while (h != start);
    faces.end_face(parent.face(start));
  }
}

}  // namespace

ExplicitSplit dual_split(const Adjacency& parent) {
  const Topology& topology = parent.topology();
  std::vector<ChildVertex> vertices;
  for (int h = 0; h < topology.num_corners(); ++h)
    vertices.push_back({Kind::corner, 0, h});

  const auto at = [](HalfedgeId h) { return VertexId(h.value); };
  FaceList faces;
  for (int f = 0; f < topology.num_faces(); ++f) {
    for (int i = 0; i < topology.face_size(FaceId(f)); ++i)
      faces.add(at(topology.halfedge(FaceId(f), i)));
    faces.end_face(FaceId(f));
  }
  for (int e = 0; e < parent.num_edges(); ++e) {
    const HalfedgeId h = parent.halfedge(EdgeId(e));
    const HalfedgeId twin = parent.twin(h);
    if (!twin.valid()) continue;
    for (const HalfedgeId corner : {parent.next(twin), twin, parent.next(h), h})
      faces.add(at(corner));
    faces.end_face(parent.face(h));
  }
  add_vertex_faces(parent, at, faces);
  return faces.take(std::move(vertices));
}

namespace {

/// The faces with a corner inside the surface: those that keep a face in the middle. The others would
/// hang on to the surface by single vertices.
std::vector<bool> faces_that_stay(const Adjacency& parent) {
  const Topology& topology = parent.topology();
  std::vector<bool> stays(static_cast<std::size_t>(topology.num_faces()));
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto corners = topology.face(FaceId(f));
    stays[static_cast<std::size_t>(f)] = std::any_of(
        corners.begin(), corners.end(), [&](VertexId v) { return !parent.is_boundary(v); });
  }
  return stays;
}

/// Two faces that stay but whose common edge has both ends on the boundary would have nothing but its
/// midpoint in common.
void require_no_bridge(const Adjacency& parent, const std::vector<bool>& stays) {
  const auto face_stays = [&](HalfedgeId h) {
    return stays[static_cast<std::size_t>(parent.face(h).value)];
  };
  for (int e = 0; e < parent.num_edges(); ++e) {
    const HalfedgeId h = parent.halfedge(EdgeId(e));
    const VertexId a = parent.from(h);
    const VertexId b = parent.to(h);
    if (parent.is_boundary(EdgeId(e)) || !parent.is_boundary(a) || !parent.is_boundary(b)) continue;
    if (face_stays(h) && face_stays(parent.twin(h)))
      throw InputError(
          "midpoints of edges tear the surface between vertices {} and {}, both on the boundary; "
          "doo-sabin does not",
          a.value, b.value);
  }
}

/// The edges with a face that stays; a vertex face has no others, for the faces around an interior
/// vertex stay.
std::vector<ChildVertex> midpoints(const Adjacency& parent, const std::vector<bool>& stays,
                                   IdArray<EdgeId, VertexId>& vertex_of) {
  std::vector<ChildVertex> vertices;
  vertex_of.resize(static_cast<std::size_t>(parent.num_edges()));
  for (int e = 0; e < parent.num_edges(); ++e) {
    const HalfedgeId h = parent.halfedge(EdgeId(e));
    const HalfedgeId twin = parent.twin(h);
    if (!stays[static_cast<std::size_t>(parent.face(h).value)] &&
        !(twin.valid() && stays[static_cast<std::size_t>(parent.face(twin).value)]))
      continue;
    vertex_of[EdgeId(e)] = VertexId(static_cast<std::int64_t>(vertices.size()));
    vertices.push_back({Kind::edge, 0, e});
  }
  return vertices;
}

}  // namespace

ExplicitSplit mid_edge_split(const Adjacency& parent) {
  const std::vector<bool> stays = faces_that_stay(parent);
  require_no_bridge(parent, stays);
  IdArray<EdgeId, VertexId> vertex_of;
  std::vector<ChildVertex> vertices = midpoints(parent, stays, vertex_of);

  const Topology& topology = parent.topology();
  const auto on = [&](HalfedgeId h) { return vertex_of[parent.edge(h)]; };
  FaceList faces;
  for (int f = 0; f < topology.num_faces(); ++f) {
    if (!stays[static_cast<std::size_t>(f)]) continue;
    for (int i = 0; i < topology.face_size(FaceId(f)); ++i)
      faces.add(on(topology.halfedge(FaceId(f), i)));
    faces.end_face(FaceId(f));
  }
  add_vertex_faces(parent, on, faces);
  return faces.take(std::move(vertices));
}

}  // namespace limes
