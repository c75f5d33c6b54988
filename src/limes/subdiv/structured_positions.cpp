#include "limes/subdiv/quad_sides.h"
#include "limes/subdiv/structured.h"

namespace limes {
namespace {

/// Renews the points on a side of a refined grid, but for its corners, by the rules of a line.
void apply_line(const LineRules& rules, int side, const QuadGrid& coarse, QuadGrid& fine) {
  const QuadSide at(side, coarse.cells());
  const GridPoint next = at.direction();
  const GridPoint in = at.inward();
  const auto step = [](GridPoint p) { return p.j * QuadGrid::stride + p.i; };
  const std::array<int, 5> vertices{0, step(next), step(in), -step(next), -step(in)};
  // On the fine grid the face points lie diagonally around the vertex.
  const std::array<int, 4> faces{step(next + in), step(in - next), -step(next + in),
                                 step(next - in)};
  for (int m = 0; m < coarse.cells(); ++m) {
    const GridPoint p = at.node(m);
    const Point4* v = &coarse.point(p.i, p.j);
    Point4* f = &fine.point(2 * p.i, 2 * p.j);
    const auto value = [&](const Stencil& stencil) {
      return apply_stencil<Point4>(
          stencil, [&](int place) { return v[vertices[static_cast<std::size_t>(place)]]; },
          [&](int place) { return f[faces[static_cast<std::size_t>(place)]]; });
    };
    if (m > 0) f[0] = value(rules.vertex);
    f[step(next)] = value(rules.edge);
  }
}

}  // namespace

void StructuredRefinement::refine_face(FaceId f, std::span<const Vec3> control,
                                       std::span<Vec3> fine) const {
  const Quad& q = quad(f);
  std::array<QuadGrid, 2> grids;
  QuadGrid* grid = grids.data();
  QuadGrid* finer = grid + 1;
  grid->resize(1);
  for (int k = 0; k < 16; ++k)
    grid->point(k % 4 - 1, k / 4 - 1) =
        Point4(control[static_cast<std::size_t>(q.control[static_cast<std::size_t>(k)].value)]);
  for (int step = 1; step <= depth_; ++step) {
    kernel_->refine(masks_, grid->cells(), grid->points(), finer->points());
    finer->resize(2 * grid->cells());
    apply_lines(q, step, *grid, *finer);
    if (step < depth_) take_corners(q, step, *finer);
    std::swap(grid, finer);
  }
  write_runs(f, *grid, fine);
  write_corners(q, *grid, fine);
}

void StructuredRefinement::apply_lines(const Quad& q, int step, const QuadGrid& grid,
                                       QuadGrid& fine) const {
  for (int s = 0; s < 4; ++s) {
    const Line* line = q.line[static_cast<std::size_t>(s)];
    const bool is_written = step < depth_ || ((q.owned >> s) & 1U) != 0;
    if (line && is_written && static_cast<std::size_t>(step) <= line->size())
      apply_line((*line)[static_cast<std::size_t>(step - 1)], s, grid, fine);
  }
}

void StructuredRefinement::take_corners(const Quad& q, int step, QuadGrid& grid) const {
  for (int c = 0; c < 4; ++c) {
    const int ring = q.ring[static_cast<std::size_t>(c)];
    if (ring < 0) continue;
    const QuadSide at(c, grid.cells());
    const QuadSide before((c + 3) % 4, grid.cells());
    const auto put = [&](GridPoint p, const Point4& value) { grid.point(p.i, p.j) = value; };
    const Point4& corner = rings_.position(ring, step);
    const auto end = [&](int by) -> const Point4& {
      const int k = rings_.turned(ring, q.ring_edge[static_cast<std::size_t>(c)], by);
      return k < 0 ? corner : rings_.end(ring, step, k);
    };
    put(at.node(0), corner);
    put(at.node(0) - at.direction(), end(2));
    put(at.node(0) + before.direction(), end(-1));
  }
}

void StructuredRefinement::write_runs(FaceId f, const QuadGrid& grid, std::span<Vec3> fine) const {
  const QuadRuns& r = runs(quad(f));
  const std::uint16_t* offsets = r.offsets().data();
  const auto write = [&](int first, int count) {
    kernel_->write(grid.points(), offsets, count, fine.data() + first);
    offsets += count;
  };
  for (int birth = 1; birth <= depth_; ++birth) {
    write(first_of_edge_run(f, birth), r.num_edges(birth));
    write(first_of_face_run(f, birth), 1 << (2 * birth - 2));
  }
}

void StructuredRefinement::write_corners(const Quad& q, const QuadGrid& grid,
                                         std::span<Vec3> fine) const {
  for (int c = 0; c < 4; ++c) {
    if (((q.own_corners >> c) & 1U) == 0) continue;
    const GridPoint p = QuadSide(c, grid.cells()).node(0);
    const GridPoint first = QuadSide(c, 1).node(0);
    const VertexId v = q.control[static_cast<std::size_t>(4 * (first.j + 1) + first.i + 1)];
    grid.point(p.i, p.j).store(fine[static_cast<std::size_t>(v.value)]);
  }
}

}  // namespace limes
