#include "limes/subdiv/bisect.h"

#include <limits>

#include "limes/core/error.h"
#include "limes/subdiv/triangle_mesh.h"

namespace limes {
namespace {

void require_numbers(const Topology& parent, std::size_t num_edges) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() / 3;
  const std::int64_t num_faces =
      parent.num_faces() + std::int64_t{2} * static_cast<std::int64_t>(num_edges);
  if (num_faces > most)
    throw InputError("refinement would have {} faces; at most {} can be numbered", num_faces, most);
}

/// Two triangles with the same corners would get two edges from the new vertex to the third.
void require_different_corners(const Adjacency& parent, std::span<const EdgeId> edges) {
  for (const EdgeId e : edges) {
    const HalfedgeId h = parent.halfedge(e), twin = parent.twin(h);
    if (twin.valid() && parent.from(parent.prev(h)) == parent.from(parent.prev(twin)))
      throw InputError(
          "faces {} and {} have the same corners; halved, they would join two vertices twice",
          parent.face(h).value, parent.face(twin).value);
  }
}

}  // namespace

Bisection bisect(const Adjacency& parent, std::span<const EdgeId> edges, FirstCorner first_corner) {
  const Topology& topology = parent.topology();
  require_numbers(topology, edges.size());
  require_different_corners(parent, edges);
  Bisection result;
  result.middle.resize(static_cast<std::size_t>(parent.num_edges()));
  IdArray<FaceId, FaceId> second_child(static_cast<std::size_t>(topology.num_faces()));
  TriangleMesh mesh(parent);
  for (const EdgeId e : edges) {
    const HalfedgeId h = parent.halfedge(e), twin = parent.twin(h);
    const int num_faces = mesh.num_faces();
    result.middle[e] = mesh.split_edge(h);
    second_child[parent.face(h)] = FaceId(num_faces);
    if (twin.valid()) second_child[parent.face(twin)] = FaceId(num_faces + 1);
  }

  std::vector<VertexId> corners;
  corners.reserve(static_cast<std::size_t>(mesh.num_faces()) * 3);
  result.parent_face.reserve(static_cast<std::size_t>(mesh.num_faces()));
  const auto add = [&](FaceId child, int first, FaceId parent_face) {
    for (int i = 0; i < 3; ++i)
      corners.push_back(mesh.from(mesh.halfedge(child, (first + i) % 3)));
    result.parent_face.push_back(parent_face);
  };
  for (int i = 0; i < topology.num_faces(); ++i) {
    const FaceId f(i), second = second_child[f];
    add(f, second.valid() && first_corner == FirstCorner::newest ? 1 : 0, f);
    if (second.valid())
      add(second, 0, f);
    else
      ++result.num_unsplit;
  }
  result.child = Topology(mesh.num_vertices(), 3, std::move(corners));
  return result;
}

}  // namespace limes
