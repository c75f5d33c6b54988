#include "limes/subdiv/quad_grid.h"

namespace limes {

void QuadGrid::make_face_points(const RegularMasks& m) {
  const int s = stride();
  Point4* out = faces_.data();
  for (int j = 0; j < face_stride(); ++j) {
    const Point4* low = vertices_.data() + j * s;
    const Point4* high = low + s;
    for (int i = 0; i < face_stride(); ++i)
      *out++ = m.face * ((low[i] + high[i + 1]) + (low[i + 1] + high[i]));
  }
}

void QuadGrid::refine(const RegularMasks& m, QuadGrid& fine) const {
  fine.resize(2 * n_);
  const int s = stride();
  const int t = face_stride();
  for (int j = -1; j <= n_; ++j) {
    // Line 2 j + 1 of the fine grid: face points, and points of the edges that run upwards.
    Point4* odd = &fine.vertex(fine.vertex_index(-1, 2 * j + 1));
    const int f = face_index(-1, j);
    for (int i = 0; i < t; ++i)
      odd[2 * i] = faces_[static_cast<std::size_t>(f + i)];
    const int v = vertex_index(0, j);
    for (int i = 0; i <= n_; ++i)
      odd[2 * i + 1] = edge_point(m, v + i, v + i + s, f + i, f + i + 1);
    if (j < 0) continue;
    // Line 2 j: points of the edges that run to the right, and of vertices.
    Point4* even = &fine.vertex(fine.vertex_index(-1, 2 * j));
    for (int i = 0; i < t; ++i)
      even[2 * i] = edge_point(m, v - 1 + i, v + i, f + i, f + i - t);
    for (int i = 0; i <= n_; ++i)
      even[2 * i + 1] = vertex_point(m, v + i, f + i - t);
  }
}

}  // namespace limes
