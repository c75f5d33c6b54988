// No include guard: compiled once for every instruction set, see limes/core/instruction_sets.h. What
// the loops over grids of points share.

using Vector = double __attribute__((vector_size(LIMES_LANES * sizeof(double))));
using LooseVector = Vector __attribute__((aligned(8), may_alias));
constexpr int num_parts = 4 / LIMES_LANES;

/// A Point4 as vectors.
struct __attribute__((may_alias)) Point {
  Vector part[num_parts];
};

LIMES_INLINE Point operator+(const Point& a, const Point& b) {
  Point sum;
  for (int k = 0; k < num_parts; ++k)
    sum.part[k] = a.part[k] + b.part[k];
  return sum;
}
LIMES_INLINE Point operator*(double w, const Point& a) {
  Point product;
  for (int k = 0; k < num_parts; ++k)
    product.part[k] = w * a.part[k];
  return product;
}

/// All four numbers of a point, of which the last falls on the next.
LIMES_INLINE void copy_with_idle_lane(const double* from, double* to) {
  for (int k = 0; k < num_parts; ++k)
    reinterpret_cast<LooseVector*>(to)[k] = reinterpret_cast<const LooseVector*>(from)[k];
}

/// Some points of a grid, one after another.
void write(const Point4* grid, const std::uint16_t* offsets, int count, Vec3* out) {
  if (count == 0) return;
  const auto* from = reinterpret_cast<const double*>(grid);
  LIMES_UNROLL
  for (int k = 0; k < count - 1; ++k)
    copy_with_idle_lane(from + offsets[k], out[k].data());
  from += offsets[count - 1];
  out[count - 1] = Vec3(from[0], from[1], from[2]);
}
