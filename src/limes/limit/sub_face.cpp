#include "limes/limit/sub_face.h"

#include <algorithm>

namespace limes {
namespace {

/// Turns the frame of a square so that corner c becomes the origin, u towards corner c + 1.
LocalPoint turned_square(const LocalPoint& p, int c) {
  const double u = p.uv.x();
  const double v = p.uv.y();
  const Eigen::RowVector2d du = p.J.row(0);
  const Eigen::RowVector2d dv = p.J.row(1);
  LocalPoint q;
  switch (c) {
    case 0:
      return p;
    case 1:
      q.uv = {v, 1.0 - u};
      q.J << dv, -du;
      return q;
    case 2:
      q.uv = {1.0 - u, 1.0 - v};
      q.J << -du, -dv;
      return q;
    default:
      q.uv = {1.0 - v, u};
      q.J << -dv, du;
      return q;
  }
}

/// Weight of corner 0 of a triangle; 0 for a point that rounding has put beyond side 1.
double weight_of_corner_0(const Vec2& uv) {
  return std::max(0.0, 1.0 - uv.x() - uv.y());
}

/// The same for a triangle: u and v become the weights of corners c + 1 and c + 2.
LocalPoint turned_triangle(const LocalPoint& p, int c) {
  const Eigen::RowVector2d du = p.J.row(0);
  const Eigen::RowVector2d dv = p.J.row(1);
  LocalPoint q;
  switch (c) {
    case 0:
      return p;
    case 1:
      q.uv = {p.uv.y(), weight_of_corner_0(p.uv)};
      q.J << dv, -du - dv;
      return q;
    default:
      q.uv = {weight_of_corner_0(p.uv), p.uv.x()};
      q.J << -du - dv, du;
      return q;
  }
}

/// The triangle between the middles of the sides.
LocalPoint into_middle(const LocalPoint& p) {
  const double u = p.uv.x();
  const double v = p.uv.y();
  LocalPoint q;
  q.uv = {2.0 * (u + v) - 1.0, 1.0 - 2.0 * u};
  q.J << 2.0 * (p.J.row(0) + p.J.row(1)), -2.0 * p.J.row(0);
  return q;
}

}  // namespace

int child_at(Split split, const Vec2& uv) {
  const bool right = uv.x() > 0.5;
  const bool top = uv.y() > 0.5;
  if (split == Split::quads) {
    if (right) return top ? 2 : 1;
    return top ? 3 : 0;
  }
  if (right) return 1;
  if (top) return 2;
  return uv.x() + uv.y() < 0.5 ? 0 : 3;
}

LocalPoint into_child(Split split, const LocalPoint& p, int child) {
  if (split == Split::triangles && child == 3) return into_middle(p);
  LocalPoint q = split == Split::quads ? turned_square(p, child) : turned_triangle(p, child);
  q.uv *= 2.0;
  q.J *= 2.0;
  return q;
}

}  // namespace limes
