#include "limes/subdiv/refinement_step.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/split.h"
#include "limes/subdiv/surroundings.h"

namespace limes {
namespace {

void require_faces(const Topology& topology, const Scheme& scheme) {
  if (scheme.faces == FaceKind::polygons) return;
  const int wanted = scheme.faces == FaceKind::quads ? 4 : 3;
  for (int f = 0; f < topology.num_faces(); ++f)
    if (topology.face_size(FaceId(f)) != wanted)
      throw InputError("face {} has {} corners; {} takes faces with {} only", f,
                       topology.face_size(FaceId(f)), scheme.name, wanted);
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
  require_faces(parent.topology(), scheme);
}

int RefinementStep::num_child_vertices() const {
  return static_cast<int>(num_split_vertices(*parent_, scheme_->split));
}

int RefinementStep::num_child_faces() const {
  return static_cast<int>(num_split_faces(parent_->topology(), scheme_->split));
}

Topology RefinementStep::child_topology() const {
  return split_topology(*parent_, scheme_->split);
}

Features RefinementStep::child_features() const {
  return split_features(*parent_, *features_, scheme_->split);
}

void RefinementStep::face_stencil(NeighbourhoodWalk& walk, FaceId f, Stencil& out) const {
  out.clear();
  scheme_->face_rule(walk.face(f), out);
}

void RefinementStep::edge_stencil(NeighbourhoodWalk& walk, EdgeId e, Stencil& out) const {
  out.clear();
  scheme_->edge_rule(walk.edge(e), *features_, out);
}

void RefinementStep::vertex_stencil(NeighbourhoodWalk& walk, VertexId v, Stencil& out) const {
  out.clear();
  if (parent_->ring_start(v).valid())
    scheme_->vertex_rule(walk.vertex(v), out);
  else
    out.add(1.0, v);
}

template <class Value>
void RefinementStep::apply_values(std::span<const Value> coarse, std::span<Value> fine) const {
  const Topology& topology = parent_->topology();
  LIMES_ASSERT(static_cast<int>(coarse.size()) == topology.num_vertices());
  LIMES_ASSERT(static_cast<int>(fine.size()) == num_child_vertices());
  const QuadrisectionIds ids = quadrisection_ids(*parent_);
  const auto old_value = [&](std::int32_t v) { return coarse[static_cast<std::size_t>(v)]; };
  const auto slot = [&](VertexId v) -> Value& { return fine[static_cast<std::size_t>(v.value)]; };
  const auto face_value = [&](std::int32_t f) { return slot(ids.of_face(FaceId(f))); };

  // Face points first: the other rules read them.
  const auto run = [&](int count, const auto& write) {
    for_each_block(count, 512, [&](std::int64_t begin, std::int64_t end) {
      check_interrupt();
      NeighbourhoodWalk own_walk = walk();
      Stencil stencil;
      for (std::int64_t i = begin; i < end; ++i) {
        const VertexId target = write(own_walk, i, stencil);
        slot(target) = apply_stencil<Value>(stencil, old_value, face_value);
      }
    });
  };
  run(num_face_points(), [&](NeighbourhoodWalk& w, std::int64_t i, Stencil& s) {
    face_stencil(w, FaceId(i), s);
    return ids.of_face(FaceId(i));
  });
  run(parent_->num_edges(), [&](NeighbourhoodWalk& w, std::int64_t i, Stencil& s) {
    edge_stencil(w, EdgeId(i), s);
    return ids.of_edge(EdgeId(i));
  });
  run(topology.num_vertices(), [&](NeighbourhoodWalk& w, std::int64_t i, Stencil& s) {
    vertex_stencil(w, VertexId(i), s);
    return ids.of_vertex(VertexId(i));
  });
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

std::vector<VertexId> RefinementStep::update(std::span<const Vec3> coarse,
                                             std::span<const VertexId> changed,
                                             std::span<Vec3> fine) const {
  const QuadrisectionIds ids = quadrisection_ids(*parent_);
  const auto old_value = [&](std::int32_t v) { return coarse[static_cast<std::size_t>(v)]; };
  const auto slot = [&](VertexId v) -> Vec3& { return fine[static_cast<std::size_t>(v.value)]; };
  const auto face_value = [&](std::int32_t f) { return slot(ids.of_face(FaceId(f))); };
  NeighbourhoodWalk own_walk = walk();
  Stencil stencil;
  std::vector<VertexId> renewed;
  const auto renew = [&](VertexId v) {
    slot(v) = apply_stencil<Vec3>(stencil, old_value, face_value);
    renewed.push_back(v);
  };

  // No rule reaches farther than the faces around a vertex.
  const SurroundedElements around = surrounded_by(*parent_, changed);
  for (const FaceId f : num_face_points() > 0 ? around.faces : std::vector<FaceId>()) {
    face_stencil(own_walk, f, stencil);
    renew(ids.of_face(f));
  }
  for (const EdgeId e : around.edges) {
    edge_stencil(own_walk, e, stencil);
    renew(ids.of_edge(e));
  }
  for (const VertexId v : around.vertices) {
    vertex_stencil(own_walk, v, stencil);
    renew(ids.of_vertex(v));
  }
  std::sort(renewed.begin(), renewed.end());
  return renewed;
}

SparseMatrix RefinementStep::matrix() const {
  const Topology& topology = parent_->topology();
  const QuadrisectionIds ids = quadrisection_ids(*parent_);
  std::vector<Triplet> entries;
  Stencil stencil;
  NeighbourhoodWalk own_walk = walk();
  for (int v = 0; v < topology.num_vertices(); ++v) {
    vertex_stencil(own_walk, VertexId(v), stencil);
    append_stencil_row(ids.of_vertex(VertexId(v)).value, stencil, topology, entries);
  }
  for (int e = 0; e < parent_->num_edges(); ++e) {
    edge_stencil(own_walk, EdgeId(e), stencil);
    append_stencil_row(ids.of_edge(EdgeId(e)).value, stencil, topology, entries);
  }
  for (int f = 0; f < num_face_points(); ++f) {
    face_stencil(own_walk, FaceId(f), stencil);
    append_stencil_row(ids.of_face(FaceId(f)).value, stencil, topology, entries);
  }
  SparseMatrix S(num_child_vertices(), topology.num_vertices());
  S.setFromTriplets(entries.begin(), entries.end());
  return S;
}

}  // namespace limes
