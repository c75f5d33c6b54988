#include "limes/limit/box_spline_patch.h"

#include <array>

#include "limes/limit/ring_view.h"
#include "limes/math/box_spline.h"

namespace limes {
namespace {

/// Row of the point (i, j) in the frame that begins at corner c of the triangle.
int turned_row(int c, int i, int j) {
  switch (c) {
    case 0:
      return box_spline_index(i, j);
    case 1:
      return box_spline_index(1 - i - j, i);
    default:
      return box_spline_index(j, 1 - i - j);
  }
}

class BoxSplinePatch {
 public:
  explicit BoxSplinePatch(const Ring& ring)
      : view_(ring), adjacency_(view_.adjacency()), grid_(PatchGrid::Zero(12, ring.num_controls)) {}

  std::optional<PatchGrid> build() {
    for (int c = 0; c < 3; ++c)
      if (!add_corner(c)) return {};
    return grid_;
  }

 private:
  /// The point at corner c, and its neighbour in direction k, counter-clockwise from corner c + 1.
  auto row(int c) { return grid_.row(turned_row(c, 0, 0)); }
  auto row(int c, int k) {
    constexpr std::array<std::array<int, 2>, 6> directions{
        {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
    const auto [i, j] = directions[static_cast<std::size_t>((k + 12) % 6)];
    return grid_.row(turned_row(c, i, j));
  }
  template <class Row>
  static void set(Row row, VertexId v) {
    row.setZero();
    row(v.value) = 1.0;
  }

  /// Writes corner c and its neighbours; false if the limit there is not one polynomial.
  bool add_corner(int c) {
    const HalfedgeId out = view_.side(c);
    const VertexId v = adjacency_.from(out);
    const float vertex_sharpness = view_.sharpness().vertex(v);
    const RingView::SharpCount count = view_.count_sharp(v);
    set(row(c), v);
    if (count.sharp == 0) return !is_sharp(vertex_sharpness) && add_interior(c, out);
    if (view_.is_infinitely_sharp(out) && view_.is_infinitely_sharp(view_.side(c + 2))) {
      add_lone_corner(c, out);
      return is_infinite(vertex_sharpness) || count.infinite > 2;
    }
    if (is_sharp(vertex_sharpness) || count.sharp != 2 || count.infinite != 2) return false;
    return add_beside_crease(c, out);
  }

  bool add_interior(int c, HalfedgeId out) {
    if (adjacency_.num_ring_faces(adjacency_.from(out)) != 6) return false;
    for (int k = 0; k < 6; ++k, out = adjacency_.ring_next(out))
      set(row(c, k), adjacency_.to(out));
    return true;
  }

  /// Three faces between sharp edges, then a point beyond each of the two edges.
  bool add_beside_crease(int c, HalfedgeId h) {
    int first = 0;
    for (; !view_.is_infinitely_sharp(h); h = adjacency_.next(adjacency_.twin(h)))
      if (--first < -2) return false;
    for (int k = first; k < first + 3; ++k) {
      if (k > first) {
        h = adjacency_.ring_next(h);
        if (!h.valid() || view_.is_infinitely_sharp(h)) return false;
      }
      set(row(c, k), adjacency_.to(h));
    }
    const HalfedgeId last = adjacency_.prev(h);
    if (!view_.is_infinitely_sharp(last)) return false;
    set(row(c, first + 3), adjacency_.from(last));
    row(c, first - 1) = row(c) + row(c, first) - row(c, first + 1);
    row(c, first + 4) = row(c) + row(c, first + 3) - row(c, first + 2);
    return true;
  }

  void add_lone_corner(int c, HalfedgeId out) {
    set(row(c, 0), adjacency_.to(out));
    set(row(c, 1), adjacency_.from(adjacency_.prev(out)));
    row(c, 2) = row(c) + row(c, 1) - row(c, 0);
    row(c, 3) = 2.0 * row(c) - row(c, 0);
    row(c, 4) = 2.0 * row(c) - row(c, 1);
    row(c, 5) = row(c) + row(c, 0) - row(c, 1);
  }

  RingView view_;
  const Adjacency& adjacency_;
  PatchGrid grid_;
};

}  // namespace

std::optional<PatchGrid> box_spline_patch(const Ring& ring) {
  return BoxSplinePatch(ring).build();
}

}  // namespace limes
