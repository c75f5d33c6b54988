// No include guard: compiled once for every instruction set, see limes/core/instruction_sets.h. The
// operations and their order are the same.

#include "limes/subdiv/point_body.h"

/// Of the edge from v to v[end], between v[left] and v[right].
LIMES_INLINE Point edge_point(const RegularTriangleMasks& m, const Point* v, int end, int left,
                              int right) {
  return m.edge_ends * (v[0] + v[end]) + m.edge_opposite * (v[left] + v[right]);
}

LIMES_INLINE Point vertex_point(const RegularTriangleMasks& m, const Point* v, int axis) {
  constexpr int s = TriangleGrid::stride;
  // Opposite neighbours on the first, second and third axis, counted from the ring's start.
  constexpr int pairs[3][3] = {{1, s, s - 1}, {s, s - 1, 1}, {s - 1, 1, s}};
  const int* p = pairs[axis];
  return m.vertex_self * v[0] +
         m.vertex_neighbours *
             (((v[p[0]] + v[-p[0]]) + (v[p[1]] + v[-p[1]])) + (v[p[2]] + v[-p[2]]));
}

void refine(RegularTriangleMasks m, int n, const std::uint8_t* axes, const Point4* coarse,
            Point4* fine) {
  constexpr int s = TriangleGrid::stride;
  const auto* points = reinterpret_cast<const Point*>(coarse);
  auto* out = reinterpret_cast<Point*>(fine);

  // The margin line below: edges up to the right and up to the left of the coarse one.
  const Point* v = points + TriangleGrid::place(0, -1);
  Point* odd = out + TriangleGrid::place(0, -1);
  odd[0] = edge_point(m, v, s, s - 1, 1);
  for (int i = 1; i <= n + 1; ++i) {
    odd[2 * i - 1] = edge_point(m, v + i, s - 1, s, -1);
    if (i <= n) odd[2 * i] = edge_point(m, v + i, s, s - 1, 1);
  }
  for (int j = 0; j <= n; ++j) {
    v = points + TriangleGrid::place(0, j);
    const std::uint8_t* axis = axes + TriangleGrid::place(0, j);
    Point* even = out + TriangleGrid::place(0, 2 * j);
    odd = out + TriangleGrid::place(0, 2 * j + 1);
    even[-1] = edge_point(m, v - 1, 1, s, 1 - s);
    for (int i = 0; i <= n - j; ++i, ++v) {
      even[2 * i] = vertex_point(m, v, axis[i]);
      even[2 * i + 1] = edge_point(m, v, 1, s, 1 - s);
      odd[2 * i - 1] = edge_point(m, v, s - 1, s, -1);
      odd[2 * i] = edge_point(m, v, s, s - 1, 1);
    }
  }
}

/// Children of a cell with the corners v and the edges e: (v_i, e_i, e_{i-1}), and (e_0, e_1, e_2).
void split(int num_cells, const VertexId* corners, const std::int32_t* edge_ranks,
           std::int32_t first_edge, VertexId* fine) {
  for (int c = 0; c < num_cells; ++c, corners += 3, edge_ranks += 3, fine += 12) {
    const VertexId e0(first_edge + edge_ranks[0]);
    const VertexId e1(first_edge + edge_ranks[1]);
    const VertexId e2(first_edge + edge_ranks[2]);
    fine[0] = corners[0];
    fine[1] = e0;
    fine[2] = e2;
    fine[3] = corners[1];
    fine[4] = e1;
    fine[5] = e0;
    fine[6] = corners[2];
    fine[7] = e2;
    fine[8] = e1;
    fine[9] = e0;
    fine[10] = e1;
    fine[11] = e2;
  }
}
