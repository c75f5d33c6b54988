#include "limes/study/exact_surface.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "limes/core/error.h"

namespace limes {
namespace {

using Kind = GeometrySettings::Kind;

/// From the nearest point of the axis, or from the centre, to x.
Vec3 arm(const GeometrySettings& surface, const Vec3& x) {
  Vec3 d = x - surface.point;
  double size = surface.radius;
  if (surface.kind == Kind::cone) size = d.norm();
  if (surface.kind != Kind::sphere) {
    const Vec3 axis = surface.axis.normalized();
    d -= d.dot(axis) * axis;
  }
  if (!(d.norm() > 1e-9 * size))
    throw InputError(
        "a vertex at ({:.6g}, {:.6g}, {:.6g}) is on the axis or at the centre of [geometry]; no "
        "point of the surface is nearest to it",
        x.x(), x.y(), x.z());
  return d;
}

/// Unit vector in the plane of the axis and x, turned from the axis towards x: by a cone's angle it runs
/// along the cone, by 90 degrees more it is the cone's normal.
Vec3 turned_from_axis(const GeometrySettings& cone, const Vec3& x, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return std::sin(angle) * arm(cone, x).normalized() + std::cos(angle) * cone.axis.normalized();
}

/// From the nearest point of the circle in the middle of a torus's tube to x.
Vec3 arm_in_tube(const GeometrySettings& torus, const Vec3& x) {
  const Vec3 d = x - (torus.point + torus.radius * arm(torus, x).normalized());
  if (!(d.norm() > 1e-9 * torus.tube_radius))
    throw InputError(
        "a vertex at ({:.6g}, {:.6g}, {:.6g}) is in the middle of the tube of [geometry]; no point "
        "of the surface is nearest to it",
        x.x(), x.y(), x.z());
  return d;
}

double value_of(const Expression& formula, const Vec3& x) {
  const double value = formula(x);
  if (!std::isfinite(value))
    throw InputError("'{}' has no finite value at ({:.6g}, {:.6g}, {:.6g})", formula.text(), x.x(),
                     x.y(), x.z());
  return value;
}

/// By central differences; the step balances rounding and the cubic term.
Vec3 gradient_of(const Expression& formula, const Vec3& x) {
  const double h = 1e-5 * std::max(1e-3, x.norm());
  Vec3 out;
  for (int i = 0; i < 3; ++i) {
    const Vec3 step = h * Vec3::Unit(i);
    out(i) = (value_of(formula, x + step) - value_of(formula, x - step)) / (2 * h);
  }
  return out;
}

double height(const GeometrySettings& surface, double x, double y) {
  const double z = surface.height(Vec3(x, y, 0));
  if (!std::isfinite(z))
    throw InputError("'{}' has no finite value at ({:.6g}, {:.6g})", surface.height.text(), x, y);
  return z;
}

Vec3 graph_normal(const GeometrySettings& surface, const Vec3& x) {
  const double h = 1e-5 * std::max(1e-3, x.norm());
  const double zx = height(surface, x.x() + h, x.y()) - height(surface, x.x() - h, x.y());
  const double zy = height(surface, x.x(), x.y() + h) - height(surface, x.x(), x.y() - h);
  return Vec3(-zx, -zy, 2 * h).normalized();
}

/// A function that is zero on the surface, and its gradient.
struct Residual {
  double value;
  Vec3 gradient;
};

Residual residual(const GeometrySettings& surface, const Vec3& x) {
  switch (surface.kind) {
    case Kind::plane:
      return {(x - surface.point).dot(surface.axis.normalized()), surface.axis.normalized()};
    case Kind::graph: {
      const Vec3 n = graph_normal(surface, x);
      return {(x.z() - height(surface, x.x(), x.y())) * n.z(), n};
    }
    case Kind::formula: {
      const Vec3 g = gradient_of(surface.zero, x);
      if (!(g.norm() > 0))
        throw InputError("'{}' has no gradient at ({:.6g}, {:.6g}, {:.6g})", surface.zero.text(),
                         x.x(), x.y(), x.z());
      return {value_of(surface.zero, x) / g.norm(), g.normalized()};
    }
    case Kind::cone: {
      const Vec3 n = turned_from_axis(surface, x, surface.angle + 90);
      return {(x - surface.point).dot(n), n};
    }
    case Kind::torus: {
      const Vec3 d = arm_in_tube(surface, x);
      return {d.norm() - surface.tube_radius, d.normalized()};
    }
    case Kind::cylinder:
    case Kind::sphere:
      break;
  }
  const Vec3 d = arm(surface, x);
  return {d.norm() - surface.radius, d.normalized()};
}

}  // namespace

Vec3 project(std::span<const GeometrySettings* const> surfaces, const Vec3& start) {
  constexpr int most_steps = 50;
  const auto n = static_cast<Eigen::Index>(surfaces.size());
  const double size = std::max(1e-3, start.norm());
  Vec3 x = start;
  for (int step = 0; step < most_steps; ++step) {
    MatrixX G(n, 3);
    VectorX g(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Residual r = residual(*surfaces[static_cast<std::size_t>(i)], x);
      G.row(i) = r.gradient.transpose();
      g(i) = r.value;
    }
    const Vec3 move = -G.completeOrthogonalDecomposition().solve(g);
    if (!move.allFinite() || move.norm() > 10 * size) break;
    x += move;
    // a step this short is rounding: gradients by differences have ten digits, so it converges fast
    if (move.norm() <= 1e-15 * size || (step > 4 && move.norm() <= 1e-14 * size)) return x;
  }
  throw InputError("the surfaces of the vertex at ({:.6g}, {:.6g}, {:.6g}) do not meet near it",
                   start.x(), start.y(), start.z());
}

Vec3 project(const GeometrySettings& surface, const Vec3& x) {
  switch (surface.kind) {
    case Kind::graph:
      return {x.x(), x.y(), height(surface, x.x(), x.y())};
    case Kind::plane: {
      const Vec3 n = surface.axis.normalized();
      return x - (x - surface.point).dot(n) * n;
    }
    case Kind::formula: {
      const GeometrySettings* const one = &surface;
      return project(std::span(&one, 1), x);
    }
    case Kind::cone: {
      if (x == surface.point) return x;  // the apex
      const Vec3 along = turned_from_axis(surface, x, surface.angle);
      return surface.point + std::max(0.0, (x - surface.point).dot(along)) * along;
    }
    case Kind::torus: {
      const Vec3 d = arm_in_tube(surface, x);
      return x + (surface.tube_radius / d.norm() - 1) * d;
    }
    case Kind::cylinder:
    case Kind::sphere:
      break;
  }
  const Vec3 d = arm(surface, x);
  return x + (surface.radius / d.norm() - 1) * d;
}

Eigen::Matrix<double, 3, Eigen::Dynamic> directions_on(
    std::span<const GeometrySettings* const> surfaces, const Vec3& x) {
  Eigen::Matrix<double, 3, Eigen::Dynamic> normals(3, static_cast<Eigen::Index>(surfaces.size()));
  for (Eigen::Index i = 0; i < normals.cols(); ++i)
    normals.col(i) = residual(*surfaces[static_cast<std::size_t>(i)], x).gradient;
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 3, Eigen::Dynamic>> qr(normals);
  qr.setThreshold(1e-6);
  const Mat3 Q = qr.householderQ();
  return Q.rightCols(3 - qr.rank());
}

Vec3 outward_normal(const GeometrySettings& surface, const Vec3& x) {
  if (surface.kind == Kind::graph) return graph_normal(surface, x);
  return residual(surface, x).gradient;
}

}  // namespace limes
