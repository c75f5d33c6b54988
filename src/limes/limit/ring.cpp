#include "limes/limit/ring.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace limes {
namespace {

/// Collects faces in walk order, each from a given corner on, and numbers their vertices.
class RingWalk {
 public:
  RingWalk(const Adjacency& adjacency) : adjacency_(adjacency) {}

  /// Adds the face of h, starting at h, unless it is there.
  void add_face(HalfedgeId h) {
    const FaceId f = adjacency_.face(h);
    if (!faces_.insert(f).second) return;
    const int n = adjacency_.topology().face_size(f);
    for (int i = 0; i < n; ++i, h = adjacency_.next(h)) {
      halfedges_.push_back(h);
      corners_.push_back(local_vertex(adjacency_.from(h)));
    }
    offsets_.push_back(static_cast<int>(corners_.size()));
  }

  /// Adds all faces around the start of h: counter-clockwise from h, then clockwise if the
  /// boundary came in between.
  void add_faces_around(HalfedgeId h) {
    HalfedgeId at = h;
    do {
      add_face(at);
      at = adjacency_.ring_next(at);
    } while (at.valid() && at != h);
    if (at == h) return;
    for (HalfedgeId twin = adjacency_.twin(h); twin.valid(); twin = adjacency_.twin(at)) {
      at = adjacency_.next(twin);
      add_face(at);
    }
  }

  [[nodiscard]] int num_faces() const { return static_cast<int>(offsets_.size()) - 1; }
  [[nodiscard]] const std::vector<HalfedgeId>& halfedges() const { return halfedges_; }
  std::vector<VertexId>& vertices() { return vertices_; }
  [[nodiscard]] Topology topology() const {
    return {static_cast<int>(vertices_.size()), offsets_, corners_};
  }

 private:
  VertexId local_vertex(VertexId v) {
    const auto [it, added] = local_.emplace(v, VertexId(static_cast<int>(vertices_.size())));
    if (added) vertices_.push_back(v);
    return it->second;
  }

  const Adjacency& adjacency_;
  std::set<FaceId> faces_;
  std::map<VertexId, VertexId> local_;
  std::vector<int> offsets_{0};
  std::vector<VertexId> corners_;      // local
  std::vector<HalfedgeId> halfedges_;  // of the large mesh, one per corner
  std::vector<VertexId> vertices_;
};

bool has_semi_sharp_edge(const Features& features) {
  return std::any_of(features.edges.begin(), features.edges.end(),
                     [](const SharpEdge& e) { return e.sharpness < infinite_sharpness; });
}

/// Sharpness of the local mesh: edges at the local vertices [0, num_complete), whose faces are all
/// there, and those vertices themselves.
Features local_features(const Adjacency& large, const Sharpness& sharpness, const Ring& ring,
                        const std::vector<HalfedgeId>& halfedges, int num_complete) {
  Features local;
  const Adjacency adjacency(ring.topology, Adjacency::Check::edges);
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    const bool complete = std::min(adjacency.from(h), adjacency.to(h)).value < num_complete;
    if (!complete || adjacency.is_boundary(EdgeId(e))) continue;
    const float s = sharpness.edge(large.edge(halfedges[static_cast<std::size_t>(h.value)]));
    // All infinite sharpnesses are the same kind.
    if (s > 0) local.edges.push_back({h, std::min(s, infinite_sharpness)});
  }
  for (int v = 0; v < num_complete; ++v) {
    const float s = sharpness.vertex(ring.vertices[static_cast<std::size_t>(v)]);
    if (s > 0) local.vertices.push_back({VertexId(v), std::min(s, infinite_sharpness)});
  }
  return local;
}

}  // namespace

Ring gather_ring(const Adjacency& adjacency, const Features& features, const Sharpness& sharpness,
                 const Scheme& scheme, FaceId f) {
  const Topology& topology = adjacency.topology();
  const int n = topology.face_size(f);
  RingWalk walk(adjacency);
  walk.add_face(topology.halfedge(f, 0));
  if (scheme.reach > 0)
    for (int i = 0; i < n; ++i)
      walk.add_faces_around(topology.halfedge(f, i));

  Ring ring;
  ring.num_controls = static_cast<int>(walk.vertices().size());
  int num_complete = scheme.reach > 0 ? n : 0;
  // With Chaikin creases the decay along an edge depends on the edges at its far end.
  if (scheme.reach > 0 && features.crease_method == CreaseMethod::chaikin &&
      has_semi_sharp_edge(features)) {
    const std::vector<HalfedgeId> first_ring = walk.halfedges();
    for (const HalfedgeId h : first_ring)
      walk.add_faces_around(h);
    num_complete = ring.num_controls;
  }
  ring.topology = walk.topology();
  ring.vertices = std::move(walk.vertices());
  ring.features = local_features(adjacency, sharpness, ring, walk.halfedges(), num_complete);
  ring.features.crease_method = features.crease_method;
  ring.features.smooth_triangles = features.smooth_triangles;
  return ring;
}

std::string ring_key(const Ring& ring) {
  std::string key;
  const auto put = [&](const auto& value) {
    key.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(ring.num_controls);
  put(ring.features.crease_method);
  put(ring.features.smooth_triangles);
  for (int f = 0; f < ring.topology.num_faces(); ++f) {
    put(ring.topology.face_size(FaceId(f)));
    for (const VertexId v : ring.topology.face(FaceId(f)))
      put(v.value);
  }
  put(-1);
  for (const SharpEdge& e : ring.features.edges) {
    put(e.halfedge.value);
    put(e.sharpness);
  }
  put(-1);
  for (const SharpVertex& v : ring.features.vertices) {
    put(v.vertex.value);
    put(v.sharpness);
  }
  return key;
}

}  // namespace limes
