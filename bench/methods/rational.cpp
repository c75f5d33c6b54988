#include "rational.h"

#include <tuple>
#include <utility>

#include "limes/core/error.h"

namespace bench {

using namespace limes;

namespace {

/// Numerators in the parameters of the child that holds the point, and that child.
int descend(RationalPoint& p) {
  const std::int64_t q = p.denominator;
  const bool right = 2 * p.u > q;
  const bool top = 2 * p.v > q;
  const int child = right ? (top ? 2 : 1) : (top ? 3 : 0);
  const std::int64_t u = p.u;
  const std::int64_t v = p.v;
  if (child == 0) p = {2 * u, 2 * v, q};
  if (child == 1) p = {2 * v, 2 * (q - u), q};
  if (child == 2) p = {2 * (q - u), 2 * (q - v), q};
  if (child == 3) p = {2 * (q - v), 2 * u, q};
  return child;
}

/// The left eigenvector of M for the eigenvalue 1, with sum 1. M^(2^k) tends to 1 l^T; its rows are
/// kept at sum 1, which rounding would otherwise double in every step.
Eigen::RowVectorXd dominant_left(MatrixX M) {
  double spread = (M.rowwise() - M.row(0)).cwiseAbs().maxCoeff();
  while (spread > 0) {
    M = (M * M).eval();
    for (Eigen::Index i = 0; i < M.rows(); ++i)
      M.row(i) /= M.row(i).sum();
    const double smaller = (M.rowwise() - M.row(0)).cwiseAbs().maxCoeff();
    if (smaller < 1e-15 && smaller >= spread) break;  // rounding
    spread = smaller;
  }
  return M.row(0);
}

}  // namespace

int RationalEvaluator::kind_of(const Ring& ring) {
  const auto [it, added] = index_.emplace(ring_key(ring), static_cast<int>(kinds_.size()));
  if (added) kinds_.push_back(std::make_unique<Kind>(Kind{ring, {}}));
  return it->second;
}

const std::pair<int, MatrixX>& RationalEvaluator::child_of(int kind, int child) {
  Kind& at = *kinds_[static_cast<std::size_t>(kind)];
  const auto found = at.children.find(child);
  if (found != at.children.end()) return found->second;
  RefinedRing below = refine_ring(at.ring, *scheme_, child);
  const int below_kind = kind_of(below.ring);
  return at.children[child] = {below_kind, std::move(below.A)};
}

VectorX RationalEvaluator::weights(const Ring& ring, int corner, const RationalPoint& point) {
  std::map<std::tuple<int, std::int64_t, std::int64_t>, std::size_t> seen;
  std::vector<const MatrixX*> steps;
  RationalPoint p = point;
  int kind = kind_of(ring);
  if (ring.topology.face_size(FaceId(0)) != 4) {
    const auto& [below, A] = child_of(kind, corner);
    steps.push_back(&A);
    kind = below;
  }
  std::size_t period_start = 0;
  for (;;) {
    const auto [it, added] = seen.emplace(std::tuple(kind, p.u, p.v), steps.size());
    if (!added) {
      period_start = it->second;
      break;
    }
    const auto& [below, A] = child_of(kind, descend(p));
    steps.push_back(&A);
    kind = below;
  }
  last_period_ = static_cast<int>(steps.size() - period_start);
  MatrixX M = *steps[period_start];
  for (std::size_t i = period_start + 1; i < steps.size(); ++i)
    M = (*steps[i] * M).eval();
  Eigen::RowVectorXd row = dominant_left(std::move(M));
  for (std::size_t i = period_start; i-- > 0;)
    row = (row * *steps[i]).eval();
  return row.transpose();
}

std::size_t RationalEvaluator::memory() const {
  Eigen::Index numbers = 0;
  for (const auto& kind : kinds_)
    for (const auto& [child, below] : kind->children)
      numbers += below.second.size();
  return static_cast<std::size_t>(numbers) * sizeof(double);
}

}  // namespace bench
