#include "limes/limit/regular_patch.h"

#include <array>

#include "limes/limit/box_spline_patch.h"
#include "limes/limit/ring_view.h"

namespace limes {
namespace {

int row_of(int i, int j) {
  return 4 * j + i;
}

/// The bilinear patch of a quad, written as a bicubic one: cubic B-splines reproduce linear
/// functions from their values at the control abscissae -1, 0, 1, 2.
PatchGrid bilinear_patch(const Ring& ring) {
  PatchGrid grid = PatchGrid::Zero(16, ring.num_controls);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const double u = i - 1.0;
      const double v = j - 1.0;
      grid(row_of(i, j), 0) = (1 - u) * (1 - v);
      grid(row_of(i, j), 1) = u * (1 - v);
      grid(row_of(i, j), 2) = u * v;
      grid(row_of(i, j), 3) = (1 - u) * v;
    }
  }
  return grid;
}

/// Grid position (i, j) as seen from corner 0, for the frame in which corner c is the origin.
std::array<int, 2> turned(int c, int i, int j) {
  switch (c) {
    case 0:
      return {i, j};
    case 1:
      return {3 - j, i};
    case 2:
      return {3 - i, 3 - j};
    default:
      return {j, 3 - i};
  }
}

class BicubicPatch {
 public:
  explicit BicubicPatch(const Ring& ring)
      : view_(ring), adjacency_(view_.adjacency()), grid_(PatchGrid::Zero(16, ring.num_controls)) {}

  std::optional<PatchGrid> build() {
    const Topology& topology = view_.ring().topology;
    for (int f = 0; f < topology.num_faces(); ++f)
      if (topology.face_size(FaceId(f)) != 4) return {};
    for (int c = 0; c < 4; ++c)
      if (!add_corner(c)) return {};
    add_phantoms();
    return grid_;
  }

 private:
  [[nodiscard]] HalfedgeId side(int c) const { return view_.side(c); }
  [[nodiscard]] bool sharp_side(int c) const { return view_.is_infinitely_sharp(side(c)); }

  void set(int c, int i, int j, VertexId v) {
    const auto [a, b] = turned(c, i, j);
    grid_.row(row_of(a, b)).setZero();
    grid_(row_of(a, b), v.value) = 1.0;
  }

  /// Writes corner c and the points beyond it; false if the limit there is not one polynomial.
  bool add_corner(int c) {
    const HalfedgeId out = side(c);
    const VertexId v = adjacency_.from(out);
    const float vertex_sharpness = view_.sharpness().vertex(v);
    const RingView::SharpCount count = view_.count_sharp(v);
    set(c, 1, 1, v);
    if (count.sharp == 0) return !is_sharp(vertex_sharpness) && add_interior(c, out);
    const bool next_sharp = sharp_side(c);      // the side along u
    const bool prev_sharp = sharp_side(c + 3);  // the side along v
    if (next_sharp && prev_sharp) return is_infinite(vertex_sharpness) || count.infinite > 2;
    if (is_sharp(vertex_sharpness) || count.sharp != 2 || count.infinite != 2) return false;
    return next_sharp ? add_beside_left(c) : prev_sharp && add_beside_below(c);
  }

  /// Valence 4: the three other faces, counter-clockwise.
  bool add_interior(int c, HalfedgeId out) {
    if (adjacency_.is_boundary(adjacency_.from(out)) ||
        adjacency_.num_ring_faces(adjacency_.from(out)) != 4)
      return false;
    const HalfedgeId left = adjacency_.ring_next(out);
    const HalfedgeId below = adjacency_.ring_next(left);
    set(c, 0, 1, adjacency_.to(below));
    set(c, 0, 0, adjacency_.to(adjacency_.next(below)));
    set(c, 1, 0, adjacency_.to(adjacency_.ring_next(below)));
    return true;
  }

  /// Crease along u: the face to the left must end at the crease again.
  bool add_beside_left(int c) {
    const HalfedgeId left = adjacency_.ring_next(side(c));
    if (!left.valid()) return false;
    const HalfedgeId in = adjacency_.prev(left);
    if (!view_.is_infinitely_sharp(in)) return false;
    set(c, 0, 1, adjacency_.from(in));
    set(c, 0, 2, adjacency_.from(adjacency_.prev(in)));
    return true;
  }

  /// Crease along v: the face below must end at the crease again.
  bool add_beside_below(int c) {
    const HalfedgeId twin = adjacency_.twin(side(c));
    if (!twin.valid()) return false;
    const HalfedgeId out = adjacency_.next(twin);
    if (!view_.is_infinitely_sharp(out)) return false;
    set(c, 1, 0, adjacency_.to(out));
    set(c, 2, 0, adjacency_.to(adjacency_.next(out)));
    return true;
  }

  /// Beyond a sharp side: 2 b - c, first beside the face, then at the outer corners.
  void add_phantoms() {
    for (int c = 0; c < 4; ++c)
      if (sharp_side(c))
        for (int i = 1; i <= 2; ++i)
          extrapolate(c, i);
    for (int c = 0; c < 4; ++c) {
      if (!sharp_side(c)) continue;
      extrapolate(c, 0);
      extrapolate(c, 3);
    }
  }
  void extrapolate(int c, int i) {
    const auto row = [&](int j) {
      const auto [a, b] = turned(c, i, j);
      return row_of(a, b);
    };
    grid_.row(row(0)) = 2.0 * grid_.row(row(1)) - grid_.row(row(2));
  }

  RingView view_;
  const Adjacency& adjacency_;
  PatchGrid grid_;
};

}  // namespace

std::optional<PatchGrid> regular_patch(const Ring& ring, LimitPatch patch) {
  if (patch == LimitPatch::none) return {};
  if (patch == LimitPatch::box_spline) return box_spline_patch(ring);
  if (ring.topology.face_size(FaceId(0)) != 4) return {};
  if (patch == LimitPatch::bilinear) return bilinear_patch(ring);
  return BicubicPatch(ring).build();
}

}  // namespace limes
