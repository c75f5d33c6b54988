#include "limes/space/boundary_types.h"

#include <algorithm>
#include <array>

#include "limes/subdiv/crease.h"

namespace limes {
namespace {

bool all_quads_around(const Adjacency& control, VertexId v) {
  for (HalfedgeId h = control.ring_start(v); h.valid(); h = control.ring_next(h))
    if (control.topology().face_size(control.face(h)) != 4) return false;
  return true;
}

/// The largest sharpness of the edges between the two boundary edges of v.
float inner_sharpness(const Adjacency& control, const Sharpness& sharpness, HalfedgeId out) {
  float largest = 0;
  for (HalfedgeId h = control.ring_next(out); h.valid(); h = control.ring_next(h))
    largest = std::max(largest, sharpness.edge(control.edge(h)));
  return largest;
}

/// Whether the points around a sharp vertex with three faces lie as in a regular grid of which one
/// face is missing: then the regular functions, with the ghost in the fourth face, give the same
/// surface as the corner's own rules.
///
///        d2  c1  d1        v' = v and the rules of the four edges and of the fourth face must hold
///        c2  v   b         with the ghost g: second differences through v vanish, and each of the
///        d3  a   g         four faces is a parallelogram at v.
bool continues_as_grid(const Adjacency& control, HalfedgeId out, std::span<const Vec3> points) {
  const auto x = [&](VertexId v) { return points[static_cast<std::size_t>(v.value)]; };
  const HalfedgeId to_c1 = control.ring_next(out);
  const HalfedgeId to_c2 = control.ring_next(to_c1);
  const VertexId v = control.from(out);
  const Vec3 b = x(control.to(out)), c1 = x(control.to(to_c1)), c2 = x(control.to(to_c2));
  const Vec3 a = x(control.from(control.prev(to_c2)));
  const Vec3 d1 = x(control.to(control.next(out)));
  const Vec3 d2 = x(control.to(control.next(to_c1)));
  const Vec3 d3 = x(control.to(control.next(to_c2)));
  const Vec3 o = x(v);
  const double size = std::max((b - o).norm(), (a - o).norm());
  const std::array<Vec3, 5> residuals{b + c2 - 2.0 * o, a + c1 - 2.0 * o, d1 - b - c1 + o,
                                      d2 - c1 - c2 + o, d3 - c2 - a + o};
  return std::all_of(residuals.begin(), residuals.end(),
                     [&](const Vec3& r) { return r.norm() <= 1e-12 * size; });
}

}  // namespace

BoundaryTypes::BoundaryTypes(const Adjacency& control, const Sharpness& sharpness,
                             std::span<const Vec3> points) {
  collect(control);
  for (BoundaryVertex& b : vertices_) {
    b.sharpness = sharpness.vertex(b.vertex);
    b.type = type_alone(control, sharpness, b, points);
  }
  settle();
}

void BoundaryTypes::collect(const Adjacency& control) {
  IdArray<VertexId, int> index(static_cast<std::size_t>(control.topology().num_vertices()), -1);
  for (int i = 0; i < control.topology().num_vertices(); ++i) {
    const VertexId v(i);
    if (!control.is_boundary(v)) continue;
    // The ring of a boundary vertex starts with its outgoing boundary halfedge.
    const HalfedgeId out = control.ring_start(v);
    HalfedgeId last = out;
    while (control.ring_next(last).valid())
      last = control.ring_next(last);
    index[v] = static_cast<int>(vertices_.size());
    vertices_.push_back({v, control.prev(last), out});
  }
  for (const BoundaryVertex& b : vertices_) {
    previous_.push_back(index[control.from(b.in)]);
    next_.push_back(index[control.to(b.out)]);
  }
}

GhostType BoundaryTypes::type_alone(const Adjacency& control, const Sharpness& sharpness,
                                    const BoundaryVertex& b, std::span<const Vec3> points) const {
  if (!all_quads_around(control, b.vertex)) return GhostType::standard;
  const float inner = inner_sharpness(control, sharpness, b.out);
  switch (control.num_ring_faces(b.vertex)) {
    case 1:
      return is_infinite(b.sharpness) ? GhostType::corner : GhostType::standard;
    case 2:
      if (is_sharp(b.sharpness)) return GhostType::standard;
      if (!is_sharp(inner)) return GhostType::side;
      return is_infinite(inner) ? GhostType::crease_end : GhostType::standard;
    case 3:
      return is_infinite(b.sharpness) && !is_sharp(inner) &&
                     continues_as_grid(control, b.out, points)
                 ? GhostType::reentrant
                 : GhostType::standard;
    default:
      return GhostType::standard;
  }
}

bool BoundaryTypes::crease_after(int i) const {
  const int j = next(i);
  return is_standard(previous(i)) || is_standard(i) || is_standard(j) || is_standard(next(j));
}

/// A re-entrant corner shares one ghost with both neighbours, which must have one to share.
void BoundaryTypes::settle() {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
      const int i = static_cast<int>(k);
      if (vertices_[k].type != GhostType::reentrant) continue;
      const bool crowded = at(previous(i)).type == GhostType::reentrant ||
                           at(next(i)).type == GhostType::reentrant || crease_after(i) ||
                           crease_after(previous(i)) || previous(i) == next(i);
      if (!crowded) continue;
      vertices_[k].type = GhostType::standard;
      changed = true;
    }
  }
}

}  // namespace limes
