#include "limes/study/exact_surface.h"

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
        "a vertex at ({:.6g}, {:.6g}, {:.6g}) is on the axis of [geometry], no point of the "
        "surface is "
        "nearest to it",
        x.x(), x.y(), x.z());
  return d;
}

}  // namespace

Vec3 project(const GeometrySettings& surface, const Vec3& x) {
  const Vec3 d = arm(surface, x);
  return x + (surface.radius / d.norm() - 1) * d;
}

Vec3 outward_normal(const GeometrySettings& surface, const Vec3& x) {
  return arm(surface, x).normalized();
}

}  // namespace limes
