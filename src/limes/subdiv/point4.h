#pragma once

#include "limes/core/types.h"

namespace limes {

/// A point in two vector registers: x, y | z and an idle lane. Loops over points of this type run at
/// the full width of SSE2 and NEON without shuffling; operations are those of Vec3, in the same
/// order, so results have the same bits.
struct alignas(32) Point4 {
  using Pair [[gnu::vector_size(16)]] = double;
  Pair xy, z0;

  Point4() = default;
  Point4(Pair a, Pair b) : xy(a), z0(b) {}
  explicit Point4(const Vec3& p) : xy{p.x(), p.y()}, z0{p.z(), 0.0} {}

  void store(Vec3& p) const { p = Vec3(xy[0], xy[1], z0[0]); }

  friend Point4 operator+(const Point4& a, const Point4& b) { return {a.xy + b.xy, a.z0 + b.z0}; }
  friend Point4 operator*(double w, const Point4& a) { return {w * a.xy, w * a.z0}; }
};

}  // namespace limes
