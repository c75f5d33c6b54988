#include "limes/subdiv/forest_nodes.h"

#include <algorithm>
#include <utility>

#include "limes/core/error.h"
#include "limes/mesh/pieces.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/split.h"

namespace limes {

namespace {

/// The faces with vertices numbered as they appear.
/// @param nodes  of each vertex
Topology patch_of(std::span<const FaceCorners> faces, int face_size, std::vector<VertexId>& nodes) {
  std::unordered_map<std::int32_t, VertexId> local;
  std::vector<VertexId> corners;
  corners.reserve(4 * faces.size());
  for (const FaceCorners& face : faces)
    for (const VertexId v : std::span(face).first(static_cast<std::size_t>(face_size))) {
      const auto [at, is_new] = local.try_emplace(v.value, VertexId(nodes.size()));
      if (is_new) nodes.push_back(v);
      corners.push_back(at->second);
    }
  return {static_cast<int>(nodes.size()), face_size, std::move(corners)};
}

}  // namespace

/// Some faces as a mesh of its own, a surface: where their rim touches itself each fan of faces has a vertex of
/// its own, so that rules find every edge in the ring of its ends.
struct ForestNodes::Patch {
  /// Of each of the mesh's vertices; copies have the node of what they are copies of.
  std::vector<VertexId> nodes;
  Topology topology;
  Adjacency adjacency;

  Patch(std::span<const FaceCorners> faces, int face_size)
      : topology(patch_of(faces, face_size, nodes)), adjacency(topology, Adjacency::Check::edges) {
    if (!has_bow_ties(adjacency)) return;
    FansApart apart = fans_apart(topology);
    for (const VertexId v : apart.original)
      nodes.push_back(node(v));
    topology = Topology(static_cast<int>(nodes.size()), face_size, std::move(apart.corners));
    adjacency = Adjacency(topology, Adjacency::Check::edges);
  }
  Patch(const Patch&) = delete;
  Patch& operator=(const Patch&) = delete;

  [[nodiscard]] VertexId node(VertexId local) const {
    return nodes[static_cast<std::size_t>(local.value)];
  }
};

ForestNodes::ForestNodes(const Adjacency& control, std::span<const Vec3> points,
                         const Features& features, const Scheme& scheme, LimitsOf limits)
    : scheme_(&scheme), options_(features), limits_(std::move(limits)) {
  positions_.reserve(with_room(points.size()));
  positions_.vector().assign(points.begin(), points.end());
  on_curve_.reserve(with_room(points.size()));
  on_curve_.resize(points.size(), 0);
  last_middle_.reserve(with_room(points.size()));
  last_middle_.resize(points.size());
  middle_.reserve(with_room(points.size()));
  middle_.resize(points.size());
  for (int v = 0; v < control.topology().num_vertices(); ++v)
    on_curve_[VertexId(v)] = control.is_boundary(VertexId(v)) ? 1 : 0;
  for (const SharpEdge& e : features.edges)
    on_curve_[control.from(e.halfedge)] = on_curve_[control.to(e.halfedge)] = 1;
  for (const SharpEdge& e : features.edges)
    sharp_edges_.set(control.from(e.halfedge), control.to(e.halfedge), e.sharpness);
  for (const SharpVertex& v : features.vertices)
    corners_[level_key(0, v.vertex)] = v;
  if (scheme.interpolatory) return;
  LIMES_ASSERT(limits_);
  control_.assign(points.begin(), points.end());
  positions_ = limits_(control.topology(), features, points);
}

std::uint64_t ForestNodes::level_key(int level, VertexId v) {
  return (static_cast<std::uint64_t>(level) << 32) | static_cast<std::uint64_t>(v.value);
}

const Vec3& ForestNodes::value(int level, VertexId v) const {
  if (scheme_->interpolatory) return positions_[v];
  return level == 0 ? control_[static_cast<std::size_t>(v.value)] : values_.at(level_key(level, v));
}

VertexId ForestNodes::middle(VertexId a, VertexId b) const {
  const auto [older, newer] = std::minmax(a, b);
  VertexId m = last_middle_[newer];
  while (m.valid() && middle_[m].older != older)
    m = middle_[m].before;
  return m;
}

float ForestNodes::vertex_sharpness(int level, VertexId v) const {
  const auto at = corners_.find(level_key(level, v));
  return at == corners_.end() ? 0.0F : at->second.sharpness;
}

VertexId ForestNodes::add_vertex(bool on_curve) {
  positions_.push_back(Vec3::Zero());
  on_curve_.push_back(on_curve ? 1 : 0);
  last_middle_.push_back({});
  middle_.push_back({});
  return VertexId(positions_.size() - 1);
}

VertexId ForestNodes::middle_or_new(VertexId a, VertexId b, bool on_curve) {
  if (const VertexId m = middle(a, b); m.valid()) return m;
  const VertexId m = add_vertex(on_curve);
  const auto [older, newer] = std::minmax(a, b);
  middle_[m] = {older, std::exchange(last_middle_[newer], m)};
  return m;
}

Features ForestNodes::features_of(const Patch& patch, int level) const {
  Features features;
  static_cast<RuleOptions&>(features) = options_;
  features.level = options_.level + level;
  if (!sharp_edges_.empty()) {
    const Adjacency& adjacency = patch.adjacency;
    for (int e = 0; e < adjacency.num_edges(); ++e) {
      const HalfedgeId h = adjacency.halfedge(EdgeId(e));
      const float s = edge_sharpness(patch.node(adjacency.from(h)), patch.node(adjacency.to(h)));
      if (s > 0) features.edges.push_back({h, s});
    }
  }
  if (corners_.empty()) return features;
  for (std::size_t i = 0; i < patch.nodes.size(); ++i)
    if (const auto at = corners_.find(level_key(level, patch.nodes[i])); at != corners_.end())
      features.vertices.push_back({VertexId(i), at->second.sharpness, at->second.angle});
  return features;
}

/// @param nodes  of the vertices of the step's child; those of this face are written
ChildNodes ForestNodes::make_children_of(const Patch& patch, FaceId face,
                                         std::span<VertexId> nodes) {
  const Adjacency& adjacency = patch.adjacency;
  const QuadrisectionIds ids = quadrisection_ids(adjacency);
  const auto node = [&](VertexId child) -> VertexId& {
    return nodes[static_cast<std::size_t>(child.value)];
  };
  ChildNodes children;
  for (int i = 0; i < patch.topology.face_size(face); ++i) {
    const HalfedgeId h = patch.topology.halfedge(face, i);
    const VertexId a = patch.node(adjacency.from(h)), b = patch.node(adjacency.to(h));
    const bool curve = !adjacency.twin(h).valid() || edge_sharpness(a, b) > 0;
    const VertexId middle = middle_or_new(a, b, curve);
    node(ids.of_vertex(adjacency.from(h))) = a;
    node(ids.of_edge(adjacency.edge(h))) = middle;
    children.sides[static_cast<std::size_t>(i)] = middle;
  }
  if (scheme_->split == Split::triangles) return children;
  children.centre = add_vertex(false);
  node(ids.of_face(face)) = children.centre;
  return children;
}

std::vector<ChildNodes> ForestNodes::make(int level, std::span<const FaceCorners> faces,
                                          const std::vector<bool>& wanted) {
  const Patch patch(faces, regular_face_size(*scheme_));
  const Features features = features_of(patch, level);
  const RefinementStep step(patch.adjacency, features, *scheme_);
  std::vector<Vec3> coarse;
  coarse.reserve(patch.nodes.size());
  for (const VertexId v : patch.nodes)
    coarse.push_back(value(level, v));
  std::vector<Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
  step.apply(coarse, std::span<Vec3>(fine));

  std::vector<VertexId> nodes(fine.size());  // of the child vertices; of those wanted only
  std::vector<ChildNodes> made;
  const int num_before = size();
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (wanted[f]) made.push_back(make_children_of(patch, FaceId(f), nodes));

  const bool moves = !scheme_->interpolatory;
  const bool tags = !features.edges.empty() || !features.vertices.empty();
  Topology child;
  Features child_features;
  if (moves || tags) {
    child = step.child_topology();
    child_features = step.child_features();
  }
  const IdArray<VertexId, Vec3> limits =
      moves ? limits_(child, child_features, fine) : IdArray<VertexId, Vec3>();
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (!nodes[i].valid()) continue;
    if (moves) values_.try_emplace(level_key(level + 1, nodes[i]), fine[i]);
    if (nodes[i].value >= num_before) positions_[nodes[i]] = moves ? limits[VertexId(i)] : fine[i];
  }
  if (tags) keep_sharp(child, child_features, level + 1, nodes);
  return made;
}

void ForestNodes::keep_sharp(const Topology& child, const Features& features, int level,
                             std::span<const VertexId> nodes) {
  const auto node = [&](VertexId v) { return nodes[static_cast<std::size_t>(v.value)]; };
  for (const SharpEdge& e : features.edges) {
    const VertexId a = node(child.corner(e.halfedge)),
                   b = node(child.corner(child.next(e.halfedge)));
    if (a.valid() && b.valid()) sharp_edges_.set(a, b, e.sharpness);
  }
  for (const SharpVertex& v : features.vertices)
    if (node(v.vertex).valid()) corners_[level_key(level, node(v.vertex))] = v;
}

}  // namespace limes
