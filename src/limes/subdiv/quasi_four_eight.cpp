#include "limes/subdiv/quasi_four_eight.h"

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"
#include "limes/mesh/measure.h"
#include "limes/mesh/triangulate.h"
#include "limes/subdiv/child_lists.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/features.h"

namespace limes {
namespace {

/// The tags of a mesh as lists, handed down from step to step.
class QuasiTagLists {
 public:
  /// @throws InputError for tags on what is not there
  QuasiTagLists(const Adjacency& adjacency, const Tags& tags) {
    for (const SharpVertex& v : resolve_tags(adjacency, tags, BoundaryRule::edges).vertices)
      vertices_.push_back({v.vertex, v.sharpness});
    // Features leave out boundary edges, which can be tagged here. Of two tags the last counts.
    IdArray<EdgeId, float> sharpness(static_cast<std::size_t>(adjacency.num_edges()), 0.0F);
    for (const CreaseTag& tag : tags.creases)
      sharpness[adjacency.edge(find_edge(adjacency, tag.a, tag.b))] = tag.sharpness;
    for (int e = 0; e < sharpness.size(); ++e) {
      const HalfedgeId h = adjacency.halfedge(EdgeId(e));
      if (is_sharp(sharpness[EdgeId(e)]))
        edges_.push_back({adjacency.from(h), adjacency.to(h), sharpness[EdgeId(e)]});
    }
  }

  [[nodiscard]] QuasiMarks marks(const Adjacency& adjacency) const {
    QuasiMarks marks;
    if (!edges_.empty()) {
      marks.edges.resize(static_cast<std::size_t>(adjacency.num_edges()), 0);
      for (const CreaseTag& tag : edges_)
        marks.edges[adjacency.edge(find_edge(adjacency, tag.a, tag.b))] = 1;
    }
    if (!vertices_.empty()) {
      marks.vertices.resize(static_cast<std::size_t>(adjacency.topology().num_vertices()), 0);
      for (const CornerTag& tag : vertices_)
        marks.vertices[tag.vertex] = 1;
    }
    return marks;
  }

  /// Halves of tagged edges are tagged, and where these are held the vertices between as well. What is
  /// not infinitely sharp loses 1 when it is split; vertices lose 1 in every second step.
  void split(const Adjacency& parent, const Bisection& step, QuasiTags rule) {
    if (++num_steps_ % 2 == 0) {
      for (CornerTag& tag : vertices_)
        tag.sharpness = decayed(tag.sharpness);
      std::erase_if(vertices_, [](const CornerTag& tag) { return !is_sharp(tag.sharpness); });
    }
    std::vector<CreaseTag> children;
    for (const CreaseTag& tag : edges_) {
      const VertexId middle = step.middle[parent.edge(find_edge(parent, tag.a, tag.b))];
      const float sharpness = middle.valid() ? decayed(tag.sharpness) : tag.sharpness;
      if (!middle.valid()) children.push_back(tag);
      if (!middle.valid() || !is_sharp(sharpness)) continue;
      children.push_back({tag.a, middle, sharpness});
      children.push_back({middle, tag.b, sharpness});
      if (rule == QuasiTags::held) vertices_.push_back({middle, sharpness});
    }
    edges_ = std::move(children);
  }

  [[nodiscard]] Tags tags() const {
    Tags tags;
    tags.creases = edges_;
    tags.corners = vertices_;
    return tags;
  }

 private:
  std::vector<CreaseTag> edges_;
  std::vector<CornerTag> vertices_;
  int num_steps_ = 0;
};

/// A mesh on its way, and the control face that every face comes from.
struct Level {
  Topology topology;
  IdArray<VertexId, Vec3> points;
  std::vector<FaceId> origin;
};

/// The control mesh as triangles.
Level first_level(const Mesh& mesh) {
  Level level{mesh.topology, mesh.points, {}};
  const int num_vertices = mesh.topology.num_vertices();
  if (mesh.topology.uniform_face_size() == 3) {
    for (int f = 0; f < mesh.topology.num_faces(); ++f)
      level.origin.emplace_back(f);
    return level;
  }
  const Triangulation cut = triangulate(mesh.topology, mesh.points.span(), Cuts::new_edges);
  std::vector<VertexId> corners;
  for (const auto& triangle : cut.triangles)
    for (const int v : triangle)
      corners.emplace_back(v);
  for (const int f : cut.source)
    level.origin.emplace_back(f);
  level.topology = Topology(num_vertices, 3, std::move(corners));
  return level;
}

int num_faces_to_cut(const Topology& topology) {
  int count = 0;
  for (int f = 0; f < topology.num_faces(); ++f)
    count += topology.face_size(FaceId(f)) != 3 ? 1 : 0;
  return count;
}

/// One step. @return how many faces were not split
int advance(Level& level, QuasiTagLists& tags, const QuasiOptions& options) {
  const Adjacency adjacency(level.topology, Adjacency::Check::edges);
  const std::vector<EdgeId> edges = options.split == QuasiSplit::longest
                                        ? longest_edges(adjacency, level.points.span())
                                        : edges_between_valence_8(adjacency);
  Bisection step = bisect(adjacency, edges, FirstCorner::kept);
  IdArray<VertexId, Vec3> fine(static_cast<std::size_t>(step.child.num_vertices()));
  quasi_smoothing(adjacency, step, tags.marks(adjacency), options.rules, level.points.span(),
                  fine.span());
  tags.split(adjacency, step, options.rules.tags);
  std::vector<FaceId> origin;
  origin.reserve(static_cast<std::size_t>(step.child.num_faces()));
  for (const FaceId parent : step.parent_face)
    origin.push_back(level.origin[static_cast<std::size_t>(parent.value)]);
  level = {std::move(step.child), std::move(fine), std::move(origin)};
  return step.num_unsplit;
}

/// Enclosed volume in units of the bounding box's diagonal cubed; 0 for open meshes.
double relative_volume(const Mesh& mesh) {
  if (measure(mesh).boundary_loops > 0) return 0;
  const Bounds bounds = bounding_box(mesh);
  const double size = bounds.quarter_diagonal();
  double sum = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto at = [&](VertexId v) -> Vec3 { return (mesh.points[v] - bounds.lower) / size; };
    const auto face = mesh.topology.face(FaceId(f));
    for (std::size_t i = 2; i < face.size(); ++i)
      sum += at(face[0]).dot(at(face[i - 1]).cross(at(face[i])));
  }
  return sum / (6.0 * 64.0);
}

}  // namespace

QuasiRefinement refine_quasi_four_eight(const Mesh& mesh, const QuasiOptions& options) {
  const Adjacency control(mesh.topology);  // refuses what is no surface
  QuasiTagLists tags(control, mesh.tags);
  QuasiRefinement result;
  result.num_cut_faces = num_faces_to_cut(mesh.topology);
  Level level = first_level(mesh);
  const int num_steps = options.split == QuasiSplit::normal ? 2 * options.levels : options.levels;
  for (int i = 0; i < num_steps; ++i)
    result.num_unsplit_faces.push_back(advance(level, tags, options));

  const ChildLists children(level.origin, mesh.topology.num_faces());
  Mesh& fine = result.mesh;
  fine.tags = tags.tags();
  fine.tags.holes = children.of(mesh.tags.holes);
  fine.tags.boundary = mesh.tags.boundary;
  fine.groups = children.of(mesh.groups);
  fine.parts = children.of(mesh.parts);
  fine.topology = std::move(level.topology);
  fine.points = std::move(level.points);
  constexpr double none = 1e-12;
  result.collapsed =
      std::abs(relative_volume(mesh)) > none && std::abs(relative_volume(fine)) <= none;
  return result;
}

}  // namespace limes
