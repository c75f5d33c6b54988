// No include guard: compiled once for every instruction set, see limes/core/instruction_sets.h. The
// operations and their order are the same.

using Vector = double __attribute__((vector_size(LIMES_LANES * sizeof(double))));
constexpr int num_parts = 4 / LIMES_LANES;

/// A Point4 as vectors.
struct __attribute__((may_alias)) Point {
  Vector part[num_parts];
};
LIMES_INLINE const Point* as_points(const Point4* p) {
  return reinterpret_cast<const Point*>(p);
}

LIMES_INLINE void store(const Point& p, Vec3& out) {
  double* to = out.data();
  to[0] = p.part[0][0];
  to[1] = p.part[0][1];
  to[2] = p.part[2 / LIMES_LANES][2 % LIMES_LANES];
}

LIMES_INLINE void face_point(const RegularMasks& m, const Point* low, const Point* high,
                             Point& out) {
  for (int k = 0; k < num_parts; ++k)
    out.part[k] =
        m.face * ((low[0].part[k] + high[1].part[k]) + (low[1].part[k] + high[0].part[k]));
}

LIMES_INLINE void edge_point(const RegularMasks& m, const Point& a, const Point& b, const Point& f,
                             const Point& g, Point& out) {
  for (int k = 0; k < num_parts; ++k)
    out.part[k] = m.edge_ends * (a.part[k] + b.part[k]) + m.edge_faces * (f.part[k] + g.part[k]);
}

/// @param v  the vertex, in lines of s points
/// @param f  the face point at its lower left, in lines of t points
LIMES_INLINE void vertex_point(const RegularMasks& m, const Point* v, int s, const Point* f, int t,
                               Point& out) {
  for (int k = 0; k < num_parts; ++k)
    out.part[k] =
        m.vertex_self * v[0].part[k] +
        m.vertex_neighbours * ((v[1].part[k] + v[-1].part[k]) + (v[s].part[k] + v[-s].part[k])) +
        m.vertex_faces * ((f[0].part[k] + f[t + 1].part[k]) + (f[1].part[k] + f[t].part[k]));
}

void make_face_points(const RegularMasks& m, int n, const Point4* vertices, Point4* faces) {
  const int s = n + 3;
  const int t = n + 2;
  Point* out = reinterpret_cast<Point*>(faces);
  for (int j = 0; j < t; ++j) {
    const Point* low = as_points(vertices) + j * s;
    for (int i = 0; i < t; ++i)
      face_point(m, low + i, low + i + s, *out++);
  }
}

void refine(const RegularMasks& m, int n, const Point4* vertices, const Point4* faces,
            Point4* fine) {
  const int s = n + 3;
  const int t = n + 2;
  const int fine_stride = 2 * n + 3;
  for (int j = -1; j <= n; ++j) {
    // Line 2 j + 1 of the fine grid: face points, and points of the edges that run upwards.
    Point* odd = reinterpret_cast<Point*>(fine) + (2 * j + 2) * fine_stride;
    const Point* f = as_points(faces) + (j + 1) * t;         // of cell (-1, j)
    const Point* v = as_points(vertices) + (j + 1) * s + 1;  // vertex (0, j)
    for (int i = 0; i < t; ++i)
      odd[2 * i] = f[i];
    for (int i = 0; i <= n; ++i)
      edge_point(m, v[i], v[i + s], f[i], f[i + 1], odd[2 * i + 1]);
    if (j < 0) continue;
    // Line 2 j: points of the edges that run to the right, and of vertices.
    Point* even = reinterpret_cast<Point*>(fine) + (2 * j + 1) * fine_stride;
    for (int i = 0; i < t; ++i)
      edge_point(m, v[i - 1], v[i], f[i], f[i - t], even[2 * i]);
    for (int i = 0; i <= n; ++i)
      vertex_point(m, v + i, s, f + i - t, t, even[2 * i + 1]);
  }
}

void write_vertices(const RegularMasks& m, int n, const Point4* vertices, const Point4* faces,
                    const QuadRuns::OldVertex* old, int count, Vec3* out) {
  for (int k = 0; k < count; ++k) {
    Point p;
    vertex_point(m, as_points(vertices) + old[k].vertex, n + 3, as_points(faces) + old[k].face,
                 n + 2, p);
    store(p, out[k]);
  }
}

void write_edges(const RegularMasks& m, const Point4* vertices, const Point4* faces,
                 const QuadRuns::NewEdge* edges, int count, Vec3* out) {
  const Point* v = as_points(vertices);
  const Point* f = as_points(faces);
  for (int k = 0; k < count; ++k) {
    const QuadRuns::NewEdge& e = edges[k];
    Point p;
    edge_point(m, v[e.a], v[e.b], f[e.f], f[e.g], p);
    store(p, out[k]);
  }
}

void write_faces(const Point4* faces, const std::uint16_t* order, int count, Vec3* out) {
  for (int k = 0; k < count; ++k)
    store(as_points(faces)[order[k]], out[k]);
}
