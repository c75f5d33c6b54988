#include "limes/subdiv/surroundings.h"

#include <algorithm>

namespace limes {
namespace {

template <class IdType>
void make_set(std::vector<IdType>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

}  // namespace

std::vector<FaceId> faces_around(const Adjacency& adjacency, std::span<const VertexId> vertices) {
  std::vector<FaceId> faces;
  for (const VertexId v : vertices) {
    const HalfedgeId start = adjacency.ring_start(v);
    for (HalfedgeId h = start; h.valid();) {
      faces.push_back(adjacency.face(h));
      h = adjacency.ring_next(h);
      if (h == start) break;
    }
  }
  make_set(faces);
  return faces;
}

SurroundedElements surrounded_by(const Adjacency& adjacency, std::span<const VertexId> vertices) {
  SurroundedElements around;
  around.faces = faces_around(adjacency, vertices);
  around.vertices.assign(vertices.begin(), vertices.end());
  for (const FaceId f : around.faces) {
    const Topology& topology = adjacency.topology();
    for (int i = 0; i < topology.face_size(f); ++i) {
      const HalfedgeId h = topology.halfedge(f, i);
      around.edges.push_back(adjacency.edge(h));
      around.vertices.push_back(adjacency.from(h));
    }
  }
  make_set(around.edges);
  make_set(around.vertices);
  return around;
}

}  // namespace limes
