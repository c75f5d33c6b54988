#include "limes/space/element_table.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/math/quadrature.h"

namespace limes {
namespace {

/// Values of one set of functions at all points.
struct Values {
  MatrixX N, Nu, Nv;
};

/// The nearest point at which the derivatives exist.
Vec2 inside(const Vec2& uv) {
  const double step = std::ldexp(1.0, -20);
  return uv + step * (Vec2(0.5, 0.5) - uv).cwiseSign();
}

Values evaluate(const LimitBasis& basis, FaceId f, int corner,
                const Eigen::Matrix<double, Eigen::Dynamic, 2>& uv) {
  const auto k = static_cast<Eigen::Index>(basis.controls(f).size());
  Values out{MatrixX(uv.rows(), k), MatrixX(uv.rows(), k), MatrixX(uv.rows(), k)};
  BasisAt at;
  for (Eigen::Index i = 0; i < uv.rows(); ++i) {
    const Vec2 point = uv.row(i).transpose();
    const auto kind = basis.evaluate(f, corner, point, 1, at);
    out.N.row(i) = at.N.transpose();
    if (kind == LimitBasis::Point::extraordinary) {
      const auto again = basis.evaluate(f, corner, inside(point), 1, at);
      LIMES_ASSERT(again == LimitBasis::Point::ordinary);
    }
    out.Nu.row(i) = at.dN.col(0).transpose();
    out.Nv.row(i) = at.dN.col(1).transpose();
  }
  return out;
}

/// The functions that are felt somewhere on the element.
std::vector<int> felt(const Values& all) {
  std::vector<int> active;
  for (Eigen::Index a = 0; a < all.N.cols(); ++a)
    if (all.N.col(a).cwiseAbs().maxCoeff() > 0 || all.Nu.col(a).cwiseAbs().maxCoeff() > 0 ||
        all.Nv.col(a).cwiseAbs().maxCoeff() > 0)
      active.push_back(static_cast<int>(a));
  return active;
}

MatrixX columns(const MatrixX& all, const std::vector<int>& chosen) {
  MatrixX out(all.rows(), static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t j = 0; j < chosen.size(); ++j)
    out.col(static_cast<Eigen::Index>(j)) = all.col(chosen[j]);
  return out;
}

void set_geometry(Values values, ElementTable& table) {
  table.G = std::move(values.N);
  table.Gu = std::move(values.Nu);
  table.Gv = std::move(values.Nv);
}

void set_field(const Values& all, std::vector<int> active, ElementTable& table) {
  table.N = columns(all.N, active);
  table.Nu = columns(all.Nu, active);
  table.Nv = columns(all.Nv, active);
  table.active = std::move(active);
}

}  // namespace

ElementTable quadrature_table(const ElementShape& shape, const ElementQuadrature& quadrature) {
  const auto tiles = element_tiles(shape, quadrature.depth);
  const QuadratureRule rule = gauss_rule(quadrature.points);
  const auto n = rule.point.size();
  ElementTable table;
  table.uv.resize(static_cast<Eigen::Index>(tiles.size() * n * n), 2);
  table.weight.resize(table.uv.rows());
  Eigen::Index row = 0;
  for (const ParameterTile& t : tiles)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i, ++row) {
        table.uv.row(row) << t.origin.x() + t.size * rule.point[i],
            t.origin.y() + t.size * rule.point[j];
        table.weight(row) = t.size * t.size * rule.weight[i] * rule.weight[j];
      }
  set_geometry(evaluate(*shape.geometry, shape.face, shape.corner, table.uv), table);
  const Values field = evaluate(*shape.field, shape.face, shape.corner, table.uv);
  set_field(field, felt(field), table);
  return table;
}

ElementTable sample_table(const ElementShape& shape, const std::vector<Vec2>& points,
                          const std::vector<int>& active) {
  ElementTable table;
  table.uv.resize(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    table.uv.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  set_geometry(evaluate(*shape.geometry, shape.face, shape.corner, table.uv), table);
  set_field(evaluate(*shape.field, shape.face, shape.corner, table.uv), active, table);
  return table;
}

}  // namespace limes
