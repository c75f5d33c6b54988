#include <bit>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/quad_sides.h"
#include "limes/subdiv/structured.h"
#include "limes/subdiv/surroundings.h"

namespace limes {
namespace {

/// Calls write(t, point) for the new points on a side of a grid of n cells but its corners,
/// 0 < t < 2 n.
template <class Write>
void along_line(const LineRules& rules, int side, const QuadGrid& grid, const Write& write) {
  const QuadSide at(side, grid.cells());
  const GridPoint next = at.direction();
  const GridPoint in = at.inward();
  const auto vertex_step = [&](GridPoint p) { return p.j * grid.stride() + p.i; };
  // The cell between two directions begins at the vertex, or one before it.
  const auto face_step = [&](GridPoint a, GridPoint b) {
    const GridPoint d = a + b;
    return (d.j < 0 ? -grid.face_stride() : 0) + (d.i < 0 ? -1 : 0);
  };
  const std::array<int, 5> vertices{0, vertex_step(next), vertex_step(in), -vertex_step(next),
                                    -vertex_step(in)};
  const std::array<int, 4> faces{face_step(next, in), face_step(in, -1 * next),
                                 face_step(-1 * next, -1 * in), face_step(-1 * in, next)};
  for (int m = 0; m < grid.cells(); ++m) {
    const GridPoint p = at.node(m);
    const Point4* v = grid.vertices() + grid.vertex_index(p.i, p.j);
    const Point4* f = grid.faces() + grid.face_index(p.i, p.j);
    const auto value = [&](const Stencil& stencil) {
      return apply_stencil<Point4>(
          stencil, [&](int place) { return v[vertices[static_cast<std::size_t>(place)]]; },
          [&](int place) { return f[faces[static_cast<std::size_t>(place)]]; });
    };
    if (m > 0) write(2 * m, value(rules.vertex));
    write(2 * m + 1, value(rules.edge));
  }
}

}  // namespace

void StructuredRefinement::positions(std::span<const Vec3> control, std::span<Vec3> fine) {
  LIMES_ASSERT(static_cast<int>(control.size()) == control_->topology().num_vertices());
  LIMES_ASSERT(static_cast<int>(fine.size()) == num_vertices_);
  for (const VertexId v : unused_)
    fine[static_cast<std::size_t>(v.value)] = control[static_cast<std::size_t>(v.value)];
  for_each_block(rings_.size(), 64, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    for (std::int64_t r = begin; r < end; ++r)
      refine_ring(static_cast<int>(r), control, fine);
  });
  for_each_block(control_->topology().num_faces(), 16, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    for (std::int64_t f = begin; f < end; ++f)
      refine_quad(FaceId(f), control, fine);
  });
}

void StructuredRefinement::refine_ring(int ring, std::span<const Vec3> control,
                                       std::span<Vec3> fine) {
  rings_.refine(ring, control, fine[static_cast<std::size_t>(rings_.vertex(ring).value)]);
}

void StructuredRefinement::refine_quad(FaceId f, std::span<const Vec3> control,
                                       std::span<Vec3> fine) const {
  const Quad& q = quad(f);
  std::array<QuadGrid, 2> grids;
  QuadGrid* grid = grids.data();
  QuadGrid* finer = grid + 1;
  grid->resize(1);
  for (int k = 0; k < 16; ++k)
    grid->vertex(k) =
        Point4(control[static_cast<std::size_t>(q.control[static_cast<std::size_t>(k)].value)]);
  for (int step = 1; step < numbering_.depth(); ++step) {
    grid->make_face_points(*kernel_, masks_);
    grid->refine(*kernel_, masks_, *finer);
    apply_lines(q, step, *grid, *finer);
    take_corners(q, step, *finer);
    std::swap(grid, finer);
  }
  grid->make_face_points(*kernel_, masks_);
  write_runs(f, *grid, fine);
  write_corners(q, *grid, fine);
  write_lines(f, *grid, fine);
}

void StructuredRefinement::apply_lines(const Quad& q, int step, const QuadGrid& grid,
                                       QuadGrid& fine) const {
  for (int s = 0; s < 4; ++s) {
    const Line* line = q.line[static_cast<std::size_t>(s)];
    if (!line || static_cast<std::size_t>(step) > line->size()) continue;
    const QuadSide at(s, fine.cells());
    along_line((*line)[static_cast<std::size_t>(step - 1)], s, grid, [&](int t, const Point4& p) {
      const GridPoint node = at.node(t);
      fine.vertex(fine.vertex_index(node.i, node.j)) = p;
    });
  }
}

void StructuredRefinement::take_corners(const Quad& q, int step, QuadGrid& grid) const {
  for (int c = 0; c < 4; ++c) {
    const int ring = q.ring[static_cast<std::size_t>(c)];
    if (ring < 0) continue;
    const QuadSide at(c, grid.cells());
    const QuadSide before((c + 3) % 4, grid.cells());
    const auto put = [&](GridPoint p, const Point4& value) {
      grid.vertex(grid.vertex_index(p.i, p.j)) = value;
    };
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
  const Quad& q = quad(f);
  const QuadRuns& r = runs(q);
  const QuadRuns::OldVertex* old = r.old_vertices.data();
  const auto move = [&](int first, int count) {
    kernel_->write_vertices(masks_, grid.cells(), grid.vertices(), grid.faces(), old, count,
                            fine.data() + first);
    old += count;
  };
  for (int birth = 1; birth < numbering_.depth(); ++birth) {
    const int n = 1 << (birth - 1);
    move(first_of_edge_run(f, birth), 2 * n * (n - 1) + n * std::popcount(q.owned));
    move(first_of_face_run(f, birth), n * n);
  }
  kernel_->write_edges(masks_, grid.vertices(), grid.faces(), r.new_edges.data(),
                       static_cast<int>(r.new_edges.size()),
                       fine.data() + first_of_edge_run(f, numbering_.depth()));
  kernel_->write_faces(grid.faces(), r.new_faces.data(), static_cast<int>(r.new_faces.size()),
                       fine.data() + first_of_face_run(f, numbering_.depth()));
}

void StructuredRefinement::write_corners(const Quad& q, const QuadGrid& grid,
                                         std::span<Vec3> fine) const {
  for (int c = 0; c < 4; ++c) {
    if (((q.own_corners >> c) & 1U) == 0) continue;
    const GridPoint p = QuadSide(c, grid.cells()).node(0);
    const GridPoint first = QuadSide(c, 1).node(0);
    const VertexId v = q.control[static_cast<std::size_t>(4 * (first.j + 1) + first.i + 1)];
    const QuadRuns::OldVertex corner{static_cast<std::uint16_t>(grid.vertex_index(p.i, p.j)),
                                     static_cast<std::uint16_t>(grid.face_index(p.i - 1, p.j - 1))};
    kernel_->write_vertices(masks_, grid.cells(), grid.vertices(), grid.faces(), &corner, 1,
                            &fine[static_cast<std::size_t>(v.value)]);
  }
}

void StructuredRefinement::write_lines(FaceId f, const QuadGrid& grid, std::span<Vec3> fine) const {
  const Quad& q = quad(f);
  const int depth = numbering_.depth();
  for (int s = 0; s < 4; ++s) {
    const Line* line = q.line[static_cast<std::size_t>(s)];
    if (((q.owned >> s) & 1U) == 0 || !line || static_cast<std::size_t>(depth) > line->size())
      continue;
    along_line(
        (*line)[static_cast<std::size_t>(depth - 1)], s, grid, [&](int t, const Point4& point) {
          const SideStep at = side_step(t, depth);
          const int v = first_of_edge_run(f, at.birth) + runs(q).side_rank(at.birth, s, at.step);
          point.store(fine[static_cast<std::size_t>(v)]);
        });
  }
}

void StructuredRefinement::update(std::span<const Vec3> control, std::span<const VertexId> moved,
                                  std::span<Vec3> fine) {
  for (const VertexId v : moved)
    if (!control_->ring_start(v).valid())
      fine[static_cast<std::size_t>(v.value)] = control[static_cast<std::size_t>(v.value)];
  // What moves with a vertex: the rings at the corners of its faces, and all quads at these.
  const std::vector<VertexId> near = surrounded_by(*control_, moved).vertices;
  for (const VertexId v : near)
    if (const int ring = rings_.ring_of(v); ring >= 0) refine_ring(ring, control, fine);
  const std::vector<FaceId> faces = faces_around(*control_, near);
  for_each_block(static_cast<std::int64_t>(faces.size()), 16,
                 [&](std::int64_t begin, std::int64_t end) {
                   for (std::int64_t i = begin; i < end; ++i)
                     refine_quad(faces[static_cast<std::size_t>(i)], control, fine);
                 });
}

}  // namespace limes
