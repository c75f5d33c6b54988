#include "limes/subdiv/corner_rings.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/crease.h"

namespace limes {

/// Points of one ring while it is refined. Local vertices are the ring's vertex 0, the ends 1 + k of
/// its edges, and the far corners 1 + num_edges + i of its faces if they are quads.
struct CornerRings::Workspace {
  std::vector<Point4> vertices, faces, fine;
  RingPattern pattern;  // and rules, of a ring that does not share its rules
  RingRules rules;

  Point4 value(const Stencil& stencil) const {
    return apply_stencil<Point4>(
        stencil, [&](int v) { return vertices[static_cast<std::size_t>(v)]; },
        [&](int f) { return faces[static_cast<std::size_t>(f)]; });
  }
};

CornerRings::CornerRings(const Adjacency& adjacency, const Features& features, const Scheme& scheme,
                         int num_steps)
    : adjacency_(&adjacency),
      scheme_(&scheme),
      triangles_(scheme.split == Split::triangles),
      options_(features),
      num_steps_(num_steps),
      ring_of_(static_cast<std::size_t>(adjacency.topology().num_vertices()), -1),
      rules_(scheme, features) {
  LIMES_ASSERT(features.crease_method == CreaseMethod::uniform ||
               std::all_of(features.edges.begin(), features.edges.end(),
                           [](const SharpEdge& e) { return is_infinite(e.sharpness); }));
  if (!triangles_) masks_ = regular_masks(scheme).value();
  const Sharpness sharpness(adjacency, features);
  const int num_vertices = adjacency.topology().num_vertices();
  IdArray<VertexId, char> irregular(static_cast<std::size_t>(num_vertices));
  for_each_index(num_vertices, [&](std::int64_t v) {
    irregular[VertexId(v)] = is_regular(VertexId(v), sharpness) ? 0 : 1;
  });
  for (int v = 0; v < num_vertices; ++v)
    if (irregular[VertexId(v)] != 0) add(VertexId(v), sharpness);
}

bool CornerRings::is_regular(VertexId v, const Sharpness& sharpness) const {
  const HalfedgeId start = adjacency_->ring_start(v);
  if (!start.valid()) return true;  // no faces, no ring
  if (is_sharp(sharpness.vertex(v))) return false;
  const int valence = triangles_ ? 6 : 4;
  int faces = 0;
  for (HalfedgeId h = start; h.valid();) {
    if (++faces > valence || is_sharp(sharpness.edge(adjacency_->edge(h)))) return false;
    h = adjacency_->ring_next(h);
    if (h == start) return faces == valence;
  }
  return false;  // on the boundary
}

void CornerRings::add(VertexId v, const Sharpness& sharpness) {
  const int num_faces = adjacency_->num_ring_faces(v);
  const int num_edges = num_faces + (adjacency_->is_boundary(v) ? 1 : 0);
  const std::size_t first_edge = edge_sharpness_.size();
  HalfedgeId h = adjacency_->ring_start(v);
  for (int i = 0; i < num_faces; ++i, h = adjacency_->ring_next(h)) {
    edge_sharpness_.push_back(sharpness.edge(adjacency_->edge(h)));
    if (i + 1 == num_faces && num_edges > num_faces)
      edge_sharpness_.push_back(sharpness.edge(adjacency_->edge(adjacency_->prev(h))));
  }
  ring_of_[v] = size();
  Ring ring{v, sharpness.vertex(v), num_edges, num_faces, first_edge, points_.size(), nullptr};
  ring.rules = rules_.find(pattern(ring), num_steps_);
  rings_.push_back(ring);
  points_.resize(points_.size() + static_cast<std::size_t>((num_steps_ - 1) * (num_edges + 1)));
}

RingPattern CornerRings::pattern(const Ring& ring) const {
  const auto first = edge_sharpness_.begin() + static_cast<std::ptrdiff_t>(ring.first_edge);
  return {ring.num_faces, ring.sharpness, {first, first + ring.num_edges}};
}

void CornerRings::load(const Ring& ring, std::span<const Vec3> control, Workspace& w) const {
  const auto edges = static_cast<std::size_t>(ring.num_edges);
  const auto faces = static_cast<std::size_t>(ring.num_faces);
  const auto at = [&](VertexId v) { return Point4(control[static_cast<std::size_t>(v.value)]); };
  w.vertices.resize(1 + edges + (triangles_ ? 0 : faces));
  w.fine.resize(w.vertices.size());
  w.faces.resize(faces);
  w.vertices[0] = at(ring.vertex);
  HalfedgeId h = adjacency_->ring_start(ring.vertex);
  for (std::size_t i = 0; i < faces; ++i, h = adjacency_->ring_next(h)) {
    const HalfedgeId out = adjacency_->next(h);
    w.vertices[1 + i] = at(adjacency_->from(out));
    if (!triangles_) w.vertices[1 + edges + i] = at(adjacency_->to(out));
    if (i + 1 == faces && edges > faces)
      w.vertices[1 + edges - 1] = at(adjacency_->from(adjacency_->prev(h)));
  }
}

void CornerRings::advance(const Ring& ring, const RingRules& rules, Workspace& w) const {
  const auto edges = static_cast<std::size_t>(ring.num_edges);
  const auto faces = static_cast<std::size_t>(ring.num_faces);
  const std::vector<Point4>& v = w.vertices;
  for (std::size_t i = 0; i < faces && !triangles_; ++i) {
    const std::size_t next = i + 1 == edges ? 0 : i + 1;
    w.faces[i] = masks_.face * ((v[0] + v[1 + edges + i]) + (v[1 + i] + v[1 + next]));
    w.fine[1 + edges + i] = w.faces[i];
  }
  for (std::size_t k = 0; k < edges; ++k)
    w.fine[1 + k] = w.value(rules.edges[k]);
  w.fine[0] = w.value(rules.vertex);
  std::swap(w.vertices, w.fine);
}

void CornerRings::refine(int ring, std::span<const Vec3> control, Vec3& fine) {
  thread_local Workspace w;  // kept, so that repeated calls take no memory
  const Ring& r = get(ring);
  load(r, control, w);
  const RingRulesCache::Entry* shared = r.rules;
  if (!shared) w.pattern = pattern(r);
  for (int step = 1; step <= num_steps_; ++step) {
    if (shared) {
      advance(r, shared->rules, w);
      shared = shared->next;
    } else {
      write_ring_rules(*scheme_, options_, w.pattern, w.rules);
      advance(r, w.rules, w);
      w.pattern = decayed(options_.crease_method, w.pattern);
    }
    if (step == num_steps_) break;
    Point4* out =
        &points_[r.first_point + static_cast<std::size_t>((step - 1) * (r.num_edges + 1))];
    std::copy(w.vertices.begin(), w.vertices.begin() + 1 + r.num_edges, out);
  }
  w.vertices[0].store(fine);
}

}  // namespace limes
