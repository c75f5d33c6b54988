// No include guard: compiled once for every instruction set, see limes/core/instruction_sets.h. The
// operations and their order are the same.

using Vector = double __attribute__((vector_size(LIMES_LANES * sizeof(double))));
constexpr int per_line = 4 / LIMES_LANES;  // vectors

/// One line is x, y, z and a number that is not used; four of them are a polynomial in t.
struct __attribute__((may_alias)) Lines {
  Vector line[4][per_line];
};
struct Value {
  Vector line[per_line];
};

/// b = a x + c
LIMES_INLINE void step(const Lines& a, const Vector& x, const Lines& c, Lines& b) {
  for (int j = 0; j < 4; ++j)
    for (int k = 0; k < per_line; ++k)
      b.line[j][k] = a.line[j][k] * x + c.line[j][k];
}
LIMES_INLINE void step(const Vector (&a)[per_line], const Vector& x, const Vector (&c)[per_line],
                       Vector (&b)[per_line]) {
  for (int k = 0; k < per_line; ++k)
    b[k] = a[k] * x + c[k];
}

LIMES_INLINE void store(const Value& value, double scale, double* to) {
  to[0] = scale * value.line[0][0];
  to[1] = scale * value.line[0][1];
  to[2] = scale * value.line[2 / LIMES_LANES][2 % LIMES_LANES];
}
LIMES_INLINE void store(const Value& value, double* to) {
  to[0] = value.line[0][0];
  to[1] = value.line[0][1];
  to[2] = value.line[2 / LIMES_LANES][2 % LIMES_LANES];
}

/// Value and derivatives of a polynomial in t by Horner's rule; `second` is half the derivative.
struct Horner {
  Value value, first, second;
};
template <int order>
LIMES_INLINE void horner(const Lines& q, const Vector& t, Horner& h) {
  Value b, d;
  step(q.line[3], t, q.line[2], b.line);                         // b2
  if constexpr (order >= 1) step(q.line[3], t, b.line, d.line);  // d2
  step(b.line, t, q.line[1], b.line);                            // b1
  if constexpr (order >= 2) step(q.line[3], t, d.line, h.second.line);
  if constexpr (order >= 1) step(d.line, t, b.line, h.first.line);
  step(b.line, t, q.line[0], h.value.line);
}

template <int order>
void evaluate(const TilePoint* points, std::size_t count, const TileValues& to) {
  for (std::size_t i = 0; i < count; ++i) {
    const double* c = points[i].tile;
    const double s_ = points[i].u - c[3];
    const double t_ = points[i].v - c[7];
    const Vector s = s_ - Vector{};
    const Vector t = t_ - Vector{};
    const Lines* power = reinterpret_cast<const Lines*>(c);
    const Lines& c0 = power[0];
    const Lines& c1 = power[1];
    const Lines& c2 = power[2];
    const Lines& c3 = power[3];
    Lines b, d, e;
    step(c3, s, c2, b);
    if constexpr (order >= 1) step(c3, s, b, d);
    step(b, s, c1, b);
    if constexpr (order >= 2) step(c3, s, d, e);
    if constexpr (order >= 1) step(d, s, b, d);
    step(b, s, c0, b);

    Horner h;
    horner<order>(b, t, h);
    store(h.value, to.x + 3 * i);
    if constexpr (order >= 1) {
      Horner u;
      horner<order - 1>(d, t, u);
      store(h.first, to.xv + 3 * i);
      store(u.value, to.xu + 3 * i);
      if constexpr (order >= 2) {
        Horner uu;
        horner<0>(e, t, uu);
        store(uu.value, 2.0, to.xuu + 3 * i);
        store(u.first, to.xuv + 3 * i);
        store(h.second, 2.0, to.xvv + 3 * i);
      }
    }
  }
}
