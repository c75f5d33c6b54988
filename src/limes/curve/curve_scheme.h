#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limes/core/types.h"

namespace limes {

/// How much an old point contributes to which new points: new point j gets weights[j - 2 i - first] of old
/// point i. The coefficients of the scheme's symbol, sum a_k z^k; they add up to 2.
struct CurveMask {
  std::vector<double> weights;
  int first;  ///< k of the first coefficient

  /// Every old point has a new one in its place; otherwise the new points lie between.
  [[nodiscard]] bool is_primal() const { return weights.size() % 2 == 1; }
  /// The weights that make new points: one for the even, one for the odd.
  [[nodiscard]] std::vector<double> stencil(int parity) const;
};

/// A subdivision scheme for curves: a symmetric mask, which says everything.
struct CurveScheme {
  std::string name;
  std::string summary;
  CurveMask mask;
  int fewest_open;    ///< points that an open control polygon must have
  int fewest_closed;  ///< and a closed one
};

/// Uniform B-splines of a degree 1 to most_degree [lane_riesenfeld_1980]: binomial coefficients. Even degrees
/// are dual, 2 is Chaikin's corner cutting.
[[nodiscard]] CurveScheme lane_riesenfeld(int degree);
inline constexpr int most_degree = 20;
/// The four-point scheme [dyn_1987]. @param tension  16 omega; 1 reproduces cubics, 0 is linear
[[nodiscard]] CurveScheme four_point(double tension = 1.0);

/// Whether a name is one of curve schemes: four-point, chaikin, lane-riesenfeld:D (any D).
[[nodiscard]] bool is_curve_scheme(std::string_view name);
/// @param tension  of four-point
/// @throws UsageError for another name or a degree that is not possible
[[nodiscard]] CurveScheme find_curve_scheme(std::string_view name, double tension = 1.0);

/// Names and what they mean, for lists.
[[nodiscard]] std::vector<CurveScheme> all_curve_schemes();

}  // namespace limes
