#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "limes/report/colour_map.h"

namespace limes {
namespace {

/// Lightness L* of CIE 1976, from sRGB by the definitions of IEC 61966-2-1 and CIE 15: another
/// model of seeing than the one the maps are made with.
double cie_lightness(const Colour& c) {
  const auto linear = [](double x) {
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

TEST(Colour, OkLabHitsThePrimaries) {  // coordinates as the 2020 article's conversion gives them
  EXPECT_EQ(to_css(to_srgb({0.627955, 0.257683, 29.2339})), "#ff0000");
  EXPECT_EQ(to_css(to_srgb({0.866440, 0.294827, 142.4953})), "#00ff00");
  EXPECT_EQ(to_css(to_srgb({0.452014, 0.313214, 264.0520})), "#0000ff");
  EXPECT_EQ(to_css(to_srgb({1, 0, 0})), "#ffffff");
  EXPECT_EQ(to_css(to_srgb({0, 0, 0})), "#000000");
}

TEST(Colour, WhatSrgbLacksLosesChromaOnly) {
  const Colour c = to_srgb({0.6, 0.4, 145});
  EXPECT_GE(c.g, c.r);
  EXPECT_NEAR(std::min({c.r, c.g, c.b}), 0, 0.05);  // as colourful as it gets
}

TEST(ColourMap, SequentialGrowsEvenlyLighter) {
  const auto table = ColourMap::sequential().table();
  const double first = cie_lightness(table.front());
  const double last = cie_lightness(table.back());
  EXPECT_GT(last - first, 70);
  for (std::size_t i = 1; i < table.size(); ++i)
    EXPECT_GT(cie_lightness(table[i]), cie_lightness(table[i - 1])) << i;
  for (std::size_t i = 0; i + 51 < table.size(); i += 51) {
    const double step = cie_lightness(table[i + 51]) - cie_lightness(table[i]);
    EXPECT_NEAR(step, (last - first) / 5, 0.15 * (last - first) / 5) << i;
  }
}

TEST(ColourMap, DivergingArmsDarkenAlikeFromTheMiddle) {
  const auto table = ColourMap::diverging().table();
  EXPECT_GT(cie_lightness(table[127]), 94);
  for (std::size_t i = 0; i < 128; ++i) {
    EXPECT_NEAR(cie_lightness(table[i]), cie_lightness(table[255 - i]), 4) << i;
    if (i > 0) {
      EXPECT_GE(cie_lightness(table[i]), cie_lightness(table[i - 1])) << i;
    }
  }
  EXPECT_GT(table.front().b, table.front().r);
  EXPECT_GT(table.back().r, table.back().b);
}

TEST(ColourMap, EndsHoldBeyondAndNanIsNoData) {
  const ColourMap& map = ColourMap::sequential();
  EXPECT_EQ(map(-3), map(0));
  EXPECT_EQ(map(17), map(1));
  EXPECT_EQ(map(std::numeric_limits<double>::quiet_NaN()), palette::no_data);
}

TEST(ColourScale, BothSignsGiveASymmetricDivergingScale) {
  const ColourScale scale = scale_for({-2, 5});
  EXPECT_EQ(scale.map, &ColourMap::diverging());
  EXPECT_EQ(scale.low, -5);
  EXPECT_EQ(scale.high, 5);
  EXPECT_EQ(scale.normalised(0), 0.5);
  EXPECT_EQ(scale_for({1, 5}).map, &ColourMap::sequential());
  EXPECT_EQ(scale_for({1, 5}).low, 1);
}

TEST(ColourScale, ConstantFieldsAndBandsWork) {
  const ColourScale constant = scale_for({3, 3});
  EXPECT_EQ(constant(3), ColourMap::sequential()(0.5));
  ColourScale bands = scale_for({0, 1});
  bands.bands = 4;
  EXPECT_EQ(bands(0.01), bands(0.24));
  EXPECT_NE(bands(0.24), bands(0.26));
  EXPECT_EQ(bands(1), bands(0.9));
}

TEST(Range, SkipsWhatIsNotFiniteAndOutliers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> values{nan, 3, -1, inf, 2};
  EXPECT_EQ(range_of(values).low, -1);
  EXPECT_EQ(range_of(values).high, 3);
  EXPECT_EQ(range_of({}).high, 0);
  std::vector<double> peak;
  for (int i = 0; i < 1000; ++i)
    peak.push_back(i);
  peak.push_back(1e9);
  EXPECT_LT(robust_range_of(peak, 0.002).high, 1000);
}

}  // namespace
}  // namespace limes
