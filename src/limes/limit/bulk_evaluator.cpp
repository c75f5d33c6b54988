#include "limes/limit/bulk_evaluator.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "limes/core/error.h"
#include "limes/core/parallel.h"

namespace limes {

BulkEvaluator::BulkEvaluator(const LimitBasis& basis, std::span<const Vec3> points)
    : basis_(&basis) {
  update(points);
}

void BulkEvaluator::update(std::span<const Vec3> points) {
  LIMES_ASSERT(static_cast<int>(points.size()) == basis_->topology().num_vertices());
  points_.assign(points.begin(), points.end());
}

LimitBasis::Point BulkEvaluator::evaluate(const SurfaceLocation& where, int order,
                                          SurfaceJet& out) const {
  BasisAt at;
  const LimitBasis::Point kind = basis_->evaluate(where.face, where.corner, where.uv, order, at);
  const auto controls = basis_->controls(where.face);
  // Relative to the first control point: no digits are lost far from the origin.
  const Vec3 origin = points_[static_cast<std::size_t>(controls[0].value)];
  const auto combine = [&](const auto& weights) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < controls.size(); ++k)
      sum += weights[static_cast<Eigen::Index>(k)] *
             (points_[static_cast<std::size_t>(controls[k].value)] - origin);
    return sum;
  };
  out.x = origin + combine(at.N);
  if (kind == LimitBasis::Point::extraordinary) {
    const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    if (order >= 1) out.xu = out.xv = none;
    if (order >= 2) out.xuu = out.xuv = out.xvv = none;
    return kind;
  }
  if (order >= 1) {
    out.xu = combine(at.dN.col(0));
    out.xv = combine(at.dN.col(1));
  }
  if (order >= 2) {
    out.xuu = combine(at.ddN.col(0));
    out.xuv = combine(at.ddN.col(1));
    out.xvv = combine(at.ddN.col(2));
  }
  return kind;
}

void BulkEvaluator::evaluate(std::span<const SurfaceLocation> where, int order,
                             SurfaceValues& out) const {
  LIMES_ASSERT(order >= 0 && order <= 2);
  const std::size_t n = where.size();
  out.x.resize(n);
  for (auto* values : {&out.xu, &out.xv})
    values->resize(order >= 1 ? n : 0);
  for (auto* values : {&out.xuu, &out.xuv, &out.xvv})
    values->resize(order >= 2 ? n : 0);
  out.extraordinary.clear();
  std::mutex mutex;
  for_each_index(static_cast<std::int64_t>(n), [&](std::int64_t index) {
    const auto i = static_cast<std::size_t>(index);
    SurfaceJet jet;
    const LimitBasis::Point kind = evaluate(where[i], order, jet);
    out.x[i] = jet.x;
    if (order >= 1) {
      out.xu[i] = jet.xu;
      out.xv[i] = jet.xv;
    }
    if (order >= 2) {
      out.xuu[i] = jet.xuu;
      out.xuv[i] = jet.xuv;
      out.xvv[i] = jet.xvv;
    }
    if (kind == LimitBasis::Point::extraordinary) {
      const std::lock_guard lock(mutex);
      out.extraordinary.push_back(index);
    }
  });
  std::sort(out.extraordinary.begin(), out.extraordinary.end());
}

}  // namespace limes
