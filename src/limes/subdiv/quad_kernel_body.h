// No include guard: compiled once for every instruction set, see limes/core/instruction_sets.h. The
// operations and their order are the same.

#include "limes/subdiv/point_body.h"

using FourIds = std::int32_t __attribute__((vector_size(16), aligned(4), may_alias));

LIMES_INLINE Point face_point(const RegularMasks& m, const Point& a, const Point& b, const Point& c,
                              const Point& d) {
  return m.face * ((a + c) + (b + d));
}
LIMES_INLINE Point edge_point(const RegularMasks& m, const Point& a, const Point& b, const Point& f,
                              const Point& g) {
  return m.edge_ends * (a + b) + m.edge_faces * (f + g);
}

/// Line 2 j + 1 of the fine grid, new faces and edges that run upwards, and line 2 j, edges that run
/// to the right and old vertices; line by line in step, so that what both need is loaded once.
/// @param v    vertex (0, j) of the coarse grid
/// @param odd  vertex (0, 2 j + 1) of the fine grid
LIMES_INLINE void refine_lines(const RegularMasks& m, int n, const Point* v, Point* odd) {
  constexpr int s = QuadGrid::stride;
  Point* even = odd - s;
  const Point* below = odd - 2 * s;  // the face points one line below
  Point left = face_point(m, v[-1], v[0], v[s], v[s - 1]);
  odd[-1] = left;
  even[-1] = edge_point(m, v[-1], v[0], left, below[-1]);
  for (int i = 0; i <= n; ++i, ++v, odd += 2, even += 2, below += 2) {
    const Point self = v[0], right = v[1], up = v[s];
    const Point face = face_point(m, self, right, v[s + 1], up);
    const Point lower = below[1];
    odd[0] = edge_point(m, self, up, left, face);
    odd[1] = face;
    even[0] = m.vertex_self * self + m.vertex_neighbours * ((right + v[-1]) + (up + v[-s])) +
              m.vertex_faces * ((below[-1] + face) + (lower + left));
    even[1] = edge_point(m, self, right, face, lower);
    left = face;
  }
}

/// The same of the margin line below the grid, which has no line 2 j.
LIMES_INLINE void refine_lowest_line(const RegularMasks& m, int n, const Point* v, Point* odd) {
  constexpr int s = QuadGrid::stride;
  Point left = face_point(m, v[-1], v[0], v[s], v[s - 1]);
  odd[-1] = left;
  for (int i = 0; i <= n; ++i, ++v, odd += 2) {
    const Point face = face_point(m, v[0], v[1], v[s + 1], v[s]);
    odd[0] = edge_point(m, v[0], v[s], left, face);
    odd[1] = face;
    left = face;
  }
}

void refine(RegularMasks m, int n, const Point4* coarse, Point4* fine) {
  const auto* v = reinterpret_cast<const Point*>(coarse);
  auto* to = reinterpret_cast<Point*>(fine);
  refine_lowest_line(m, n, v + QuadGrid::place(0, -1), to + QuadGrid::place(0, -1));
  for (int j = 0; j <= n; ++j)
    refine_lines(m, n, v + QuadGrid::place(0, j), to + QuadGrid::place(0, 2 * j + 1));
}

/// Child k of a cell with the corners v, the edges e and the middle m is (v_k, e_k, m, e_{k-1}): the
/// rows of a matrix with the columns v, e, m and e turned by one.
void split(int num_cells, const VertexId* corners, const std::int32_t* edge_ranks,
           std::int32_t first_edge, std::int32_t first_face, VertexId* fine) {
  const auto* v = reinterpret_cast<const FourIds*>(corners);
  const auto* ranks = reinterpret_cast<const FourIds*>(edge_ranks);
  auto* child = reinterpret_cast<FourIds*>(fine);
  FourIds m = first_face - FourIds{};
  for (int c = 0; c < num_cells; ++c, child += 4, m += 1) {
    const FourIds e = ranks[c] + first_edge;
    const FourIds before = __builtin_shufflevector(e, e, 3, 0, 1, 2);
    const FourIds low = __builtin_shufflevector(v[c], e, 0, 4, 1, 5);
    const FourIds high = __builtin_shufflevector(v[c], e, 2, 6, 3, 7);
    const FourIds low_end = __builtin_shufflevector(m, before, 0, 4, 1, 5);
    const FourIds high_end = __builtin_shufflevector(m, before, 2, 6, 3, 7);
    child[0] = __builtin_shufflevector(low, low_end, 0, 1, 4, 5);
    child[1] = __builtin_shufflevector(low, low_end, 2, 3, 6, 7);
    child[2] = __builtin_shufflevector(high, high_end, 0, 1, 4, 5);
    child[3] = __builtin_shufflevector(high, high_end, 2, 3, 6, 7);
  }
}
