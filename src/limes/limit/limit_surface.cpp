#include "limes/limit/limit_surface.h"

#include <array>
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

SurfacePoint ordinary_point(const Vec3& x, const SurfacePoint::First& first,
                            const SurfacePoint::Second& second) {
  SurfacePoint out;
  out.x = x;
  out.first = first;
  out.second = second;
  out.normal = unit_normal(first.xu, first.xv);
  if (out.normal) out.curvature = curvature(first, second, *out.normal);
  return out;
}

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
  if (kind == LimitBasis::Point::extraordinary) {
    SurfacePoint out;
    out.x = control.position(basis);
    const auto tangents = basis_->tangent_rows(f, corner, uv);
    if (tangents) {
      const Eigen::Matrix<double, 2, 3> t = *tangents * control.relative;
      out.normal = unit_normal(t.row(0), t.row(1));
    }
    return out;
  }
  const Eigen::Matrix<double, 2, 3> d = basis.dN.transpose() * control.relative;
  const Mat3 dd = basis.ddN.transpose() * control.relative;
  return ordinary_point(control.position(basis), {d.row(0).transpose(), d.row(1).transpose()},
                        {dd.row(0).transpose(), dd.row(1).transpose(), dd.row(2).transpose()});
}

namespace {

/// Weights of the limit at corners of faces, computed once for each kind and corner that is asked for.
class CornerWeights {
 public:
  explicit CornerWeights(const LimitBasis& basis) : basis_(basis) {}

  void prepare(FaceId f, int c) {
    const auto kind = static_cast<std::size_t>(basis_.kind(f));
    if (kind >= weights_.size()) weights_.resize(kind + 1);
    weights_[kind].resize(static_cast<std::size_t>(basis_.topology().face_size(f)));
    VectorX& w = weights_[kind][static_cast<std::size_t>(c)];
    if (w.size() == 0) w = corner_weights(f, c);
  }

  /// Precondition: prepared.
  [[nodiscard]] Vec3 position(FaceId f, int c, std::span<const Vec3> points) const {
    const VectorX& w =
        weights_[static_cast<std::size_t>(basis_.kind(f))][static_cast<std::size_t>(c)];
    const auto ids = basis_.controls(f);
    // Relative to the first control point, as everywhere.
    const Vec3 origin = points[static_cast<std::size_t>(ids[0].value)];
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < ids.size(); ++k)
      sum += w[static_cast<Eigen::Index>(k)] *
             (points[static_cast<std::size_t>(ids[k].value)] - origin);
    return sum + origin;
  }

 private:
  [[nodiscard]] VectorX corner_weights(FaceId f, int c) const {
    const auto [quadrant, uv] = basis_.corner(f, c);
    BasisAt at;
    basis_.evaluate(f, quadrant, uv, 0, at);
    return at.N;
  }

  const LimitBasis& basis_;
  std::vector<std::vector<VectorX>> weights_;  // by kind and corner
};

}  // namespace

IdArray<VertexId, Vec3> limit_positions(const LimitSurface& surface, std::span<const Vec3> points) {
  const Adjacency& adjacency = surface.basis().adjacency();
  IdArray<VertexId, Vec3> limits(std::vector<Vec3>(points.begin(), points.end()));
  const auto for_each_used = [&](std::int64_t i, const auto& use) {
    const HalfedgeId h = adjacency.ring_start(VertexId(i));
    if (h.valid()) use(adjacency.face(h), adjacency.corner_index(h));
  };
  CornerWeights weights(surface.basis());
  for (int i = 0; i < limits.size(); ++i)
    for_each_used(i, [&](FaceId f, int c) { weights.prepare(f, c); });
  for_each_index(limits.size(), [&](std::int64_t i) {
    for_each_used(i,
                  [&](FaceId f, int c) { limits[VertexId(i)] = weights.position(f, c, points); });
  });
  return limits;
}

}  // namespace limes
