#include "limes/space/element_table.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/math/quadrature.h"

namespace limes {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Values of one set of functions at all points.
struct Values {
  MatrixX N, Nu, Nv;

  Values(Eigen::Index points, Eigen::Index functions)
      : N(points, functions), Nu(points, functions), Nv(points, functions) {}

  void set_derivatives(Eigen::Index i, const BasisAt& at) {
    Nu.row(i) = at.dN.col(0).transpose();
    Nv.row(i) = at.dN.col(1).transpose();
  }
};

struct GeometryAndField {
  Values geometry, field;
};

/// The nearest point at which the derivatives exist.
Vec2 inside(const Vec2& uv) {
  const double step = std::ldexp(1.0, -20);
  return uv + step * (Vec2(0.5, 0.5) - uv).cwiseSign();
}

/// Where the derivatives of one do not exist, those of both are taken inside.
GeometryAndField evaluate(const ElementShape& shape, const Points& uv) {
  const auto num_functions = [&](const LimitBasis& basis) {
    return static_cast<Eigen::Index>(basis.controls(shape.face).size());
  };
  GeometryAndField out{{uv.rows(), num_functions(*shape.geometry)},
                       {uv.rows(), num_functions(*shape.field)}};
  BasisAt geometry, field;
  const auto evaluate_both = [&](const Vec2& point) {
    const auto a = shape.geometry->evaluate(shape.face, shape.corner, point, 1, geometry);
    const auto b = shape.field->evaluate(shape.face, shape.corner, point, 1, field);
    return a == LimitBasis::Point::ordinary && b == LimitBasis::Point::ordinary;
  };
  for (Eigen::Index i = 0; i < uv.rows(); ++i) {
    const Vec2 point = uv.row(i).transpose();
    const bool ordinary = evaluate_both(point);
    out.geometry.N.row(i) = geometry.N.transpose();
    out.field.N.row(i) = field.N.transpose();
    if (!ordinary) {
      const bool now = evaluate_both(inside(point));
      LIMES_ASSERT(now);
    }
    out.geometry.set_derivatives(i, geometry);
    out.field.set_derivatives(i, field);
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
  GeometryAndField all = evaluate(shape, table.uv);
  set_geometry(std::move(all.geometry), table);
  set_field(all.field, felt(all.field), table);
  return table;
}

ElementTable sample_table(const ElementShape& shape, const std::vector<Vec2>& points,
                          const std::vector<int>& active) {
  ElementTable table;
  table.uv.resize(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    table.uv.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  GeometryAndField all = evaluate(shape, table.uv);
  set_geometry(std::move(all.geometry), table);
  set_field(all.field, active, table);
  return table;
}

}  // namespace limes
