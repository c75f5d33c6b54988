#include "limes/spectrum/pattern_code.h"

#include <algorithm>

#include "limes/core/error.h"

namespace limes {
namespace {

/// What all walks around one vertex have in common.
struct Region {
  const Adjacency& mesh;
  IdArray<FaceId, char> inside;
  IdArray<EdgeId, char> splits;
};

Region region_of(const Adjacency& mesh, VertexId middle, const std::vector<EdgeId>& to_split,
                 int rings) {
  const Topology& topology = mesh.topology();
  Region region{mesh, IdArray<FaceId, char>(static_cast<std::size_t>(topology.num_faces()), 1),
                IdArray<EdgeId, char>(static_cast<std::size_t>(mesh.num_edges()), 0)};
  const IdArray<VertexId, int> ring = rings_around(topology, middle, rings);
  for (int f = 0; f < topology.num_faces(); ++f)
    for (const VertexId v : topology.face(FaceId(f)))
      if (ring[v] > rings) region.inside[FaceId(f)] = 0;
  for (const EdgeId e : to_split)
    region.splits[e] = 1;
  return region;
}

/// Faces in the order in which they are met from one halfedge, each by its vertices, numbered as they
/// are met, and the marks of its edges.
std::vector<int> code_from(const Region& region, HalfedgeId start) {
  const Adjacency& mesh = region.mesh;
  const Topology& topology = mesh.topology();
  IdArray<VertexId, int> number(static_cast<std::size_t>(topology.num_vertices()), -1);
  IdArray<FaceId, char> waiting = region.inside;
  std::vector<HalfedgeId> entries{start};
  waiting[mesh.face(start)] = 0;
  std::vector<int> code;
  int next = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    HalfedgeId h = entries[i];
    for (int corner = 0; corner < 3; ++corner, h = mesh.next(h)) {
      int& v = number[mesh.from(h)];
      if (v < 0) v = next++;
      code.push_back(2 * v + region.splits[mesh.edge(h)]);
      const HalfedgeId twin = mesh.twin(h);
      if (!twin.valid() || waiting[mesh.face(twin)] == 0) continue;
      waiting[mesh.face(twin)] = 0;
      entries.push_back(twin);
    }
  }
  return code;
}

}  // namespace

IdArray<VertexId, int> rings_around(const Topology& mesh, VertexId middle, int most) {
  IdArray<VertexId, int> ring(static_cast<std::size_t>(mesh.num_vertices()), most + 1);
  ring[middle] = 0;
  for (int r = 0; r < most; ++r)
    for (int f = 0; f < mesh.num_faces(); ++f) {
      const auto corners = mesh.face(FaceId(f));
      if (std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return ring[v] == r; }))
        continue;
      for (const VertexId v : corners)
        ring[v] = std::min(ring[v], r + 1);
    }
  return ring;
}

std::vector<int> pattern_code(const Adjacency& mesh, VertexId middle,
                              const std::vector<EdgeId>& to_split, int rings) {
  LIMES_ASSERT(!mesh.is_boundary(middle));
  const Region region = region_of(mesh, middle, to_split, rings);
  std::vector<int> least;
  const HalfedgeId start = mesh.ring_start(middle);
  for (HalfedgeId h = start;;) {
    std::vector<int> code = code_from(region, h);
    if (least.empty() || code < least) least = std::move(code);
    h = mesh.ring_next(h);
    if (h == start) return least;
  }
}

}  // namespace limes
