#include "limes/subdiv/drop_faces.h"

#include <algorithm>
#include <set>
#include <utility>

namespace limes {

std::vector<bool> unsupported_faces(const Adjacency& adjacency, const Tags& tags) {
  std::set<std::pair<VertexId, VertexId>> kept_edges;
  for (const CreaseTag& t : tags.creases)
    if (t.sharpness >= infinite_sharpness) kept_edges.insert(std::minmax(t.a, t.b));
  const auto is_kept = [&](HalfedgeId h) {
    return kept_edges.contains(std::minmax(adjacency.from(h), adjacency.to(h)));
  };

  const Topology& topology = adjacency.topology();
  IdArray<VertexId, char> open(static_cast<std::size_t>(topology.num_vertices()), 0);
  for (int i = 0; i < topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    if (adjacency.twin(h).valid() || is_kept(h)) continue;
    open[adjacency.from(h)] = 1;
    open[adjacency.to(h)] = 1;
  }
  std::vector<bool> result(static_cast<std::size_t>(topology.num_faces()), false);
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    result[static_cast<std::size_t>(f)] =
        std::any_of(face.begin(), face.end(), [&](VertexId v) { return open[v] != 0; });
  }
  return result;
}

Mesh without_faces(const Mesh& mesh, const std::vector<bool>& drop) {
  const Topology& topology = mesh.topology;
  IdArray<FaceId, FaceId> new_face(static_cast<std::size_t>(topology.num_faces()));
  IdArray<VertexId, VertexId> new_vertex(static_cast<std::size_t>(topology.num_vertices()));
  Mesh out;
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (int i = 0; i < topology.num_faces(); ++i) {
    if (drop[static_cast<std::size_t>(i)]) continue;
    new_face[FaceId(i)] = FaceId(static_cast<std::int64_t>(offsets.size()) - 1);
    for (const VertexId v : topology.face(FaceId(i))) {
      new_vertex[v] = VertexId(0);  // used; numbered below, in the old order
      corners.push_back(v);
    }
    offsets.push_back(static_cast<int>(corners.size()));
  }
  for (int v = 0; v < topology.num_vertices(); ++v) {
    if (!new_vertex[VertexId(v)].valid()) continue;
    new_vertex[VertexId(v)] = VertexId(out.points.size());
    out.points.push_back(mesh.points[VertexId(v)]);
  }
  for (VertexId& v : corners)
    v = new_vertex[v];
  out.topology = Topology(out.points.size(), std::move(offsets), std::move(corners));

  const auto keep = [&](const std::vector<FaceId>& faces) {
    std::vector<FaceId> kept;
    for (const FaceId f : faces)
      if (new_face[f].valid()) kept.push_back(new_face[f]);
    return kept;
  };
  for (const FaceGroup& g : mesh.groups)
    out.groups.push_back({g.name, keep(g.faces)});
  for (const FaceGroup& g : mesh.parts)
    out.parts.push_back({g.name, keep(g.faces)});
  out.tags = mesh.tags;
  out.tags.holes = keep(mesh.tags.holes);
  std::erase_if(out.tags.creases, [&](const CreaseTag& t) {
    return !new_vertex[t.a].valid() || !new_vertex[t.b].valid();
  });
  for (CreaseTag& t : out.tags.creases)
    t = {new_vertex[t.a], new_vertex[t.b], t.sharpness};
  std::erase_if(out.tags.corners,
                [&](const CornerTag& t) { return !new_vertex[t.vertex].valid(); });
  for (CornerTag& t : out.tags.corners)
    t.vertex = new_vertex[t.vertex];
  return out;
}

}  // namespace limes
