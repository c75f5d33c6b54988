#include "limes/report/clearance.h"

#include <algorithm>

namespace limes {
namespace {

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0;
  return (p - a - t * d).norm();
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

double distance(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (segments_cross(a, b, c, d)) return 0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

}  // namespace

bool is_clear(const std::vector<std::vector<Vec2>>& curves, std::span<const Vec2> outline,
              double space) {
  for (const auto& curve : curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2& a = curve[i];
      const Vec2& b = curve[std::min(i + 1, curve.size() - 1)];
      bool inside = true;  // a convex outline, either orientation
      double side = 0;
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2& p = outline[k];
        const Vec2& q = outline[(k + 1) % outline.size()];
        if (distance(a, b, p, q) < space) return false;
        const double t = turn(p, q, a);
        if (side * t < 0) inside = false;
        side = t;
      }
      if (inside) return false;
    }
  }
  return true;
}

}  // namespace limes
