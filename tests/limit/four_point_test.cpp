#include "limes/limit/four_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace limes {
namespace {

double parse_fraction(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return std::stod(text);
  return std::stod(text.substr(0, slash)) / std::stod(text.substr(slash + 1));
}

/// The exact fractions of tests/data/interpolatory/limit.json, found from the fixed vectors of
/// products of matrices.
TEST(FourPoint, HasTheExactWeightsAtRationalParameters) {
  std::ifstream in(std::string(LIMES_TEST_DATA_DIR) + "/interpolatory/limit.json");
  const auto golden = nlohmann::json::parse(in);
  int count = 0;
  for (const auto& [key, weights] : golden.items()) {
    if (!key.starts_with("w(")) continue;
    const double t = parse_fraction(key.substr(2, key.size() - 3));
    const SixWeights w = four_point_value(t, 1.0 / 16.0);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(w(i), parse_fraction(weights[static_cast<std::size_t>(i)]), 1e-15) << key;
    ++count;
  }
  EXPECT_EQ(count, 9);
}

TEST(FourPoint, ReproducesCubicsAndTheirDerivatives) {
  const auto f = [](double t) { return ((2.0 * t - 3.0) * t + 0.7) * t - 1.1; };
  const auto df = [](double t) { return (6.0 * t - 6.0) * t + 0.7; };
  VectorX values(6);
  for (int i = 0; i < 6; ++i)
    values(i) = f(i - 2.0);
  for (const double t : {0.0, 1e-30, 0.1, 1.0 / 3.0, 0.5, 0.7, 0.999, 1.0}) {
    EXPECT_NEAR(four_point_value(t, 1.0 / 16.0).dot(values), f(t), 1e-14) << t;
    EXPECT_NEAR(four_point_derivative(t, 1.0 / 16.0).dot(values), df(t), 2e-14) << t;
  }
}

/// For other tensions: difference quotients of the values.
TEST(FourPoint, DerivativeIsThatOfTheValues) {
  VectorX values(6);
  values << 1, -2, 0.5, 3, -1, 2;
  for (const double omega : {0.03, 1.0 / 16.0, 0.09})
    for (const double t : {0.11, 0.4, 0.73}) {
      // C1 only: the quotient tends to the derivative with a power of h below one.
      const double h = 1e-6;
      const double quotient =
          (four_point_value(t + h, omega) - four_point_value(t - h, omega)).dot(values) / (2 * h);
      EXPECT_NEAR(four_point_derivative(t, omega).dot(values), quotient, 2e-3) << omega << ' ' << t;
    }
}

}  // namespace
}  // namespace limes
