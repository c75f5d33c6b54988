#include "limes/subdiv/bisection_forest.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/splits.h"

namespace limes {

BisectionForest::BisectionForest(const Mesh& control)
    : root_(std::make_shared<const ControlMesh>(control)), positions_(control.points) {
  if (control.tags.crease_method == CreaseMethod::chaikin && !control.tags.creases.empty())
    throw InputError(
        "the creases have the method chaikin; bisection knows uniform creases: remove 't "
        "creasemethod'");
  const Topology& topology = root_->mesh.topology;
  faces_.resize(static_cast<std::size_t>(topology.num_faces()));
  for (int f = 0; f < topology.num_faces(); ++f)
    faces_[FaceId(f)].root = FaceId(f);
  const Features tags = resolve_tags(root_->adjacency, control.tags, BoundaryRule::edges);
  for (const SharpEdge& e : tags.edges)
    sharp_edges_.set(root_->adjacency.from(e.halfedge), root_->adjacency.to(e.halfedge),
                     e.sharpness);
  for (const SharpVertex& v : tags.vertices)
    sharp_vertices_[v.vertex.value] = v.sharpness;
}

int BisectionForest::num_children(FaceId f) const {
  return faces_[f].level == 0 ? root_->mesh.topology.face_size(f) : 2;
}

FaceAncestry BisectionForest::ancestry(FaceId f) const {
  return {faces_[f].root, faces_[f].level, faces_[f].path};
}

std::span<const VertexId> BisectionForest::corners(FaceId f) const {
  return faces_[f].level == 0 ? root_->mesh.topology.face(f) : std::span(faces_[f].corners);
}

float BisectionForest::vertex_sharpness(int level, VertexId v) const {
  const auto at = sharp_vertices_.find(v.value);
  float sharpness = at == sharp_vertices_.end() ? 0.0F : at->second;
  for (int k = 0; k < level; ++k)
    if (four_eight_splits_creases(k)) sharpness = decayed(sharpness);
  return sharpness;
}

/// Triangles of level 1 are (centre, v_i, v_i+1) on side i of their control face. The children of a
/// triangle (c, a, b) halved at s are (s, c, a), next halved across c-a, and (s, b, c), next across b-c.
/// If the parent of f is a child (s, c, a), then f = 0 is halved across s-c, beyond which its sibling
/// (s, b, c) has child 1 on that side, and f = 1 across a-s, beyond which the mate's child (s, a, c') has
/// child 0. If the parent is (s, b, c), the same with the numbers exchanged.
BisectionForest::Beyond BisectionForest::beyond(FaceId f) const {
  const Face& face = faces_[f];
  const Topology& topology = root_->mesh.topology;
  const FaceId p = face.parent;
  const int i = child_index(f);
  if (face.level == 1) {
    const HalfedgeId twin = root_->adjacency.twin(topology.halfedge(face.root, i));
    if (!twin.valid()) return {};
    return {root_->adjacency.face(twin), root_->adjacency.corner_index(twin)};
  }
  const int j = child_index(p);
  if (face.level == 2) {  // beyond the spoke to corner j or j + 1
    const int n = topology.face_size(face.root);
    return {child(face.root, i == 0 ? (j + n - 1) % n : (j + 1) % n), 1 - i};
  }
  const FaceId grandparent = faces_[p].parent;
  if (i == j) return {child(grandparent, 1 - j), 1 - j};
  const FaceId mate = faces_[grandparent].mate;
  if (!mate.valid()) return {};
  return {child(mate, 1 - j), j};
}

void BisectionForest::add_triangle(FaceId parent, int index,
                                   const std::array<VertexId, 3>& corners) {
  Face face;
  face.corners = corners;
  face.path = faces_[parent].level == 0 ? index : 2 * faces_[parent].path + index;
  face.root = faces_[parent].root;
  face.parent = parent;
  face.level = faces_[parent].level + 1;
  faces_.push_back(face);
}

void BisectionForest::split_control_face(FaceId f) {
  faces_[f].split = true;
  if (faces_[f].first_child.valid()) return;
  faces_[f].first_child = FaceId(faces_.size());
  const auto v = root_->mesh.topology.face(f);
  Vec3 sum = Vec3::Zero();
  for (const VertexId x : v)
    sum += positions_[x];
  const VertexId centre(positions_.size());
  positions_.push_back(sum / static_cast<double>(v.size()));
  for (std::size_t i = 0; i < v.size(); ++i)
    add_triangle(f, static_cast<int>(i), {centre, v[i], v[(i + 1) % v.size()]});
}

/// Of a triangle and the one beyond the side, if there is one.
void BisectionForest::make_children(FaceId f, FaceId mate) {
  const auto [c, a, b] = faces_[f].corners;
  const VertexId s(positions_.size());
  positions_.push_back(0.5 * (positions_[a] + positions_[b]));
  if (const float sharpness = edge_sharpness(a, b); sharpness > 0)
    for (const VertexId end : {a, b})
      sharp_edges_.set(s, end, decayed(sharpness));
  faces_[f].mate = mate;
  if (mate.valid()) faces_[mate].mate = f;
  for (const FaceId g : {f, mate}) {
    if (!g.valid()) continue;
    const std::array<VertexId, 3> v = faces_[g].corners;
    faces_[g].first_child = FaceId(faces_.size());
    add_triangle(g, 0, {s, v[0], v[1]});
    add_triangle(g, 1, {s, v[2], v[0]});
  }
}

void BisectionForest::split(FaceId f, int& count) {
  if (faces_[f].level == 0) {
    split_control_face(f);
    ++count;
    return;
  }
  const Beyond at = beyond(f);
  if (at.parent.valid() && !faces_[at.parent].split) split(at.parent, count);
  const FaceId mate = at.parent.valid() ? child(at.parent, at.child) : FaceId();
  if (!faces_[f].first_child.valid()) make_children(f, mate);
  for (const FaceId g : {f, mate}) {
    if (!g.valid()) continue;
    faces_[g].split = true;
    ++count;
  }
}

int BisectionForest::refine(std::span<const FaceId> leaves) {
  for (const FaceId f : leaves) {
    LIMES_ASSERT(!faces_[f].split);
    if (faces_[f].level == max_level)
      throw InputError(
          "face {} has a face on level {}, which cannot be halved; {} levels are the most",
          faces_[f].root.value, max_level, max_level);
  }
  int count = 0;
  for (const FaceId f : leaves)
    if (!faces_[f].split) split(f, count);
  return count;
}

/// Whether all children of a face are among some leaves, which are sorted.
bool BisectionForest::all_marked(FaceId parent, const std::vector<FaceId>& marked) const {
  const auto first = std::lower_bound(marked.begin(), marked.end(), child(parent, 0));
  const int n = num_children(parent);
  return marked.end() - first >= n && *(first + (n - 1)) == child(parent, n - 1);
}

int BisectionForest::coarsen(std::span<const FaceId> leaves) {
  std::vector<FaceId> marked(leaves.begin(), leaves.end());
  std::sort(marked.begin(), marked.end());
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
  int merged = 0;
  for (const FaceId f : marked) {
    LIMES_ASSERT(!faces_[f].split);
    const FaceId parent = faces_[f].parent;
    if (!parent.valid() || !faces_[parent].split || !all_marked(parent, marked)) continue;
    const FaceId mate = faces_[parent].mate;
    if (mate.valid() && !all_marked(mate, marked)) continue;
    for (const FaceId g : {parent, mate}) {
      if (!g.valid()) continue;
      faces_[g].split = false;
      ++merged;
    }
  }
  return merged;
}

ForestMesh forest_mesh(const BisectionForest& forest) {
  LeafPieces pieces;
  for (const FaceId f : forest.leaves())
    pieces.add(f, forest.corners(f));
  return leaf_mesh(forest, pieces);
}

}  // namespace limes
