#include "limes/subdiv/neighbourhood.h"

#include <algorithm>
#include <numbers>

#include "limes/subdiv/crease.h"

namespace limes {

void NeighbourhoodWalk::collect_ring(VertexId v) {
  neighbours_.clear();
  faces_.clear();
  edges_.clear();
  const Adjacency& a = *adjacency_;
  const HalfedgeId start = a.ring_start(v);
  for (HalfedgeId h = start; h.valid();) {
    neighbours_.push_back(a.to(h));
    edges_.push_back(a.edge(h));
    faces_.push_back(a.face(h));
    const HalfedgeId in = a.prev(h);
    const HalfedgeId next = a.twin(in);
    if (!next.valid()) {
      neighbours_.push_back(a.from(in));
      edges_.push_back(a.edge(in));
    }
    if (next == start) break;
    h = next;
  }
  edge_sharpness_.clear();
  for (const EdgeId e : edges_)
    edge_sharpness_.push_back(sharpness_->edge(e));
}

void NeighbourhoodWalk::collect_child_sharpness() {
  child_edge_sharpness_.clear();
  for (std::size_t i = 0; i < edge_sharpness_.size(); ++i)
    child_edge_sharpness_.push_back(
        decayed_at_vertex(features_->crease_method, i, edge_sharpness_));
}

VertexNeighbourhood NeighbourhoodWalk::vertex(VertexId v) {
  collect_ring(v);
  collect_child_sharpness();
  const float s = sharpness_->vertex(v);
  return {v, neighbours_, faces_, s, decayed(s), edge_sharpness_, child_edge_sharpness_};
}

float NeighbourhoodWalk::child_sharpness_at_start(HalfedgeId h) {
  const EdgeId e = adjacency_->edge(h);
  const float s = sharpness_->edge(e);
  if (features_->crease_method == CreaseMethod::uniform || is_infinite(s)) return decayed(s);
  collect_ring(adjacency_->from(h));
  const auto at = std::find(edges_.begin(), edges_.end(), e);
  return decayed_at_vertex(features_->crease_method, static_cast<std::size_t>(at - edges_.begin()),
                           edge_sharpness_);
}

EdgeNeighbourhood NeighbourhoodWalk::edge(EdgeId e) {
  const Adjacency& a = *adjacency_;
  const HalfedgeId h = a.halfedge(e);
  const HalfedgeId twin = a.twin(h);
  EdgeNeighbourhood n;
  n.ends = {a.from(h), a.to(h)};
  n.num_faces = twin.valid() ? 2 : 1;
  n.faces = {a.face(h), twin.valid() ? a.face(twin) : FaceId()};
  n.face_sizes = {a.topology().face_size(n.faces[0]),
                  twin.valid() ? a.topology().face_size(n.faces[1]) : 0};
  if (n.face_sizes[0] == 3) n.opposite[0] = a.from(a.prev(h));
  if (n.face_sizes[1] == 3) n.opposite[1] = a.from(a.prev(twin));
  n.sharpness = sharpness_->edge(e);
  // The other end is the start of the twin; a boundary edge has none but is infinitely sharp.
  n.child_sharp = is_sharp(n.sharpness) &&
                  (is_infinite(n.sharpness) || (is_sharp(child_sharpness_at_start(h)) &&
                                                is_sharp(child_sharpness_at_start(twin))));
  return n;
}

void NeighbourhoodWalk::collect_spokes(std::size_t i, HalfedgeId h) {
  const Adjacency& a = open_net_ ? open_net_->adjacency() : *adjacency_;
  const VertexId centre = a.from(h);
  if (spoke_ids_.size() <= i) {
    spoke_ids_.resize(i + 1);
    spokes_.resize(i + 1);
  }
  SpokeIds& ids = spoke_ids_[i];
  ids.ends.clear();
  ids.diagonals.clear();
  const HalfedgeId start = a.ring_start(centre);
  int first = 0;
  for (HalfedgeId out = start; out.valid();) {
    if (out == h) first = static_cast<int>(ids.ends.size());
    ids.ends.push_back(a.to(out));
    ids.diagonals.push_back(a.to(a.next(out)));
    const HalfedgeId in = a.prev(out);
    out = a.twin(in);
    if (!out.valid()) ids.ends.push_back(a.from(in));
    if (out == start) break;
  }
  // Corners count on the boundary alone; an open net has copies there that the features do not know.
  const bool boundary = a.is_boundary(centre);
  spokes_[i] = {centre,
                boundary,
                boundary && is_infinite(sharpness_->vertex(centre)),
                boundary ? sharpness_->angle(centre) : std::numbers::pi,
                first,
                ids.ends,
                ids.diagonals};
}

FaceNeighbourhood NeighbourhoodWalk::wide_face(FaceId f) {
  FaceNeighbourhood n = face(f);
  for (std::size_t i = 0; i < n.corners.size(); ++i)
    collect_spokes(i, adjacency_->topology().halfedge(f, static_cast<int>(i)));
  n.rings = std::span<const Spokes>(spokes_).first(n.corners.size());
  if (!open_net_) return n;
  curves_.clear();
  for (std::size_t i = 0; i < n.corners.size(); ++i)
    curves_.push_back(open_net_->curve(adjacency_->topology().halfedge(f, static_cast<int>(i))));
  n.curves = curves_;
  return n;
}

EdgeNeighbourhood NeighbourhoodWalk::wide_edge(EdgeId e) {
  const HalfedgeId h = adjacency_->halfedge(e);
  EdgeNeighbourhood n = edge(e);
  if (open_net_) n.curve = open_net_->curve(h);
  if (n.curve.on_curve) return n;
  collect_spokes(0, h);
  // The edge starts at its other end with the twin; on the boundary it is the last one there.
  const HalfedgeId twin = adjacency_->twin(h);
  collect_spokes(1, twin.valid() ? twin : adjacency_->next(h));
  if (!twin.valid()) spokes_[1].first = spokes_[1].size() - 1;
  n.rings = {spokes_[0], spokes_[1]};
  return n;
}

}  // namespace limes
