#include "limes/fem/load.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/fem/assemble.h"
#include "limes/fem/element_points.h"
#include "limes/math/quadrature.h"

namespace limes {
namespace {

constexpr int side_points = 5;   // per piece
constexpr int side_pieces = 16;  // towards each end, where functions are no single polynomial

/// Point, tangent d/ds and field functions on a side.
struct OnSide {
  Vec3 x;
  Vec2 tangent;
  BasisAt field;
};

OnSide on_side(const SubdivisionSpace& space, HalfedgeId h, double s) {
  const LimitBasis& geometry = space.geometry();
  const FaceId f = geometry.adjacency().face(h);
  const SidePoint p = side_point(geometry, h, s);
  OnSide out;
  BasisAt basis;
  geometry.evaluate(f, p.corner, p.uv, 1, basis);
  const auto controls = geometry.controls(f);
  out.x.setZero();
  out.tangent.setZero();
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const Vec3& c = space.mesh().points[controls[i]];
    const auto k = static_cast<Eigen::Index>(i);
    out.x += basis.N(k) * c;
    out.tangent += basis.dN.row(k).dot(p.direction) * c.head<2>();
  }
  space.field().evaluate(f, p.corner, p.uv, 0, out.field);
  return out;
}

/// Whether faces run counter-clockwise as seen in the plane.
double orientation(const SubdivisionSpace& space) {
  ElementPoints p;
  to_physical(space.table(space.elements()[0].shape), space.control_points(0), p);
  return p.J(0) > 0 ? 1.0 : -1.0;
}

void add_force(const SubdivisionSpace& space, FaceId face, const VectorX& N, const Vec2& force,
               VectorX& f) {
  const std::vector<int> dofs = space.face_dofs(face);
  for (std::size_t a = 0; a < dofs.size(); ++a)
    if (dofs[a] >= 0) f.segment<2>(2 * dofs[a]) += N(static_cast<Eigen::Index>(a)) * force;
}

VectorX no_load(const SubdivisionSpace& space) {
  return VectorX::Zero(2 * static_cast<Eigen::Index>(space.num_dofs()));
}

}  // namespace

VectorX body_load(const SubdivisionSpace& space, const std::vector<bool>& chosen,
                  const PlaneDensity& p) {
  VectorX f = no_load(space);
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    if (!chosen[static_cast<std::size_t>(e)]) continue;
    const ElementTable& table = space.table(space.elements()[static_cast<std::size_t>(e)].shape);
    ElementPoints points;
    to_physical(table, space.control_points(e), points);
    const auto dofs = space.dofs(e);
    for (Eigen::Index i = 0; i < points.J.size(); ++i) {
      const Vec2 force = std::abs(points.J(i)) * table.weight(i) * p(points.x.row(i).transpose());
      for (std::size_t a = 0; a < dofs.size(); ++a)
        f.segment<2>(2 * dofs[a]) += table.N(i, static_cast<Eigen::Index>(a)) * force;
    }
  }
  return f;
}

SideRule side_rule(const SubdivisionSpace& space, HalfedgeId h) {
  const LimitBasis& g = space.geometry();
  const LimitBasis& f = space.field();
  const FaceId face = g.adjacency().face(h);
  std::vector<double> ends{0.0, 1.0};
  if (!g.kinds()[g.kind(face)].patch || !f.kinds()[f.kind(face)].patch) {
    ends = {0.0};
    for (int k = side_pieces; k > 1; --k)
      ends.push_back(std::ldexp(1.0, -k));
    for (int k = 2; k <= side_pieces; ++k)  // the middle, where the quadrants of an n-gon meet
      ends.push_back(0.5 - std::ldexp(1.0, -k - 1));
    const std::vector<double> half = ends;
    ends.push_back(0.5);
    for (auto it = half.rbegin(); it != half.rend(); ++it)
      ends.push_back(1.0 - *it);
  }
  const QuadratureRule gauss = gauss_rule(side_points);
  SideRule rule;
  for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece)
    for (std::size_t i = 0; i < gauss.point.size(); ++i) {
      const double length = ends[piece + 1] - ends[piece];
      rule.s.push_back(ends[piece] + length * gauss.point[i]);
      rule.weight.push_back(length * gauss.weight[i]);
    }
  return rule;
}

VectorX side_load(const SubdivisionSpace& space, const std::vector<HalfedgeId>& sides,
                  const PlaneTraction& p) {
  VectorX f = no_load(space);
  const double turn = orientation(space);
  for (const HalfedgeId h : sides) {
    const SideRule rule = side_rule(space, h);
    for (std::size_t i = 0; i < rule.s.size(); ++i) {
      const OnSide at = on_side(space, h, rule.s[i]);
      const double ds = at.tangent.norm();
      const Vec2 normal = turn / ds * Vec2(at.tangent.y(), -at.tangent.x());
      add_force(space, space.geometry().adjacency().face(h), at.field.N,
                rule.weight[i] * ds * p(at.x, normal), f);
    }
  }
  return f;
}

bool add_point_load(const SubdivisionSpace& space, VertexId v, const Vec2& p, VectorX& f) {
  const ConstraintRow value = value_at_vertex(space, v);
  for (const auto& [dof, weight] : value)
    f.segment<2>(2 * dof) += weight * p;
  return !value.empty();
}

}  // namespace limes
