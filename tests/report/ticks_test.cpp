#include <gtest/gtest.h>

#include <cmath>

#include "limes/report/ticks.h"

namespace limes {
namespace {

using Labels = std::vector<std::string>;

TEST(Ticks, NiceNumbersInsideTheRange) {
  const Ticks t = linear_ticks(-0.04, 1.03, 6);
  EXPECT_EQ(t.labels, (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(t.exponent, 0);
  EXPECT_EQ(linear_ticks(-30, 30, 5).labels, (Labels{"−20", "0", "20"}));
  EXPECT_EQ(linear_ticks(-30, 30, 7).labels, (Labels{"−30", "−20", "−10", "0", "10", "20", "30"}));
}

TEST(Ticks, ValuesAreTheNearestDoubles) {
  const Ticks t = linear_ticks(0, 1, 11);
  ASSERT_EQ(t.values.size(), 11U);
  EXPECT_EQ(t.values[3], 0.3);
  EXPECT_EQ(t.values[7], 0.7);
  EXPECT_EQ(t.values[10], 1);
}

TEST(Ticks, CommonPowerIsSaidOnce) {
  const Ticks t = linear_ticks(0, 4.2e8, 6);
  EXPECT_EQ(t.exponent, 6);
  EXPECT_EQ(t.labels, (Labels{"0", "100", "200", "300", "400"}));
  EXPECT_EQ(t.factor(), "×10^{6}");
  EXPECT_EQ(linear_ticks(0, 3e-6, 4).factor(), "×10^{−6}");
  EXPECT_EQ(linear_ticks(0, 3e-6, 4).labels, (Labels{"0", "1", "2", "3"}));
}

TEST(Ticks, NeverMoreThanAskedForAtManyRanges) {
  for (int e = -20; e <= 20; ++e) {
    for (const double low : {-3.7, -1.0, 0.0, 0.41}) {
      const double scale = std::pow(10.0, e);
      const Ticks t = linear_ticks(low * scale, 1.3 * scale, 7);
      EXPECT_GE(t.values.size(), 2U) << low << " e" << e;
      EXPECT_LE(t.values.size(), 7U) << low << " e" << e;
      EXPECT_EQ(t.values.size(), t.labels.size());
      for (const std::string& label : t.labels)
        EXPECT_LE(label.size(), 9U) << label;
      for (std::size_t i = 1; i < t.labels.size(); ++i)
        EXPECT_NE(t.labels[i], t.labels[i - 1]);
    }
  }
}

TEST(Ticks, EmptyRangeHasOneTick) {
  const Ticks t = linear_ticks(2.5, 2.5, 5);
  EXPECT_EQ(t.labels, Labels{"2.5"});
}

TEST(Ticks, DecadesOnLogAxes) {
  EXPECT_EQ(log_ticks(2e-5, 3, 8).labels,
            (Labels{"10^{−4}", "10^{−3}", "10^{−2}", "10^{−1}", "10^{0}"}));
  EXPECT_EQ(log_ticks(0.005, 3, 8).labels, (Labels{"0.01", "0.1", "1"}));
  const Ticks thin = log_ticks(1e-12, 1, 5);
  EXPECT_LE(thin.values.size(), 5U);
  EXPECT_GE(thin.values.size(), 3U);
  EXPECT_EQ(log_ticks(80, 1200, 8).labels, (Labels{"100", "200", "500", "1000"}));
}

TEST(Readable, ShortAndWithARealMinus) {
  EXPECT_EQ(format_readable(0), "0");
  EXPECT_EQ(format_readable(-0.25), "−0.25");
  EXPECT_EQ(format_readable(1234.5678), "1235");
  EXPECT_EQ(format_readable(123456), "123456");
  EXPECT_EQ(format_readable(1.2e-7), "1.2×10^{−7}");
  EXPECT_EQ(format_readable(-4e8), "−4×10^{8}");
}

}  // namespace
}  // namespace limes
