#include "limes/subdiv/corner_rings.h"

#include <array>

#include "limes/core/error.h"
#include "limes/subdiv/crease.h"

namespace limes {

/// Points of one ring while it is refined. Local vertices are the ring's vertex 0, the ends 1 + k of
/// its edges, and the far corners 1 + num_edges + i of its faces.
struct CornerRings::Workspace {
  std::vector<Point4> vertices, faces, fine;
  std::vector<float> edge_sharpness, child_edge_sharpness;
  float sharpness = 0;
  std::vector<VertexId> neighbours;
  std::vector<FaceId> face_ids;
  Stencil stencil;

  Point4 value() const {
    return apply_stencil<Point4>(
        stencil, [&](int v) { return vertices[static_cast<std::size_t>(v)]; },
        [&](int f) { return faces[static_cast<std::size_t>(f)]; });
  }
};

CornerRings::CornerRings(const Adjacency& adjacency, const Features& features, const Scheme& scheme,
                         int num_steps)
    : adjacency_(&adjacency),
      scheme_(&scheme),
      crease_method_(features.crease_method),
      num_steps_(num_steps),
      ring_of_(static_cast<std::size_t>(adjacency.topology().num_vertices()), -1) {
  const Sharpness sharpness(adjacency, features);
  for (int v = 0; v < adjacency.topology().num_vertices(); ++v)
    add_if_irregular(VertexId(v), features, sharpness);
}

void CornerRings::add_if_irregular(VertexId v, const Features& features,
                                   const Sharpness& sharpness) {
  const HalfedgeId start = adjacency_->ring_start(v);
  if (!start.valid()) return;
  const int num_faces = adjacency_->num_ring_faces(v);
  const int num_edges = adjacency_->valence(v);
  const std::size_t first_edge = edge_sharpness_.size();
  bool regular = num_faces == 4 && num_edges == 4 && !is_sharp(sharpness.vertex(v));
  HalfedgeId h = start;
  for (int i = 0; i < num_faces; ++i, h = adjacency_->ring_next(h)) {
    edge_sharpness_.push_back(sharpness.edge(adjacency_->edge(h)));
    if (i + 1 == num_faces && num_edges > num_faces)
      edge_sharpness_.push_back(sharpness.edge(adjacency_->edge(adjacency_->prev(h))));
  }
  for (std::size_t k = first_edge; k < edge_sharpness_.size(); ++k) {
    const float s = edge_sharpness_[k];
    regular = regular && !is_sharp(s);
    LIMES_ASSERT(features.crease_method == CreaseMethod::uniform || !is_sharp(s) || is_infinite(s));
  }
  if (regular) {
    edge_sharpness_.resize(first_edge);
    return;
  }
  ring_of_[v] = size();
  rings_.push_back({v, sharpness.vertex(v), num_edges, num_faces, first_edge, points_.size()});
  points_.resize(points_.size() + static_cast<std::size_t>((num_steps_ - 1) * (num_edges + 1)));
}

int CornerRings::turned(int ring, int edge, int by) const {
  const Ring& r = get(ring);
  const int k = edge + by;
  if (r.num_edges > r.num_faces) return k >= 0 && k < r.num_edges ? k : -1;
  return (k % r.num_edges + r.num_edges) % r.num_edges;
}

void CornerRings::load(const Ring& ring, std::span<const Vec3> control, Workspace& w) const {
  const auto edges = static_cast<std::size_t>(ring.num_edges);
  const auto faces = static_cast<std::size_t>(ring.num_faces);
  const auto at = [&](VertexId v) { return Point4(control[static_cast<std::size_t>(v.value)]); };
  w.vertices.resize(1 + edges + faces);
  w.fine.resize(w.vertices.size());
  w.faces.resize(faces);
  w.vertices[0] = at(ring.vertex);
  HalfedgeId h = adjacency_->ring_start(ring.vertex);
  for (std::size_t i = 0; i < faces; ++i, h = adjacency_->ring_next(h)) {
    const HalfedgeId out = adjacency_->next(h);
    w.vertices[1 + i] = at(adjacency_->from(out));
    w.vertices[1 + edges + i] = at(adjacency_->to(out));
    if (i + 1 == faces && edges > faces)
      w.vertices[1 + edges - 1] = at(adjacency_->from(adjacency_->prev(h)));
  }
  w.sharpness = ring.sharpness;
  w.edge_sharpness.assign(edge_sharpness_.data() + ring.first_edge,
                          edge_sharpness_.data() + ring.first_edge + edges);
  w.child_edge_sharpness.resize(edges);
  w.neighbours.resize(edges);
  for (std::size_t k = 0; k < edges; ++k)
    w.neighbours[k] = VertexId(static_cast<std::int64_t>(1 + k));
  w.face_ids.resize(faces);
  for (std::size_t i = 0; i < faces; ++i)
    w.face_ids[i] = FaceId(static_cast<std::int64_t>(i));
}

void CornerRings::advance(const Ring& ring, Workspace& w) const {
  const int edges = ring.num_edges;
  const int faces = ring.num_faces;
  const auto slot = [](int i) { return static_cast<std::size_t>(i); };
  for (int i = 0; i < faces; ++i) {
    const std::array<VertexId, 4> corners{VertexId(0), VertexId(1 + i), VertexId(1 + edges + i),
                                          VertexId(1 + (i + 1) % edges)};
    w.stencil.clear();
    scheme_->face_rule({FaceId(i), corners, {}}, {}, w.stencil);
    w.fine[slot(1 + edges + i)] = w.value();
  }
  for (int i = 0; i < faces; ++i)
    w.faces[slot(i)] = w.fine[slot(1 + edges + i)];
  for (int k = 0; k < edges; ++k) {
    const bool boundary = edges > faces && (k == 0 || k == edges - 1);
    const float s = w.edge_sharpness[slot(k)];
    w.child_edge_sharpness[slot(k)] = decayed_at_vertex(crease_method_, slot(k), w.edge_sharpness);
    w.stencil.clear();
    scheme_->edge_rule({.ends = {VertexId(0), VertexId(1 + k)},
                        .faces = {FaceId(boundary && k > 0 ? k - 1 : k % faces),
                                  boundary ? FaceId() : FaceId((k + faces - 1) % faces)},
                        .face_sizes = {4, boundary ? 0 : 4},
                        .num_faces = boundary ? 1 : 2,
                        .opposite = {},
                        .sharpness = s,
                        .child_sharp = is_sharp(decayed(s))},
                       {}, w.stencil);
    w.fine[slot(1 + k)] = w.value();
  }
  w.stencil.clear();
  scheme_->vertex_rule({VertexId(0), w.neighbours, w.face_ids, w.sharpness, decayed(w.sharpness),
                        w.edge_sharpness, w.child_edge_sharpness},
                       {}, w.stencil);
  w.fine[0] = w.value();
  std::swap(w.vertices, w.fine);
  std::swap(w.edge_sharpness, w.child_edge_sharpness);
  w.sharpness = decayed(w.sharpness);
}

void CornerRings::refine(int ring, std::span<const Vec3> control, Vec3& fine) {
  thread_local Workspace w;  // kept, so that repeated calls take no memory
  const Ring& r = get(ring);
  load(r, control, w);
  for (int step = 1; step <= num_steps_; ++step) {
    advance(r, w);
    if (step == num_steps_) break;
    Point4* out =
        &points_[r.first_point + static_cast<std::size_t>((step - 1) * (r.num_edges + 1))];
    std::copy(w.vertices.begin(), w.vertices.begin() + 1 + r.num_edges, out);
  }
  w.vertices[0].store(fine);
}

}  // namespace limes
