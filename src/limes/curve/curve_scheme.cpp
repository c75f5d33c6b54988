#include "limes/curve/curve_scheme.h"

#include <fmt/format.h>

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/text.h"

namespace limes {
namespace {
constexpr std::string_view lane_riesenfeld_name = "lane-riesenfeld";
}

std::vector<double> CurveMask::stencil(int parity) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if ((first + static_cast<int>(i) - parity) % 2 == 0) result.push_back(weights[i]);
  return result;
}

CurveScheme lane_riesenfeld(int degree) {
  if (degree < 1 || degree > most_degree)
    throw UsageError("--scheme: there is no lane-riesenfeld:{}; degrees are 1 to {}", degree,
                     most_degree);
  // Every point twice, then `degree` times the means of neighbours: (1 + z) ((1 + z) / 2)^degree.
  std::vector<double> mask{1, 1};
  for (int i = 0; i < degree; ++i) {
    mask.push_back(0);
    for (std::size_t k = mask.size() - 1; k > 0; --k)
      mask[k] = (mask[k] + mask[k - 1]) / 2;
    mask[0] /= 2;
  }
  const bool primal = degree % 2 == 1;
  return {fmt::format("{}:{}", lane_riesenfeld_name, degree),
          fmt::format("uniform B-spline of degree {}, C{}", degree, degree - 1),
          {std::move(mask), primal ? -(degree + 1) / 2 : -degree / 2},
          primal ? 2 : degree + 1,
          3};
}

CurveScheme four_point(double tension) {
  const double omega = tension / 16;
  return {"four-point",
          "interpolates the points, C1; tension 1 reproduces cubics",
          {{-omega, 0, 0.5 + omega, 1, 0.5 + omega, 0, -omega}, -3},
          2,
          3};
}

bool is_curve_scheme(std::string_view name) {
  return name == "four-point" || name == "chaikin" || name == lane_riesenfeld_name ||
         name.starts_with(fmt::format("{}:", lane_riesenfeld_name));
}

CurveScheme find_curve_scheme(std::string_view name, double tension) {
  if (name == "four-point") return four_point(tension);
  if (name == "chaikin") {
    CurveScheme chaikin = lane_riesenfeld(2);
    chaikin.name = name;
    chaikin.summary = "cuts corners: uniform B-spline of degree 2, C1";
    return chaikin;
  }
  if (!is_curve_scheme(name))
    throw UsageError(
        "there is no curve scheme {}; known are four-point, chaikin, lane-riesenfeld:D",
        quote(name));
  const std::string_view digits =
      name.substr(std::min(name.size(), lane_riesenfeld_name.size() + 1));
  const auto degree = parse_integer(digits);
  if (!degree || *degree < 1 || *degree > most_degree)
    throw UsageError("--scheme: {} has no degree from 1 to {}; lane-riesenfeld:3 is cubic",
                     quote(name), most_degree);
  return lane_riesenfeld(static_cast<int>(*degree));
}

std::vector<CurveScheme> all_curve_schemes() {
  return {four_point(),       find_curve_scheme("chaikin"), lane_riesenfeld(1),
          lane_riesenfeld(3), lane_riesenfeld(4),           lane_riesenfeld(5)};
}

}  // namespace limes
