#include "limes/subdiv/triangle_mesh.h"

#include <algorithm>
#include <array>

#include "limes/core/error.h"

namespace limes {

TriangleMesh::TriangleMesh(const Adjacency& start)
    : num_vertices_(start.topology().num_vertices()) {
  const Topology& topology = start.topology();
  for (int f = 0; f < topology.num_faces(); ++f)
    if (topology.face_size(FaceId(f)) != 3)
      throw InputError("face {} has {} corners; stellar operators take triangles only", f,
                       topology.face_size(FaceId(f)));
  corners_ = IdArray<HalfedgeId, VertexId>({topology.corners().begin(), topology.corners().end()});
  twins_.reserve(static_cast<std::size_t>(topology.num_corners()));
  for (int h = 0; h < topology.num_corners(); ++h)
    twins_.push_back(start.twin(HalfedgeId(h)));
}

FaceId TriangleMesh::add_face() {
  const FaceId f(num_faces());
  for (int i = 0; i < 3; ++i) {
    corners_.push_back(VertexId());
    twins_.push_back(HalfedgeId());
  }
  return f;
}

void TriangleMesh::set_face(FaceId f, VertexId a, VertexId b, VertexId c) {
  corners_[halfedge(f, 0)] = a;
  corners_[halfedge(f, 1)] = b;
  corners_[halfedge(f, 2)] = c;
}

void TriangleMesh::remove_faces(std::span<const HalfedgeId> halfedges) {
  for (const HalfedgeId h : halfedges) {
    const FaceId f = face(h);
    set_face(f, VertexId(), VertexId(), VertexId());
    for (int i = 0; i < 3; ++i)
      twins_[halfedge(f, i)] = HalfedgeId();
  }
}

void TriangleMesh::link(HalfedgeId h, HalfedgeId twin) {
  twins_[h] = twin;
  if (twin.valid()) twins_[twin] = h;
}

std::vector<HalfedgeId> TriangleMesh::ring(HalfedgeId outgoing) const {
  HalfedgeId start = outgoing;
  while (twin(start).valid()) {  // clockwise
    start = next(twin(start));
    if (start == outgoing) break;
  }
  std::vector<HalfedgeId> ring;
  for (HalfedgeId h = start; h.valid();) {
    ring.push_back(h);
    h = twin(prev(h));
    if (h == start) break;
  }
  return ring;
}

bool TriangleMesh::are_joined(VertexId other, HalfedgeId outgoing) const {
  const std::vector<HalfedgeId> around = ring(outgoing);
  return std::any_of(around.begin(), around.end(),
                     [&](HalfedgeId h) { return to(h) == other || opposite(h) == other; });
}

/// Writes (a, s, c) over the face (a, b, c) of h and (s, b, c) into `added`; the sides on a-b are
/// left to the caller.
void TriangleMesh::bisect_face(HalfedgeId h, FaceId added, VertexId middle) {
  const FaceId f = face(h);
  const VertexId a = from(h), b = to(h), c = opposite(h);
  const HalfedgeId beyond_bc = twin(next(h)), beyond_ca = twin(prev(h));
  set_face(f, a, middle, c);
  set_face(added, middle, b, c);
  link(halfedge(f, 1), halfedge(added, 2));
  link(halfedge(f, 2), beyond_ca);
  link(halfedge(added, 1), beyond_bc);
}

VertexId TriangleMesh::split_edge(HalfedgeId h) {
  const VertexId middle(num_vertices_++);
  const HalfedgeId t = twin(h);
  const FaceId f = face(h), f_added = add_face();
  bisect_face(h, f_added, middle);
  if (!t.valid()) {
    link(halfedge(f, 0), HalfedgeId());
    link(halfedge(f_added, 0), HalfedgeId());
    return middle;
  }
  const FaceId g = face(t), g_added = add_face();
  bisect_face(t, g_added, middle);
  link(halfedge(f, 0), halfedge(g_added, 0));
  link(halfedge(g, 0), halfedge(f_added, 0));
  return middle;
}

VertexId TriangleMesh::split_face(FaceId f) {
  const VertexId middle(num_vertices_++);
  const HalfedgeId h = halfedge(f, 0);
  const VertexId a = from(h), b = to(h), c = opposite(h);
  const HalfedgeId beyond_bc = twin(next(h)), beyond_ca = twin(prev(h));
  const FaceId bc = add_face(), ca = add_face();
  set_face(f, a, b, middle);
  set_face(bc, b, c, middle);
  set_face(ca, c, a, middle);
  link(halfedge(bc, 0), beyond_bc);
  link(halfedge(ca, 0), beyond_ca);
  link(halfedge(f, 1), halfedge(bc, 2));
  link(halfedge(bc, 1), halfedge(ca, 2));
  link(halfedge(ca, 1), halfedge(f, 2));
  return middle;
}

bool TriangleMesh::can_flip(HalfedgeId h) const {
  const HalfedgeId t = twin(h);
  return t.valid() && opposite(h) != opposite(t) && !are_joined(opposite(t), prev(h));
}

void TriangleMesh::flip(HalfedgeId h) {
  LIMES_ASSERT(can_flip(h));
  const HalfedgeId t = twin(h);
  const FaceId f = face(h), g = face(t);
  const VertexId a = from(h), b = to(h), c = opposite(h), d = opposite(t);
  const HalfedgeId beyond_bc = twin(next(h)), beyond_ca = twin(prev(h));
  const HalfedgeId beyond_ad = twin(next(t)), beyond_db = twin(prev(t));
  set_face(f, c, d, b);
  set_face(g, d, c, a);
  link(halfedge(f, 0), halfedge(g, 0));
  link(halfedge(f, 1), beyond_db);
  link(halfedge(f, 2), beyond_bc);
  link(halfedge(g, 1), beyond_ca);
  link(halfedge(g, 2), beyond_ad);
}

bool TriangleMesh::can_weld_edge(HalfedgeId h) const {
  // The ring of s from b: (s, b, c), (s, c, a), and on the other side (s, a, d), (s, d, b).
  const std::vector<HalfedgeId> around = ring(h);
  const bool on_boundary = !twin(around.front()).valid();
  if (around.front() != h || around.size() != (on_boundary ? 2 : 4)) return false;
  const VertexId a = opposite(around[1]);
  return !are_joined(a, next(h)) && (on_boundary || to(around[1]) != to(around[3]));
}

/// Replaces the faces (s, b, c) of `first` and (s, c, a) of `second` by (a, b, c), which is written
/// into `joined`; the side a-b is left to the caller.
void TriangleMesh::join_bisected(HalfedgeId first, HalfedgeId second, FaceId joined) {
  const VertexId a = opposite(second), b = to(first), c = to(second);
  const HalfedgeId beyond_bc = twin(next(first)), beyond_ca = twin(next(second));
  remove_faces(std::array{first, second});
  set_face(joined, a, b, c);
  link(halfedge(joined, 1), beyond_bc);
  link(halfedge(joined, 2), beyond_ca);
}

void TriangleMesh::weld_edge(HalfedgeId h) {
  LIMES_ASSERT(can_weld_edge(h));
  removed_.push_back(from(h));
  const std::vector<HalfedgeId> around = ring(h);
  const FaceId here = std::min(face(around[0]), face(around[1]));
  join_bisected(around[0], around[1], here);
  if (around.size() == 2) return;
  const FaceId there = std::min(face(around[2]), face(around[3]));
  join_bisected(around[2], around[3], there);
  link(halfedge(here, 0), halfedge(there, 0));
}

bool TriangleMesh::can_weld_face(HalfedgeId h) const {
  const std::vector<HalfedgeId> around = ring(h);
  return around.size() == 3 && twin(around.front()).valid();
}

void TriangleMesh::weld_face(HalfedgeId h) {
  LIMES_ASSERT(can_weld_face(h));
  removed_.push_back(from(h));
  const std::vector<HalfedgeId> around = ring(h);
  std::array<VertexId, 3> corners;
  std::array<HalfedgeId, 3> beyond;
  FaceId kept = face(h);
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = to(around[i]);
    beyond[i] = twin(next(around[i]));
    kept = std::min(kept, face(around[i]));
  }
  remove_faces(around);
  set_face(kept, corners[0], corners[1], corners[2]);
  for (int i = 0; i < 3; ++i)
    link(halfedge(kept, i), beyond[static_cast<std::size_t>(i)]);
}

Topology TriangleMesh::topology() const {
  std::vector<VertexId> removed = removed_;
  std::sort(removed.begin(), removed.end());
  const auto number = [&](VertexId v) {
    const auto gaps = std::lower_bound(removed.begin(), removed.end(), v) - removed.begin();
    return VertexId(v.value - gaps);
  };
  std::vector<VertexId> corners;
  corners.reserve(corners_.vector().size());
  for (const VertexId v : corners_)
    if (v.valid()) corners.push_back(number(v));
  return {num_vertices_ - static_cast<int>(removed.size()), 3, std::move(corners)};
}

}  // namespace limes
