#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "refined_ring.h"

namespace bench {

/// A point of a face with rational parameters (u, v) = (p / q, r / q).
struct RationalPoint {
  std::int64_t u, v;         ///< numerators, 0 <= u, v <= denominator
  std::int64_t denominator;  ///< 1 to 2^61
};

/// Exact evaluation at rational parameters [schaefer_warren_2007], for any scheme that is a matrix,
/// polynomial or not, at any feature.
///
/// The sub-faces that hold a rational point, one in the other, repeat from some level on: so do the
/// rings and the matrices that lead from one to the next. Let M be the product of the matrices of
/// one period. The controls after k periods, M^k P, tend to the surface's point, all of them: M has
/// the eigenvalue 1 with a constant right eigenvector, and the point is the left one, with sum 1,
/// times the controls at the period's start.
class RationalEvaluator {
 public:
  explicit RationalEvaluator(const limes::Scheme& scheme) : scheme_(&scheme) {}

  /// Weights of the ring's controls, with sum 1, that give the limit position.
  /// @param corner  quadrant of a face that is no quad, where (0, 0) is at that corner; else 0
  [[nodiscard]] limes::VectorX weights(const limes::Ring& ring, int corner,
                                       const RationalPoint& point);

  /// Length of the period of the last point, in levels.
  [[nodiscard]] int last_period() const { return last_period_; }
  [[nodiscard]] std::size_t memory() const;  ///< bytes of the matrices found so far

 private:
  struct Kind {
    limes::Ring ring;
    std::map<int, std::pair<int, limes::MatrixX>> children;  ///< child -> kind, A
  };
  int kind_of(const limes::Ring& ring);
  const std::pair<int, limes::MatrixX>& child_of(int kind, int child);

  const limes::Scheme* scheme_;
  std::map<std::string, int> index_;
  std::vector<std::unique_ptr<Kind>> kinds_;
  int last_period_ = 0;
};

}  // namespace bench
