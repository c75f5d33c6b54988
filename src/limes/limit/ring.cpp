#include "limes/limit/ring.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace limes {
namespace {

/// Numbers things in the order in which they first appear. Few are looked up one by one, which is
/// fastest for the usual 16 vertices of a ring; many by hash.
template <class IdType>
class Numbering {
 public:
  /// The number, and whether it is new.
  std::pair<int, bool> number(IdType id) {
    const int next = static_cast<int>(ids_.size());
    if (next < few) {
      const auto found = std::find(ids_.begin(), ids_.end(), id);
      if (found != ids_.end()) return {static_cast<int>(found - ids_.begin()), false};
    } else {
      if (next == few)
        for (int i = 0; i < few; ++i)
          known_.emplace(ids_[static_cast<std::size_t>(i)].value, i);
      const auto [it, added] = known_.emplace(id.value, next);
      if (!added) return {it->second, false};
    }
    ids_.push_back(id);
    return {next, true};
  }
  [[nodiscard]] std::vector<IdType>& ids() { return ids_; }

 private:
  static constexpr int few = 64;
  std::vector<IdType> ids_;
  std::unordered_map<std::int32_t, int> known_;  // never iterated
};

/// Collects faces in walk order, each from a given corner on, and numbers their vertices.
class RingWalk {
 public:
  RingWalk(const Adjacency& adjacency) : adjacency_(adjacency) {}

  /// Adds the face of h, starting at h, unless it is there.
  void add_face(HalfedgeId h) {
    const FaceId f = adjacency_.face(h);
    if (!faces_.number(f).second) return;
    const int n = adjacency_.topology().face_size(f);
    for (int i = 0; i < n; ++i, h = adjacency_.next(h)) {
      halfedges_.push_back(h);
      corners_.emplace_back(vertices_.number(adjacency_.from(h)).first);
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

  [[nodiscard]] const std::vector<HalfedgeId>& halfedges() const { return halfedges_; }
  std::vector<VertexId>& vertices() { return vertices_.ids(); }
  [[nodiscard]] Topology topology() {
    return {static_cast<int>(vertices().size()), offsets_, corners_};
  }

 private:
  const Adjacency& adjacency_;
  Numbering<FaceId> faces_;
  Numbering<VertexId> vertices_;
  std::vector<int> offsets_{0};
  std::vector<VertexId> corners_;      // local
  std::vector<HalfedgeId> halfedges_;  // of the large mesh, one per corner
};

bool has_semi_sharp_edge(const Adjacency& adjacency, const Sharpness& sharpness,
                         const std::vector<HalfedgeId>& halfedges) {
  return std::any_of(halfedges.begin(), halfedges.end(), [&](HalfedgeId h) {
    const float s = sharpness.edge(adjacency.edge(h));
    return s > 0 && s < infinite_sharpness;
  });
}

/// Sharp edges inside the local mesh, at the local vertices [0, num_complete), whose faces are all
/// there. Sharp edges are few: their other side is looked up one by one.
std::vector<SharpEdge> local_edges(const Adjacency& large, const Sharpness& sharpness,
                                   const Ring& ring, const std::vector<HalfedgeId>& halfedges,
                                   int num_complete) {
  std::vector<SharpEdge> edges;
  const auto count = static_cast<int>(halfedges.size());
  for (int i = 0; i < count; ++i) {
    const HalfedgeId h = halfedges[static_cast<std::size_t>(i)];
    const HalfedgeId twin = large.twin(h);
    const float s = twin.valid() ? sharpness.edge(large.edge(h)) : 0.0F;
    if (s <= 0) continue;
    const auto found = std::find(halfedges.begin() + i, halfedges.end(), twin);
    if (found == halfedges.end()) continue;  // done from the other side, or at the ring's rim
    const VertexId a = ring.topology.corner(HalfedgeId(i));
    const VertexId b = ring.topology.corner(HalfedgeId(found - halfedges.begin()));
    // All infinite sharpnesses are the same kind.
    if (std::min(a, b).value < num_complete)
      edges.push_back({HalfedgeId(i), std::min(s, infinite_sharpness)});
  }
  return edges;
}

std::vector<SharpVertex> local_vertices(const Sharpness& sharpness, const Ring& ring,
                                        int num_complete) {
  std::vector<SharpVertex> vertices;
  for (int v = 0; v < num_complete; ++v) {
    const float s = sharpness.vertex(ring.vertices[static_cast<std::size_t>(v)]);
    if (s > 0) vertices.push_back({VertexId(v), std::min(s, infinite_sharpness)});
  }
  return vertices;
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
      has_semi_sharp_edge(adjacency, sharpness, walk.halfedges())) {
    const std::vector<HalfedgeId> first_ring = walk.halfedges();
    for (const HalfedgeId h : first_ring)
      walk.add_faces_around(h);
    num_complete = ring.num_controls;
  }
  ring.topology = walk.topology();
  ring.vertices = std::move(walk.vertices());
  if (!features.edges.empty())
    ring.features.edges = local_edges(adjacency, sharpness, ring, walk.halfedges(), num_complete);
  ring.features.vertices = local_vertices(sharpness, ring, num_complete);
  static_cast<RuleOptions&>(ring.features) = features;
  return ring;
}

namespace {

/// Four quads and four edges without sharpness around the start of h.
bool is_plain_corner(const Adjacency& adjacency, const Sharpness& sharpness, HalfedgeId h) {
  if (sharpness.vertex(adjacency.from(h)) > 0) return false;
  HalfedgeId at = h;
  for (int i = 0; i < 4; ++i) {
    if (adjacency.topology().face_size(adjacency.face(at)) != 4) return false;
    if (sharpness.edge(adjacency.edge(at)) > 0) return false;  // or on the boundary
    at = adjacency.ring_next(at);
    if (!at.valid() || (at == h) != (i == 3)) return false;
  }
  return true;
}

}  // namespace

std::optional<std::array<VertexId, 16>> plain_ring(const Adjacency& adjacency,
                                                   const Sharpness& sharpness, FaceId f) {
  if (adjacency.topology().face_size(f) != 4) return {};
  std::array<VertexId, 16> vertices;
  std::size_t count = 0;
  for (int i = 0; i < 4; ++i) {
    const HalfedgeId h = adjacency.topology().halfedge(f, i);
    if (!is_plain_corner(adjacency, sharpness, h)) return {};
    vertices[count++] = adjacency.from(h);
  }
  // Around corner 0 the face across side 3, the diagonal one and the one across side 0; around the
  // others the diagonal face and the next. Each adds the vertices that are new.
  for (int i = 0; i < 4; ++i) {
    const HalfedgeId across = adjacency.ring_next(adjacency.topology().halfedge(f, i));
    const HalfedgeId diagonal = adjacency.ring_next(across);
    if (i == 0) {
      vertices[count++] = adjacency.to(adjacency.next(across));
      vertices[count++] = adjacency.from(adjacency.prev(across));
    }
    vertices[count++] = adjacency.to(adjacency.next(diagonal));
    if (i == 3) break;
    vertices[count++] = adjacency.from(adjacency.prev(diagonal));
    vertices[count++] = adjacency.to(adjacency.next(adjacency.ring_next(diagonal)));
  }
  for (std::size_t i = 1; i < vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (vertices[i] == vertices[j]) return {};
  return vertices;
}

std::string ring_key(const Ring& ring) {
  std::string key;
  key.reserve(
      4 * static_cast<std::size_t>(ring.topology.num_corners() + ring.topology.num_faces()) +
      8 * (ring.features.edges.size() + ring.features.vertices.size()) + 32);
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
