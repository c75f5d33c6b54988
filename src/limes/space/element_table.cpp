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

/// Keeps the functions that are felt somewhere on the element.
void keep_active(const Values& all, ElementTable& table) {
  for (Eigen::Index a = 0; a < all.N.cols(); ++a)
    if (all.N.col(a).cwiseAbs().maxCoeff() > 0 || all.Nu.col(a).cwiseAbs().maxCoeff() > 0)
      table.active.push_back(static_cast<int>(a));
  const auto k = static_cast<Eigen::Index>(table.active.size());
  for (MatrixX* m : {&table.N, &table.Nu, &table.Nv})
    m->resize(all.N.rows(), k);
  for (Eigen::Index j = 0; j < k; ++j) {
    const int a = table.active[static_cast<std::size_t>(j)];
    table.N.col(j) = all.N.col(a);
    table.Nu.col(j) = all.Nu.col(a);
    table.Nv.col(j) = all.Nv.col(a);
  }
}

}  // namespace

ElementTable quadrature_table(const ElementShape& shape, const ElementQuadrature& quadrature) {
  const LimitBasis& g = *shape.geometry;
  const LimitBasis& f = *shape.field;
  const auto tiles =
      element_tiles({{&g.kinds(), g.kind(shape.face)}, {&f.kinds(), f.kind(shape.face)}},
                    g.topology().face_size(shape.face), shape.corner, quadrature.depth);
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
  const Values geometry = evaluate(g, shape.face, shape.corner, table.uv);
  table.G = geometry.N;
  table.Gu = geometry.Nu;
  table.Gv = geometry.Nv;
  keep_active(evaluate(f, shape.face, shape.corner, table.uv), table);
  return table;
}

ElementTable sample_table(const ElementShape& shape, const std::vector<Vec2>& points) {
  ElementTable table;
  table.uv.resize(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    table.uv.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  const Values geometry = evaluate(*shape.geometry, shape.face, shape.corner, table.uv);
  table.G = geometry.N;
  table.Gu = geometry.Nu;
  table.Gv = geometry.Nv;
  const Values field = evaluate(*shape.field, shape.face, shape.corner, table.uv);
  table.N = field.N;
  table.Nu = field.Nu;
  table.Nv = field.Nv;
  return table;
}

}  // namespace limes
