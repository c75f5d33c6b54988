#include "limes/limit/limit_surface.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

/// a x b as a unit vector, unless the two are parallel to rounding.
std::optional<Vec3> unit_normal(const Vec3& a, const Vec3& b) {
  const Vec3 n = a.cross(b);
  const double scale = a.norm() * b.norm();
  if (!(n.norm() > 1e-14 * scale)) return {};
  return n.normalized();
}

/// Mean and Gauss curvature from the first and second fundamental forms.
SurfacePoint::Curvature curvature(const SurfacePoint::First& d, const SurfacePoint::Second& dd,
                                  const Vec3& n) {
  const double E = d.xu.squaredNorm();
  const double F = d.xu.dot(d.xv);
  const double G = d.xv.squaredNorm();
  const double e = dd.xuu.dot(n);
  const double f = dd.xuv.dot(n);
  const double g = dd.xvv.dot(n);
  const double area2 = E * G - F * F;
  return {.mean = -(e * G - 2.0 * f * F + g * E) / (2.0 * area2), .gauss = (e * g - f * f) / area2};
}

/// Control points of a face, relative to the first: no digits are lost far from the origin.
struct ControlPoints {
  ControlPoints(std::span<const VertexId> ids, std::span<const Vec3> points)
      : origin(points[static_cast<std::size_t>(ids[0].value)]),
        relative(static_cast<Eigen::Index>(ids.size()), 3) {
    Eigen::Index row = 0;
    for (const VertexId v : ids)
      relative.row(row++) = (points[static_cast<std::size_t>(v.value)] - origin).transpose();
  }
  [[nodiscard]] Vec3 position(const BasisAt& basis) const {
    return relative.transpose() * basis.N + origin;
  }

  Vec3 origin;
  Eigen::Matrix<double, Eigen::Dynamic, 3> relative;
};

}  // namespace

LimitSurface::LimitSurface(const LimitBasis& basis, std::span<const Vec3> points)
    : basis_(&basis), points_(points) {
  LIMES_ASSERT(static_cast<int>(points.size()) == basis.topology().num_vertices());
}

Vec3 LimitSurface::position(FaceId f, int corner, const Vec2& uv) const {
  BasisAt basis;
  basis_->evaluate(f, corner, uv, 0, basis);
  return ControlPoints(basis_->controls(f), points_).position(basis);
}

SurfacePoint LimitSurface::evaluate(FaceId f, int corner, const Vec2& uv) const {
  BasisAt basis;
  const LimitBasis::Point kind = basis_->evaluate(f, corner, uv, 2, basis);
  const ControlPoints control(basis_->controls(f), points_);
  SurfacePoint out;
  out.x = control.position(basis);
  if (kind == LimitBasis::Point::extraordinary) {
    const auto tangents = basis_->tangent_rows(f, corner, uv);
    if (tangents) {
      const Eigen::Matrix<double, 2, 3> t = *tangents * control.relative;
      out.normal = unit_normal(t.row(0), t.row(1));
    }
    return out;
  }
  const Eigen::Matrix<double, 2, 3> d = basis.dN.transpose() * control.relative;
  const Mat3 dd = basis.ddN.transpose() * control.relative;
  out.first = {d.row(0).transpose(), d.row(1).transpose()};
  out.second = {dd.row(0).transpose(), dd.row(1).transpose(), dd.row(2).transpose()};
  out.normal = unit_normal(out.first->xu, out.first->xv);
  if (out.normal) out.curvature = curvature(*out.first, *out.second, *out.normal);
  return out;
}

IdArray<VertexId, Vec3> limit_positions(const LimitSurface& surface, std::span<const Vec3> points) {
  const LimitBasis& basis = surface.basis();
  const Adjacency& adjacency = basis.adjacency();
  IdArray<VertexId, Vec3> limits(std::vector<Vec3>(points.begin(), points.end()));
  for_each_index(limits.size(), [&](std::int64_t i) {
    const VertexId v(i);
    const HalfedgeId h = adjacency.ring_start(v);
    if (!h.valid()) return;
    const FaceId f = adjacency.face(h);
    const int c = adjacency.corner_index(h);
    static const std::array<Vec2, 4> corners{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    const bool quad = basis.topology().face_size(f) == 4;
    limits[v] = quad ? surface.position(f, 0, corners[static_cast<std::size_t>(c)])
                     : surface.position(f, c, Vec2(0, 0));
  });
  return limits;
}

}  // namespace limes
