#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "limes/core/types.h"

namespace limes {

/// A number as a formula in x, y, z ("2 * sin(pi * x)"), or a condition ("x == 0 or y > 1"): `and`,
/// `or`, `not` besides the symbols && || !. In a condition == and != compare within a tolerance;
/// true is 1, false is 0, and `c ? a : b` chooses. Functions: expression_syntax.h.
/// Copies are cheap and share the formula; one expression must not be evaluated by two threads at
/// the same time.
class Expression {
 public:
  Expression();                       ///< the number 0
  explicit Expression(double value);  ///< a constant
  /// @param equal_within  largest difference that == takes as equal, absolute
  /// @throws InputError if the text is no formula, saying where
  explicit Expression(std::string_view text, double equal_within = 0);

  [[nodiscard]] double operator()(const Vec3& x) const;
  [[nodiscard]] bool is_zero() const;  ///< the constant 0
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  struct Formula;
  std::string text_;
  double constant_ = 0;
  std::shared_ptr<Formula> formula_;  // none: the constant
};

}  // namespace limes
