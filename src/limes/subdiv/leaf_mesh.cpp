#include "limes/subdiv/leaf_mesh.h"

#include <algorithm>
#include <set>
#include <utility>

namespace limes {
namespace {

/// Numbers of the mesh's vertices for those of the forest: the control mesh's first, as they are.
class Numbering {
 public:
  explicit Numbering(const LocalRefinement& refined)
      : number_(static_cast<std::size_t>(refined.num_vertices())) {
    for (int v = 0; v < refined.control().topology.num_vertices(); ++v)
      (void)of(VertexId(v));
  }
  VertexId of(VertexId node) {
    VertexId& v = number_[node];
    if (!v.valid()) {
      v = VertexId(nodes_.size());
      nodes_.push_back(node);
    }
    return v;
  }
  [[nodiscard]] const std::vector<VertexId>& nodes() const { return nodes_; }

 private:
  IdArray<VertexId, VertexId> number_;
  std::vector<VertexId> nodes_;
};

std::vector<FaceGroup> handed_down(const std::vector<FaceGroup>& groups,
                                   const std::vector<std::vector<FaceId>>& faces_of_root) {
  std::vector<FaceGroup> all;
  for (const FaceGroup& g : groups) {
    FaceGroup& made = all.emplace_back();
    made.name = g.name;
    for (const FaceId root : g.faces) {
      const auto& faces = faces_of_root[static_cast<std::size_t>(root.value)];
      made.faces.insert(made.faces.end(), faces.begin(), faces.end());
    }
  }
  return all;
}

void hand_down_names(const LocalRefinement& refined, const LeafPieces& pieces, Mesh& mesh) {
  const Mesh& control = refined.control();
  std::vector<std::vector<FaceId>> faces(static_cast<std::size_t>(control.topology.num_faces()));
  for (std::size_t f = 0; f < pieces.leaves().size(); ++f)
    faces[static_cast<std::size_t>(refined.ancestry(pieces.leaves()[f]).root.value)].push_back(
        FaceId(f));
  mesh.groups = handed_down(control.groups, faces);
  mesh.parts = handed_down(control.parts, faces);
  for (const FaceId hole : control.tags.holes) {
    const auto& below = faces[static_cast<std::size_t>(hole.value)];
    mesh.tags.holes.insert(mesh.tags.holes.end(), below.begin(), below.end());
  }
}

void hand_down_tags(const LocalRefinement& refined, const LeafPieces& pieces,
                    const std::vector<VertexId>& nodes, Mesh& mesh) {
  const Tags& control = refined.control().tags;
  mesh.tags.boundary = control.boundary;
  mesh.tags.crease_method = control.crease_method;
  mesh.tags.smooth_triangles = control.smooth_triangles;
  IdArray<VertexId, float> corner(nodes.size(), 0.0F);
  std::vector<CreaseTag> backward;  // seen from b to a, which may be the only face there
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const int level = refined.ancestry(pieces.leaves()[static_cast<std::size_t>(f)]).level;
    const auto face = mesh.topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const VertexId a = face[i], b = face[(i + 1) % face.size()];
      const VertexId from = nodes[static_cast<std::size_t>(a.value)];
      corner[a] = std::max(corner[a], refined.vertex_sharpness(level, from));
      const float s = refined.edge_sharpness(from, nodes[static_cast<std::size_t>(b.value)]);
      if (s > 0 && a < b) mesh.tags.creases.push_back({a, b, s});
      if (s > 0 && b < a) backward.push_back({b, a, s});
    }
  }
  std::set<std::pair<VertexId, VertexId>> seen;
  for (const CreaseTag& e : mesh.tags.creases)
    seen.emplace(e.a, e.b);
  for (const CreaseTag& e : backward)
    if (!seen.contains({e.a, e.b})) mesh.tags.creases.push_back(e);
  for (std::size_t v = 0; v < nodes.size(); ++v)
    if (corner[VertexId(v)] > 0) mesh.tags.corners.push_back({VertexId(v), corner[VertexId(v)]});
}

void add_ancestry(const LocalRefinement& refined, const LeafPieces& pieces, Mesh& mesh) {
  mesh.face_fields = {{"root", {}}, {"level", {}}, {"path", {}}};
  for (const FaceId leaf : pieces.leaves()) {
    const FaceAncestry a = refined.ancestry(leaf);
    mesh.face_fields[0].values.push_back(a.root.value);
    mesh.face_fields[1].values.push_back(a.level);
    mesh.face_fields[2].values.push_back(a.path);
  }
}

/// Meshes of faces of one size are smaller and faster.
Topology topology_of(int num_vertices, const LeafPieces& pieces, std::vector<VertexId> corners) {
  const std::vector<int>& offsets = pieces.offsets();
  bool same = offsets.size() > 1;
  for (std::size_t f = 1; same && f < offsets.size(); ++f)
    same = offsets[f] - offsets[f - 1] == offsets[1];
  return same ? Topology(num_vertices, offsets[1], std::move(corners))
              : Topology(num_vertices, offsets, std::move(corners));
}

}  // namespace

ForestMesh leaf_mesh(const LocalRefinement& refined, const LeafPieces& pieces) {
  Numbering numbering(refined);
  std::vector<VertexId> corners;
  corners.reserve(pieces.corners().size());
  for (const VertexId node : pieces.corners())
    corners.push_back(numbering.of(node));
  ForestMesh made;
  for (const VertexId node : numbering.nodes())
    made.mesh.points.push_back(refined.position(node));
  made.mesh.topology = topology_of(made.mesh.points.size(), pieces, std::move(corners));
  hand_down_names(refined, pieces, made.mesh);
  hand_down_tags(refined, pieces, numbering.nodes(), made.mesh);
  add_ancestry(refined, pieces, made.mesh);
  made.leaves = pieces.leaves();
  made.nodes = numbering.nodes();
  return made;
}

}  // namespace limes
