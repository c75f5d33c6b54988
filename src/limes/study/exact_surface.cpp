#include "limes/study/exact_surface.h"

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"

namespace limes {
namespace {

/// From the nearest point of the axis, or from the centre, to x.
Vec3 arm(const GeometrySettings& surface, const Vec3& x) {
  Vec3 d = x - surface.point;
  if (surface.kind == GeometrySettings::Kind::cylinder) {
    const Vec3 axis = surface.axis.normalized();
    d -= d.dot(axis) * axis;
  }
  if (!(d.norm() > 1e-9 * surface.radius))
    throw InputError(
        "a vertex at ({:.6g}, {:.6g}, {:.6g}) is on the axis or at the centre of [geometry]; no "
        "point of the surface is nearest to it",
        x.x(), x.y(), x.z());
  return d;
}

double height(const GeometrySettings& surface, double x, double y) {
  const double z = surface.height(Vec3(x, y, 0));
  if (!std::isfinite(z))
    throw InputError("'{}' has no finite value at ({:.6g}, {:.6g})", surface.height.text(), x, y);
  return z;
}

/// By central differences; the step balances rounding and the cubic term.
Vec3 graph_normal(const GeometrySettings& surface, const Vec3& x) {
  const double h = 1e-5 * std::max(1e-3, x.norm());
  const double zx = height(surface, x.x() + h, x.y()) - height(surface, x.x() - h, x.y());
  const double zy = height(surface, x.x(), x.y() + h) - height(surface, x.x(), x.y() - h);
  return Vec3(-zx, -zy, 2 * h).normalized();
}

}  // namespace

Vec3 project(const GeometrySettings& surface, const Vec3& x) {
  if (surface.kind == GeometrySettings::Kind::graph)
    return {x.x(), x.y(), height(surface, x.x(), x.y())};
  const Vec3 d = arm(surface, x);
  return x + (surface.radius / d.norm() - 1) * d;
}

Vec3 outward_normal(const GeometrySettings& surface, const Vec3& x) {
  if (surface.kind == GeometrySettings::Kind::graph) return graph_normal(surface, x);
  return arm(surface, x).normalized();
}

}  // namespace limes
