#include "limes/subdiv/structured_triangles.h"
#include "limes/subdiv/triangle_sides.h"

namespace limes {
namespace {

int offset_of(GridPoint p) {
  return p.j * TriangleGrid::stride + p.i;
}

}  // namespace

void StructuredTriangles::refine_face(FaceId f, std::span<const Vec3> control,
                                      std::span<Vec3> fine) const {
  const Triangle& t = triangle(f);
  std::array<TriangleGrid, 2> grids;
  TriangleGrid* grid = grids.data();
  TriangleGrid* finer = grid + 1;
  grid->resize(1);
  for (int k = 0; k < 16; ++k)
    grid->point(k % 4 - 1, k / 4 - 1) =
        Point4(control[static_cast<std::size_t>(t.control[static_cast<std::size_t>(k)].value)]);
  for (int step = 1; step <= depth_; ++step) {
    kernel_->refine(masks_, grid->cells(), numbering_.axes(step).data(), grid->points(),
                    finer->points());
    finer->resize(2 * grid->cells());
    for (int s = 0; s < 3; ++s)
      apply_side(t, s, step, *grid, *finer);
    take_corners(t, step, *grid, *finer);
    std::swap(grid, finer);
  }
  write_vertices(f, *grid, fine);
}

/// Axis on which the ring of a vertex on a side starts: in this triangle, or in the lower one beyond.
/// Directions there are turned by the difference of the sides' own and by half a turn.
int StructuredTriangles::axis_on_side(const Triangle& t, int side, int step, int n,
                                      int along) const {
  const auto& axes = numbering_.axes(step);
  const auto axis = [&](GridPoint p) -> int {
    return axes[static_cast<std::size_t>(TriangleGrid::place(p.i, p.j))];
  };
  const int lender = t.lender[static_cast<std::size_t>(side)];
  if (lender < 0) return axis(TriangleSide(side, n).node(along));
  return (axis(TriangleSide(lender, n).node(n - along)) + lender + 2 * side) % 3;
}

/// Renews the points on a side of a refined grid, but for its corners: by the rules of a line where it
/// is sharp, from where the ring starts elsewhere.
void StructuredTriangles::apply_side(const Triangle& t, int side, int step,
                                     const TriangleGrid& coarse, TriangleGrid& fine) const {
  const bool lent = t.lender[static_cast<std::size_t>(side)] >= 0;
  if (lent && step == depth_) return;  // nobody reads them
  const Line* line = t.line[static_cast<std::size_t>(side)];
  const bool sharp = line && static_cast<std::size_t>(step) <= line->size();
  if (!sharp && !lent) return;

  const int n = coarse.cells();
  const TriangleSide at(side, n);
  std::array<int, 7> places{};  // as TriangleLineRules counts them
  for (int k = 0; k < 6; ++k)
    places[static_cast<std::size_t>(1 + k)] = offset_of(triangle_direction(at.direction() + k));
  for (int m = 0; m < n; ++m) {
    const GridPoint p = at.node(m);
    const Point4* v = &coarse.point(p.i, p.j);
    Point4* out = &fine.point(2 * p.i, 2 * p.j);
    const int axis = m > 0 ? axis_on_side(t, side, step, n, m) : 0;
    if (!sharp) {
      if (m > 0) *out = regular_vertex(masks_, v, axis);
      continue;
    }
    const auto value = [&](const Stencil& stencil) {
      const auto point = [&](int place) { return v[places[static_cast<std::size_t>(place)]]; };
      return apply_stencil<Point4>(stencil, point, point);
    };
    const TriangleLineRules& rules = (*line)[static_cast<std::size_t>(step - 1)];
    if (m > 0) *out = value(rules.vertex[static_cast<std::size_t>((axis + side) % 3)]);
    out[places[TriangleLineRules::next]] = value(rules.edge);
  }
}

void StructuredTriangles::take_corners(const Triangle& t, int step, const TriangleGrid& coarse,
                                       TriangleGrid& fine) const {
  for (int c = 0; c < 3; ++c) {
    const GridPoint p = TriangleSide(c, fine.cells()).node(0);
    Point4* corner = &fine.point(p.i, p.j);
    const int ring = t.ring[static_cast<std::size_t>(c)];
    if (ring < 0) {
      const int axis = t.corner_axis[static_cast<std::size_t>(c)];
      if (axis == 2 * c % 3) continue;  // as the grid has it
      const GridPoint before = TriangleSide(c, coarse.cells()).node(0);
      *corner = regular_vertex(masks_, &coarse.point(before.i, before.j), axis);
      continue;
    }
    if (step == depth_) continue;  // the ring has written it
    *corner = rings_.position(ring, step);
    const auto put = [&](int by) {
      const int k = rings_.turned(ring, t.ring_edge[static_cast<std::size_t>(c)], by);
      corner[offset_of(triangle_direction(2 * c + by))] =
          k < 0 ? *corner : rings_.end(ring, step, k);
    };
    put(2);
    put(-1);
  }
}

void StructuredTriangles::write_vertices(FaceId f, const TriangleGrid& grid,
                                         std::span<Vec3> fine) const {
  const Triangle& t = triangle(f);
  const std::uint16_t* offsets = runs(t).offsets().data();
  for (int birth = 1; birth <= depth_; ++birth) {
    const int count = runs(t).num_edges(birth);
    kernel_->write(grid.points(), offsets, count, fine.data() + first_of_run(f, birth));
    offsets += count;
  }
  const auto corners = control_->topology().face(f);
  for (int c = 0; c < 3; ++c) {
    if (((t.own_corners >> c) & 1U) == 0) continue;
    const GridPoint p = TriangleSide(c, grid.cells()).node(0);
    grid.point(p.i, p.j).store(
        fine[static_cast<std::size_t>(corners[static_cast<std::size_t>(c)].value)]);
  }
}

}  // namespace limes
