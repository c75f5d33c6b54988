#include "limes/mesh/adjacency.h"

#include <algorithm>
#include <utility>

#include "limes/core/error.h"
#include "limes/mesh/duplicates.h"

namespace limes {
namespace {

struct Ends {
  VertexId from, to;
};

/// Both ends of every halfedge.
std::vector<Ends> halfedge_ends(const Topology& topology) {
  std::vector<Ends> ends(static_cast<std::size_t>(topology.num_corners()));
  std::size_t h = 0;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i)
      ends[h++] = {face[i], face[i + 1 == face.size() ? 0 : i + 1]};
  }
  return ends;
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
  const auto ends = halfedge_ends(topology);
  // Counting sort by the lower vertex, then a small sort by the higher one.
  std::vector<int> start(static_cast<std::size_t>(topology.num_vertices()) + 1, 0);
  for (const Ends& e : ends)
    ++start[static_cast<std::size_t>(std::min(e.from, e.to).value) + 1];
  for (std::size_t v = 1; v < start.size(); ++v)
    start[v] += start[v - 1];

  using Entry = std::pair<VertexId, HalfedgeId>;  // higher vertex, halfedge
  std::vector<Entry> entries(ends.size());
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (std::size_t h = 0; h < ends.size(); ++h) {
    const auto [low, high] = std::minmax(ends[h].from, ends[h].to);
    entries[static_cast<std::size_t>(fill[static_cast<std::size_t>(low.value)]++)] = {
        high, HalfedgeId(static_cast<std::int64_t>(h))};
  }

  EdgeGroups groups;
  groups.halfedges.reserve(ends.size());
  groups.offsets.reserve(ends.size() / 2 + 1);
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    const auto begin = entries.begin() + start[v];
    const auto end = entries.begin() + start[v + 1];
    std::sort(begin, end);
    for (auto it = begin; it != end; ++it) {
      if (it == begin || it->first != (it - 1)->first)
        groups.offsets.push_back(static_cast<int>(groups.halfedges.size()));
      groups.halfedges.push_back(it->second);
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
  const EdgeGroups groups = group_by_edge(topology);
  for (std::size_t g = 0; g + 1 < groups.offsets.size(); ++g) {
    const HalfedgeId* h = groups.halfedges.data() + groups.offsets[g];
    const int count = groups.offsets[g + 1] - groups.offsets[g];
    if (count > 2)
      throw InputError("edge {}-{} has {} faces (first {}, {} and {}); at most two can be joined",
                       from(h[0]).value, to(h[0]).value, count, face(h[0]).value, face(h[1]).value,
                       face(h[2]).value);
    if (count == 2) {
      if (from(h[0]) == from(h[1]))
        throw InputError(
            "faces {} and {} run along edge {}-{} in the same direction; one of them "
            "must be turned around (--repair)",
            face(h[0]).value, face(h[1]).value, from(h[0]).value, to(h[0]).value);
      twin_[h[0]] = h[1];
      twin_[h[1]] = h[0];
    }
  }

  first_halfedge_.reserve(groups.offsets.size());
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
  int reached = 0;
  for (int v = 0; v < num_vertices; ++v)
    if (ring_start_[VertexId(v)].valid()) reached += num_ring_faces(VertexId(v));
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
  const FaceId f = face(h);
  const int first = topology_->halfedge(f, 0).value;
  return h.value + 1 == first + topology_->face_size(f) ? HalfedgeId(first)
                                                        : HalfedgeId(h.value + 1);
}

HalfedgeId Adjacency::prev(HalfedgeId h) const {
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

}  // namespace limes
