#include "limes/spectrum/rule_site.h"

#include <algorithm>

#include "limes/subdiv/bisect.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

std::vector<ChildVertex> quadrisection_sources(const Adjacency& parent, int num_children) {
  using Kind = ChildVertex::Kind;
  std::vector<ChildVertex> sources;
  const QuadrisectionIds ids = quadrisection_ids(parent);
  for (int v = 0; v < ids.num_vertices; ++v)
    sources.push_back({Kind::vertex, 0, v});
  for (int e = 0; e < ids.num_edges; ++e)
    sources.push_back({Kind::edge, 0, e});
  for (int f = 0; static_cast<int>(sources.size()) < num_children; ++f)
    sources.push_back({Kind::face, 0, f});
  return sources;
}

}  // namespace

RuleSite::RuleSite(const Scheme& scheme, const Lattice& lattice, double tension, int step)
    : topology_(lattice.mesh.topology), points_(lattice.mesh.points.vector()) {
  // The pattern of quasi-four-eight, where it repeats, is that of four-eight.
  const Scheme& before = scheme.needs_positions ? find_scheme("four-eight") : scheme;
  Features features =
      control_features(Adjacency(topology_), lattice.mesh, before, {.tension = tension});
  for (int i = 0; i < step; ++i) {
    const Adjacency parent(topology_);
    const RefinementStep refinement(parent, features, before);
    std::vector<Vec3> fine(static_cast<std::size_t>(refinement.num_child_vertices()));
    refinement.apply(points_, fine);
    features = refinement.child_features();
    Topology child = refinement.child_topology();
    topology_ = std::move(child);
    points_ = std::move(fine);
  }
  adjacency_ = std::make_unique<const Adjacency>(topology_, Adjacency::Check::edges);
  scheme.needs_positions ? bisect_and_smooth(scheme) : make_step(scheme, features);
}

RuleSite::RuleSite(const Scheme& scheme, const Star& star)
    : topology_(star.topology), points_(star.points) {
  adjacency_ = std::make_unique<const Adjacency>(topology_, Adjacency::Check::edges);
  Features features;
  static_cast<RuleOptions&>(features) = star.options;
  scheme.needs_positions ? bisect_and_smooth(scheme) : make_step(scheme, features);
}

void RuleSite::make_step(const Scheme& scheme, const Features& features) {
  const RefinementStep step(*adjacency_, features, scheme);
  matrix_ = step.matrix();
  sources_ = is_quadrisection(scheme.split)
                 ? quadrisection_sources(*adjacency_, step.num_child_vertices())
                 : explicit_split(*adjacency_, features, scheme.split).vertices;
}

void RuleSite::bisect_and_smooth(const Scheme& scheme) {
  Star star;
  star.topology = topology_;
  star.points = points_;
  matrix_ = refine_star(star, scheme).matrix;
  const Bisection step = bisect(*adjacency_, newest_vertex_edges(*adjacency_), FirstCorner::newest);
  sources_.resize(static_cast<std::size_t>(step.child.num_vertices()));
  for (int v = 0; v < topology_.num_vertices(); ++v)
    sources_[static_cast<std::size_t>(v)] = {ChildVertex::Kind::vertex, 0, v};
  for (int e = 0; e < adjacency_->num_edges(); ++e)
    if (const VertexId middle = step.middle[EdgeId(e)]; middle.valid())
      sources_[to_index(middle)] = {ChildVertex::Kind::edge, 0, e};
}

std::vector<VertexId> RuleSite::children_around(VertexId v) const {
  std::vector<HalfedgeId> out;
  for (HalfedgeId h = adjacency_->ring_start(v); h.valid();) {
    out.push_back(h);
    h = adjacency_->ring_next(h);
    if (h == adjacency_->ring_start(v)) break;
  }
  const auto is_around = [&](const ChildVertex& c) {
    if (c.kind == ChildVertex::Kind::vertex) return c.from == v.value;
    if (c.kind == ChildVertex::Kind::edge) {
      const HalfedgeId h = adjacency_->halfedge(EdgeId(c.from));
      return adjacency_->from(h) == v || adjacency_->to(h) == v;
    }
    return std::any_of(out.begin(), out.end(), [&](HalfedgeId h) {
      return c.kind == ChildVertex::Kind::corner ? c.from == h.value
                                                 : c.from == adjacency_->face(h).value;
    });
  };
  std::vector<VertexId> children;
  for (std::size_t i = 0; i < sources_.size(); ++i)
    if (is_around(sources_[i])) children.push_back(VertexId(static_cast<int>(i)));
  return children;
}

std::vector<VertexId> RuleSite::children_in(FaceId f) const {
  std::vector<VertexId> children;
  const HalfedgeId first = topology_.halfedge(f, 0);
  for (std::size_t i = 0; i < sources_.size(); ++i)
    for (int k = 0; k < topology_.face_size(f); ++k) {
      const HalfedgeId h(first.value + k);
      const ChildVertex& c = sources_[i];
      if ((c.kind == ChildVertex::Kind::corner && c.from == h.value) ||
          (c.kind == ChildVertex::Kind::edge && c.from == adjacency_->edge(h).value))
        children.push_back(VertexId(static_cast<int>(i)));
    }
  return children;
}

std::vector<VertexId> RuleSite::element(VertexId child) const {
  const ChildVertex& c = source(child);
  switch (c.kind) {
    case ChildVertex::Kind::vertex:
      return {VertexId(c.from)};
    case ChildVertex::Kind::edge: {
      const HalfedgeId h = adjacency_->halfedge(EdgeId(c.from));
      return {adjacency_->from(h), adjacency_->to(h)};
    }
    case ChildVertex::Kind::face: {
      const auto face = topology_.face(FaceId(c.from));
      return {face.begin(), face.end()};
    }
    case ChildVertex::Kind::corner:
      return {adjacency_->from(HalfedgeId(c.from))};
  }
  return {};
}

Vec2 RuleSite::child_point(VertexId child) const {
  Vec2 x = Vec2::Zero();
  for (SparseMatrix::InnerIterator entry(matrix_, child.value); entry; ++entry)
    x += entry.value() * point(VertexId(static_cast<int>(entry.col())));
  return x;
}

}  // namespace limes
