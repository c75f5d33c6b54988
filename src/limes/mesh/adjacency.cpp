#include "limes/mesh/adjacency.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/parallel.h"
#include "limes/mesh/duplicates.h"

namespace limes {
namespace {

/// Calls visit(halfedge, from, to) for every halfedge, in order.
template <class Visit>
void for_each_halfedge(const Topology& topology, const Visit& visit) {
  std::int64_t h = 0;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i)
      visit(HalfedgeId(h++), face[i], face[i + 1 == face.size() ? 0 : i + 1]);
  }
}

/// Halfedges by the lower vertex of their edge, ascending: those of v are
/// entries[start[v], start[v + 1]).
struct HalfedgesByVertex {
  struct Entry {
    VertexId high;  // the edge's other end
    HalfedgeId halfedge;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  std::vector<int> start;
  std::vector<Entry> entries;

  /// A counting sort.
  explicit HalfedgesByVertex(const Topology& topology)
      : start(static_cast<std::size_t>(topology.num_vertices()) + 2, 0),
        entries(static_cast<std::size_t>(topology.num_corners())) {
    for_each_halfedge(topology, [&](HalfedgeId, VertexId from, VertexId to) {
      ++start[static_cast<std::size_t>(std::min(from, to).value) + 2];
    });
    for (std::size_t v = 2; v < start.size(); ++v)
      start[v] += start[v - 1];
    for_each_halfedge(topology, [&](HalfedgeId h, VertexId from, VertexId to) {
      int& next = start[static_cast<std::size_t>(std::min(from, to).value) + 1];
      entries[static_cast<std::size_t>(next++)] = {std::max(from, to), h};
    });
    start.pop_back();
  }

  [[nodiscard]] std::span<Entry> at(std::int64_t v) {
    const auto i = static_cast<std::size_t>(v);
    return std::span(entries).subspan(static_cast<std::size_t>(start[i]),
                                      static_cast<std::size_t>(start[i + 1] - start[i]));
  }
};

/// Joins the halfedges of each edge, in parallel.
/// @return whether that was possible: no edge has more than two, nor two in the same direction
bool pair_twins(const Topology& topology, IdArray<HalfedgeId, HalfedgeId>& twin) {
  using Entry = HalfedgesByVertex::Entry;
  HalfedgesByVertex by_vertex(topology);
  std::atomic<bool> fits = true;
  const auto join = [&](HalfedgeId a, HalfedgeId b) {
    if (twin[a].valid() || topology.corner(a) == topology.corner(b)) fits = false;
    twin[a] = b;
    twin[b] = a;
  };
  for_each_index(topology.num_vertices(), [&](std::int64_t v) {
    const std::span<Entry> around = by_vertex.at(v);
    if (around.size() > 16) {
      std::sort(around.begin(), around.end());
      for (std::size_t i = 1; i < around.size(); ++i)
        if (around[i].high == around[i - 1].high) join(around[i - 1].halfedge, around[i].halfedge);
      return;
    }
    for (std::size_t i = 1; i < around.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (around[i].high == around[k].high) join(around[k].halfedge, around[i].halfedge);
  });
  return fits;
}

/// @throws InputError for the first edge, by its vertices, whose faces cannot be joined
void require_joinable_edges(const Topology& topology) {
  const EdgeGroups groups = group_by_edge(topology);
  const auto from = [&](HalfedgeId h) { return topology.corner(h).value; };
  const auto face = [&](HalfedgeId h) { return topology.face_of(h).value; };
  for (std::size_t g = 0; g + 1 < groups.offsets.size(); ++g) {
    const HalfedgeId* h = groups.halfedges.data() + groups.offsets[g];
    const int count = groups.offsets[g + 1] - groups.offsets[g];
    const int to = topology.corner(topology.next(h[0])).value;
    if (count > 2)
      throw InputError("edge {}-{} has {} faces (first {}, {} and {}); at most two can be joined",
                       from(h[0]), to, count, face(h[0]), face(h[1]), face(h[2]));
    if (count == 2 && from(h[0]) == from(h[1]))
      throw InputError(
          "faces {} and {} run along edge {}-{} in the same direction; one of them must be turned "
          "around (--repair)",
          face(h[0]), face(h[1]), from(h[0]), to);
  }
}

void require_simple_faces(const Topology& topology) {
  std::vector<VertexId> scratch;
  for (int f = 0; f < topology.num_faces(); ++f)
    if (const VertexId v = repeated_vertex(topology.face(FaceId(f)), scratch); v.valid())
      throw InputError(
          "face {} uses vertex {} twice; every corner of a face must be another vertex", f,
          v.value);
}

}  // namespace

IdArray<HalfedgeId, FaceId> faces_of_halfedges(const Topology& topology) {
  IdArray<HalfedgeId, FaceId> face_of(static_cast<std::size_t>(topology.num_corners()));
  for (int f = 0; f < topology.num_faces(); ++f)
    for (int i = 0; i < topology.face_size(FaceId(f)); ++i)
      face_of[topology.halfedge(FaceId(f), i)] = FaceId(f);
  return face_of;
}

EdgeGroups group_by_edge(const Topology& topology) {
  HalfedgesByVertex by_vertex(topology);
  EdgeGroups groups;
  groups.halfedges.reserve(by_vertex.entries.size());
  groups.offsets.reserve(by_vertex.entries.size() / 2 + 1);
  for (int v = 0; v < topology.num_vertices(); ++v) {
    const auto around = by_vertex.at(v);
    std::sort(around.begin(), around.end());
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (i == 0 || around[i].high != around[i - 1].high)
        groups.offsets.push_back(static_cast<int>(groups.halfedges.size()));
      groups.halfedges.push_back(around[i].halfedge);
    }
  }
  groups.offsets.push_back(static_cast<int>(groups.halfedges.size()));
  return groups;
}

Adjacency::Adjacency(const Topology& topology, Check check)
    : topology_(&topology),
      face_size_(topology.uniform_face_size()),
      twin_(static_cast<std::size_t>(topology.num_corners())),
      edge_(static_cast<std::size_t>(topology.num_corners())),
      ring_start_(static_cast<std::size_t>(topology.num_vertices())) {
  if (!face_size_) face_of_ = faces_of_halfedges(topology);

  if (check == Check::surface) require_simple_faces(topology);
  if (!pair_twins(topology, twin_)) require_joinable_edges(topology);

  first_halfedge_.reserve(static_cast<std::size_t>(topology.num_corners()) / 2 + 1);
  for (int i = 0; i < topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    const HalfedgeId other = twin_[h];
    if (other.valid() && other < h) {
      edge_[h] = edge_[other];
    } else {
      edge_[h] = EdgeId(first_halfedge_.size());
      first_halfedge_.push_back(h);
    }
  }

  for (int i = 0; i < topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    HalfedgeId& start = ring_start_[from(h)];
    if (!start.valid() || (!twin_[h].valid() && twin_[start].valid())) start = h;
  }
  if (check == Check::surface) require_one_ring_per_vertex();
}

void Adjacency::require_one_ring_per_vertex() const {
  const auto num_vertices = static_cast<int>(ring_start_.size());
  std::atomic<int> reached = 0;
  for_each_block(num_vertices, 1024, [&](std::int64_t begin, std::int64_t end) {
    int faces = 0;
    for (std::int64_t v = begin; v < end; ++v)
      faces += num_ring_faces(VertexId(v));
    reached += faces;
  });
  if (reached == topology_->num_corners()) return;

  IdArray<HalfedgeId, char> in_ring(static_cast<std::size_t>(topology_->num_corners()), 0);
  for (int v = 0; v < num_vertices; ++v) {
    const HalfedgeId start = ring_start_[VertexId(v)];
    for (HalfedgeId h = start; h.valid();) {
      in_ring[h] = 1;
      h = ring_next(h);
      if (h == start) break;
    }
  }
  HalfedgeId h(0);
  while (in_ring[h])
    h = HalfedgeId(h.value + 1);
  throw InputError(
      "vertex {} joins faces that share no edge there (face {} and face {}); it must be split into "
      "one vertex for each fan of faces (--repair)",
      from(h).value, face(ring_start_[from(h)]).value, face(h).value);
}

HalfedgeId Adjacency::next(HalfedgeId h) const {
  if (face_size_ == 4) return HalfedgeId((h.value & ~3) | ((h.value + 1) & 3));
  const FaceId f = face(h);
  const int first = topology_->halfedge(f, 0).value;
  return h.value + 1 == first + topology_->face_size(f) ? HalfedgeId(first)
                                                        : HalfedgeId(h.value + 1);
}

HalfedgeId Adjacency::prev(HalfedgeId h) const {
  if (face_size_ == 4) return HalfedgeId((h.value & ~3) | ((h.value + 3) & 3));
  const FaceId f = face(h);
  const int first = topology_->halfedge(f, 0).value;
  return h.value == first ? HalfedgeId(first + topology_->face_size(f) - 1)
                          : HalfedgeId(h.value - 1);
}

int Adjacency::num_ring_faces(VertexId v) const {
  const HalfedgeId start = ring_start(v);
  int count = 0;
  for (HalfedgeId h = start; h.valid();) {
    ++count;
    h = ring_next(h);
    if (h == start) break;
  }
  return count;
}

namespace {

/// Looks for the other end of an edge around one of its ends, face by face.
struct RingSearch {
  const Adjacency& adjacency;
  VertexId other;
  HalfedgeId start, at = start;

  /// The edge if the next face has it, as an invalid halfedge if not. Precondition: at is valid.
  HalfedgeId step() {
    if (adjacency.to(at) == other) return at;
    const HalfedgeId in = adjacency.prev(at);
    if (adjacency.from(in) == other) return in;
    at = adjacency.ring_next(at);
    if (at == start) at = {};
    return {};
  }
};

}  // namespace

HalfedgeId find_edge(const Adjacency& adjacency, VertexId a, VertexId b) {
  RingSearch around_a{adjacency, b, adjacency.ring_start(a)};
  RingSearch around_b{adjacency, a, adjacency.ring_start(b)};
  while (around_a.at.valid() && around_b.at.valid())
    for (RingSearch* search : {&around_a, &around_b})
      if (const HalfedgeId h = search->step(); h.valid())
        return adjacency.halfedge(adjacency.edge(h));
  return {};
}

}  // namespace limes
