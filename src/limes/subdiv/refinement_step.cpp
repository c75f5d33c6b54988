#include "limes/subdiv/refinement_step.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/mesh/face_error.h"
#include "limes/subdiv/sector.h"
#include "limes/subdiv/split.h"
#include "limes/subdiv/splits.h"
#include "limes/subdiv/surroundings.h"

namespace limes {

void require_faces(const Topology& topology, const Scheme& scheme) {
  if (scheme.faces == FaceKind::polygons) return;
  const int wanted = scheme.faces == FaceKind::quads ? 4 : 3;
  for (int f = 0; f < topology.num_faces(); ++f)
    if (topology.face_size(FaceId(f)) != wanted)
      throw FaceError(FaceId(f), "face {} has {} corners; {} takes faces with {} only", f,
                      topology.face_size(FaceId(f)), scheme.name, wanted);
}

namespace {

void require_no_creases(const Adjacency& adjacency, const Features& features,
                        const Scheme& scheme) {
  for (const SharpEdge& e : features.edges)
    throw InputError(
        "the edge of vertices {} and {} is sharp; {} has no creases: remove the "
        "tag, or take catmull-clark or loop",
        adjacency.from(e.halfedge).value, adjacency.to(e.halfedge).value, scheme.name);
  for (const SharpVertex& v : features.vertices)
    throw InputError(
        "vertex {} is sharp; {} has no corners: remove the tag, or take "
        "catmull-clark or loop",
        v.vertex.value, scheme.name);
}

}  // namespace

void append_stencil_row(int row, const Stencil& stencil, const Topology& topology,
                        std::vector<Triplet>& out) {
  for (const Stencil::Group& g : stencil.groups()) {
    for (const std::int32_t id : stencil.ids(g)) {
      if (g.source == Stencil::Source::vertex) {
        out.emplace_back(row, id, g.weight);
        continue;
      }
      const auto corners = topology.face(FaceId(id));
      const double w = g.weight / static_cast<double>(corners.size());
      for (const VertexId v : corners)
        out.emplace_back(row, v.value, w);
    }
  }
}

RefinementStep::RefinementStep(const Adjacency& parent, const Features& features,
                               const Scheme& scheme)
    : parent_(&parent), features_(&features), scheme_(&scheme), sharpness_(parent, features) {
  if (scheme.needs_positions)
    throw UsageError("{} refines by positions: its steps have no weights and no matrix",
                     scheme.name);
  require_faces(parent.topology(), scheme);
  if (!scheme.creases) require_no_creases(parent, features, scheme);
  if (!is_quadrisection(scheme.split)) split_ = explicit_split(parent, features, scheme.split);
  if (scheme.boundary == Boundary::open_net)
    open_net_ = std::make_unique<const OpenNet>(parent, features);
}

int RefinementStep::num_child_vertices() const {
  return split_ ? split_->topology.num_vertices()
                : static_cast<int>(num_split_vertices(*parent_, scheme_->split));
}

int RefinementStep::num_child_faces() const {
  return split_ ? split_->topology.num_faces()
                : static_cast<int>(num_split_faces(parent_->topology(), scheme_->split));
}

Topology RefinementStep::child_topology() const {
  return split_ ? split_->topology : split_topology(*parent_, scheme_->split);
}

Features RefinementStep::child_features() const {
  if (!split_) return split_features(*parent_, *features_, scheme_->split);
  if (scheme_->split == Split::four_eight)
    return four_eight_features(*parent_, *features_, *split_);
  return features_->without_tags(1);
}

std::vector<FaceId> RefinementStep::parent_faces() const {
  if (split_) return split_->parents;
  std::vector<FaceId> parents(static_cast<std::size_t>(num_child_faces()));
  for (int f = 0; f < parent_->topology().num_faces(); ++f) {
    const FaceRange children = descendants(parent_->topology(), FaceId(f), scheme_->split, 1);
    std::fill(parents.begin() + children.begin, parents.begin() + children.end, FaceId(f));
  }
  return parents;
}

ChildVertex RefinementStep::source(VertexId child) const {
  using Kind = ChildVertex::Kind;
  if (split_) return split_->vertices[static_cast<std::size_t>(child.value)];
  const QuadrisectionIds ids = quadrisection_ids(*parent_);
  if (child < ids.of_edge(EdgeId(0))) return {Kind::vertex, 0, child.value};
  const int edge = child.value - ids.num_vertices;
  if (edge < ids.num_edges) return {Kind::edge, 0, edge};
  return {Kind::face, 0, edge - ids.num_edges};
}

VertexId RefinementStep::first_face_point() const {
  return scheme_->split == Split::quads ? quadrisection_ids(*parent_).of_face(FaceId(0))
                                        : VertexId(num_child_vertices());
}

void RefinementStep::stencil(NeighbourhoodWalk& walk, VertexId child, Stencil& out) const {
  stencil(walk, source(child), out);
}

void RefinementStep::stencil(NeighbourhoodWalk& walk, const ChildVertex& source,
                             Stencil& out) const {
  out.clear();
  switch (source.kind) {
    case ChildVertex::Kind::vertex: {
      const VertexId v(source.from);
      if (scheme_->interpolatory || !parent_->ring_start(v).valid()) return out.add(1.0, v);
      return scheme_->vertex_rule(walk.vertex(v), *features_, out);
    }
    case ChildVertex::Kind::edge: {
      const EdgeId e(source.from);
      EdgeNeighbourhood n = is_wide() ? walk.wide_edge(e) : walk.edge(e);
      n.part = source.part;
      scheme_->edge_rule(n, *features_, out);
      break;
    }
    case ChildVertex::Kind::face: {
      const FaceId f(source.from);
      const FaceNeighbourhood n = is_wide() ? walk.wide_face(f) : walk.face(f);
      scheme_->face_rule(n, *features_, out);
      if (features_->sector_stencils) flatten_face(n, out);
      break;
    }
    case ChildVertex::Kind::corner: {
      const HalfedgeId h(source.from);
      const FaceNeighbourhood n = walk.face(parent_->face(h));
      return scheme_->corner_rule(n, parent_->corner_index(h), *features_, out);
    }
  }
  if (open_net_) open_net_->resolve(out);
}

template <class Value>
Value RefinementStep::face_point(FaceId f, std::span<const Value> coarse,
                                 std::span<const Value> face_points) const {
  if (!features_->sector_stencils) return face_points[static_cast<std::size_t>(f.value)];
  const auto corners = parent_->topology().face(f);
  Value sum = coarse[static_cast<std::size_t>(corners[0].value)];
  for (const VertexId v : corners.subspan(1))
    sum = sum + coarse[static_cast<std::size_t>(v.value)];
  return sum / static_cast<double>(corners.size());
}

template <class Value>
void RefinementStep::apply_values(std::span<const Value> coarse, std::span<Value> fine) const {
  LIMES_ASSERT(static_cast<int>(coarse.size()) == parent_->topology().num_vertices());
  LIMES_ASSERT(static_cast<int>(fine.size()) == num_child_vertices());
  const int first_face = first_face_point().value;
  const auto old_value = [&](std::int32_t v) { return coarse[static_cast<std::size_t>(v)]; };
  const std::span<const Value> face_points = fine.subspan(static_cast<std::size_t>(first_face));
  const auto face_value = [&](std::int32_t f) -> Value {
    return face_point<Value>(FaceId(f), coarse, face_points);
  };
  const auto run = [&](int first, int last) {
    for_each_block(last - first, 512, [&](std::int64_t begin, std::int64_t end) {
      check_interrupt();
      NeighbourhoodWalk own_walk = walk();
      Stencil row;
      for (std::int64_t i = first + begin; i < first + end; ++i) {
        stencil(own_walk, VertexId(i), row);
        fine[static_cast<std::size_t>(i)] = apply_stencil<Value>(row, old_value, face_value);
      }
    });
  };
  run(first_face, num_child_vertices());  // the other rules read them
  run(0, first_face);
}

void RefinementStep::apply(std::span<const double> coarse, std::span<double> fine) const {
  apply_values(coarse, fine);
}
void RefinementStep::apply(std::span<const Vec2> coarse, std::span<Vec2> fine) const {
  apply_values(coarse, fine);
}
void RefinementStep::apply(std::span<const Vec3> coarse, std::span<Vec3> fine) const {
  apply_values(coarse, fine);
}

std::vector<VertexId> RefinementStep::children_of(const SurroundedElements& elements) const {
  std::vector<VertexId> children;
  if (split_) {
    using Kind = ChildVertex::Kind;
    const auto has = [](const auto& sorted, auto id) {
      return std::binary_search(sorted.begin(), sorted.end(), id);
    };
    for (int i = 0; i < num_child_vertices(); ++i) {
      const ChildVertex s = source(VertexId(i));
      if ((s.kind == Kind::vertex && has(elements.vertices, VertexId(s.from))) ||
          (s.kind == Kind::edge && has(elements.edges, EdgeId(s.from))) ||
          (s.kind == Kind::face && has(elements.faces, FaceId(s.from))) ||
          (s.kind == Kind::corner && has(elements.faces, parent_->face(HalfedgeId(s.from)))))
        children.push_back(VertexId(i));
    }
    return children;
  }
  const QuadrisectionIds ids = quadrisection_ids(*parent_);
  for (const VertexId v : elements.vertices)
    children.push_back(ids.of_vertex(v));
  for (const EdgeId e : elements.edges)
    children.push_back(ids.of_edge(e));
  if (scheme_->split == Split::quads)
    for (const FaceId f : elements.faces)
      children.push_back(ids.of_face(f));
  std::sort(children.begin(), children.end());
  return children;
}

std::vector<VertexId> RefinementStep::update(std::span<const Vec3> coarse,
                                             std::span<const VertexId> changed,
                                             std::span<Vec3> fine) const {
  // Rules reach no farther than the faces around a vertex, wide ones one ring more; what is
  // extrapolated there depends on one more again.
  SurroundedElements around = surrounded_by(*parent_, changed);
  if (is_wide()) around = surrounded_by(*parent_, around.vertices);
  if (open_net_) around = surrounded_by(*parent_, around.vertices);
  std::vector<VertexId> renewed = children_of(around);

  const VertexId first_face = first_face_point();
  const auto old_value = [&](std::int32_t v) { return coarse[static_cast<std::size_t>(v)]; };
  const std::span<const Vec3> face_points =
      fine.subspan(static_cast<std::size_t>(first_face.value));
  const auto face_value = [&](std::int32_t f) -> Vec3 {
    return face_point<Vec3>(FaceId(f), coarse, face_points);
  };
  NeighbourhoodWalk own_walk = walk();
  Stencil row;
  const auto renew = [&](auto begin, auto end) {
    for (auto v = begin; v != end; ++v) {
      stencil(own_walk, *v, row);
      fine[static_cast<std::size_t>(v->value)] = apply_stencil<Vec3>(row, old_value, face_value);
    }
  };
  const auto faces = std::lower_bound(renewed.begin(), renewed.end(), first_face);
  renew(faces, renewed.end());
  renew(renewed.begin(), faces);
  return renewed;
}

SparseMatrix RefinementStep::matrix() const {
  std::vector<Triplet> entries;
  Stencil row;
  NeighbourhoodWalk own_walk = walk();
  for (int i = 0; i < num_child_vertices(); ++i) {
    stencil(own_walk, VertexId(i), row);
    append_stencil_row(i, row, parent_->topology(), entries);
  }
  SparseMatrix S(num_child_vertices(), parent_->topology().num_vertices());
  S.setFromTriplets(entries.begin(), entries.end());
  return S;
}

}  // namespace limes
