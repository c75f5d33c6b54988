#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "limes/core/error.h"
#include "limes/report/plot_layout.h"

namespace limes {
namespace {

std::vector<Vec2> power_law(double factor, double rate, int count) {
  std::vector<Vec2> points;
  for (int i = 1; i <= count; ++i) {
    const double h = std::pow(0.5, i);
    points.emplace_back(h, factor * std::pow(h, rate));
  }
  return points;
}

Plot three_rates() {
  return convergence_plot("title", "h in mm", "error",
                          {{"one", power_law(0.9, 1, 7)},
                           {"two", power_law(0.4, 2, 6)},
                           {"three", power_law(0.2, 3, 6)}},
                          {{1}, {2}, {3}});
}

TEST(Axis, LogarithmsAreMappedLinearly) {
  const Axis axis(AxisScale::logarithmic, 1e-4, 1e2);
  EXPECT_LT(axis.at(1e-4), 0.1);
  EXPECT_GT(axis.at(1e-4), 0);
  EXPECT_LT(axis.at(1e2), 1);
  const double decade = axis.at(10) - axis.at(1);
  EXPECT_NEAR(axis.at(0.01) - axis.at(0.001), decade, 1e-12);
  EXPECT_NEAR(axis.at(2) - axis.at(1), decade * std::log10(2.0), 1e-12);
  EXPECT_NEAR(axis.value(axis.at(0.37)), 0.37, 1e-12);
  EXPECT_FALSE(axis.shows(0));
  EXPECT_FALSE(axis.shows(-1));
  EXPECT_FALSE(axis.shows(std::numeric_limits<double>::infinity()));
}

TEST(Axis, ASingleValueGetsARange) {
  for (const double value : {0.0, 5.0, -3e8}) {
    const Axis axis(AxisScale::linear, value, value);
    EXPECT_NEAR(axis.at(value), 0.5, 1e-9);
    EXPECT_GT(axis.at(value + 1.2 * std::max(1.0, std::abs(value))), 1);
  }
}

/// A curve y = c x^r is straight, and its steepness on the canvas is that of its triangle.
TEST(PlotLayout, TrianglesAreParallelToTheirCurves) {
  const PlotLayout layout = lay_out(three_rates());
  ASSERT_EQ(layout.slopes.size(), 3U);
  ASSERT_EQ(layout.curves.size(), 3U);
  for (std::size_t s = 0; s < 3; ++s) {
    const Vec2 along = layout.curves[s].back() - layout.curves[s].front();
    const Vec2 hypotenuse = layout.slopes[s].corners[2] - layout.slopes[s].corners[0];
    EXPECT_NEAR(along[1] / along[0], hypotenuse[1] / hypotenuse[0], 1e-9) << s;
    EXPECT_EQ(layout.slopes[s].rise_text, std::to_string(s + 1));
    EXPECT_EQ(layout.slopes[s].run_text, "1");
  }
}

TEST(PlotLayout, PointsLieWhereTheAxesSay) {
  const PlotLayout layout = lay_out(three_rates());
  const Vec2 a = layout.curves[0][0], b = layout.curves[0][1];  // h and error halved
  const Vec2 c = layout.curves[1][0], d = layout.curves[1][1];  // error quartered
  EXPECT_NEAR(b[0] - a[0], d[0] - c[0], 1e-9);
  EXPECT_NEAR(2 * (b[1] - a[1]), d[1] - c[1], 1e-9);
  for (std::size_t i = 0; i < layout.y_ticks.values.size(); ++i) {
    const double share = layout.y.at(layout.y_ticks.values[i]);
    EXPECT_GE(share, -1e-9);
    EXPECT_LE(share, 1 + 1e-9);
  }
}

Box bounds(const SlopeTriangle& t) {
  Box box = t.run;
  const auto add = [&](const Box& b) {
    box = {std::min(box.left, b.left), std::min(box.top, b.top), std::max(box.right, b.right),
           std::max(box.bottom, b.bottom)};
  };
  add(t.rise);
  for (const Vec2& c : t.corners)
    add({c[0], c[1], c[0], c[1]});
  return box;
}

bool meets(const std::vector<Vec2>& curve, const Box& box) {
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    for (double t = 0; t <= 1; t += 1.0 / 512) {
      const Vec2 p = curve[i] + t * (curve[i + 1] - curve[i]);
      if (p[0] > box.left && p[0] < box.right && p[1] > box.top && p[1] < box.bottom) return true;
    }
  }
  return false;
}

/// For many families of curves: legend, triangles' texts and curves keep apart, all in the frame.
TEST(PlotLayout, NothingOverlaps) {
  for (const double rate : {-3.0, -1.0, -0.5, 0.5, 1.5, 4.0}) {
    for (const int count : {2, 3, 8}) {
      const Plot plot = convergence_plot("", "x", "y",
                                         {{"a longer name of a series", power_law(1, rate, count)},
                                          {"second", power_law(0.5, rate, count)},
                                          {"third", power_law(3, 0.7 * rate, count + 1)}},
                                         {{rate}, {0.7 * rate}});
      const PlotLayout layout = lay_out(plot);
      ASSERT_EQ(layout.slopes.size(), 2U) << rate << ' ' << count;
      EXPECT_FALSE(bounds(layout.slopes[0]).overlaps(bounds(layout.slopes[1])));
      for (const SlopeTriangle& t : layout.slopes) {
        EXPECT_TRUE(layout.frame.contains(bounds(t))) << rate << ' ' << count;
        EXPECT_FALSE(bounds(t).overlaps(layout.legend)) << rate << ' ' << count;
        for (const auto& curve : layout.curves) {
          EXPECT_FALSE(meets(curve, t.rise)) << rate << ' ' << count;
          EXPECT_FALSE(meets(curve, t.run)) << rate << ' ' << count;
        }
      }
      for (const auto& curve : layout.curves)
        EXPECT_FALSE(meets(curve, layout.legend)) << rate << ' ' << count;
    }
  }
}

TEST(PlotLayout, LegendLeavesTheFrameWhenNoCornerIsFree) {
  Plot plot;
  Series noise{"noise", {}};
  for (int i = 0; i <= 100; ++i)
    noise.points.emplace_back(i, i % 2);
  plot.series = {noise};
  const PlotLayout layout = lay_out(plot);
  EXPECT_GT(layout.legend.top, layout.frame.bottom);
  EXPECT_GE(layout.height, layout.legend.bottom);
}

TEST(PlotLayout, WhatCannotBeShownInterruptsTheCurve) {
  Plot plot =
      convergence_plot("", "x", "y", {{"a", {{1, 1}, {2, 0.5}, {3, 0}, {4, 0.2}, {5, 0.1}}}}, {});
  const PlotLayout layout = lay_out(plot);
  ASSERT_EQ(layout.curves.size(), 2U);
  EXPECT_EQ(layout.curves[0].size(), 2U);
  EXPECT_EQ(layout.curves[1].size(), 2U);
}

TEST(Plot, ImpossibleWishesAreInputErrors) {
  EXPECT_THROW((void)drawing(Plot{}), InputError);
  EXPECT_THROW((void)drawing(convergence_plot("", "x", "y", {{"a", {{-1, 1}, {1, -1}}}}, {})),
               InputError);
  EXPECT_THROW((void)drawing(convergence_plot("", "x", "y", {{"a", power_law(1, 1, 3)}}, {{1, 4}})),
               InputError);
  Plot linear = three_rates();
  linear.x_scale = AxisScale::linear;
  EXPECT_THROW((void)drawing(linear), InputError);
}

TEST(Plot, SvgHoldsTheLabelsAndIsDeterministic) {
  Plot plot = three_rates();
  plot.y_label = "‖u − u_{h}‖ <E>";
  const std::string svg = to_svg(drawing(plot));
  EXPECT_NE(svg.find("‖u − u<tspan"), std::string::npos);
  EXPECT_NE(svg.find("&lt;E&gt;"), std::string::npos);
  EXPECT_NE(svg.find(">three</text>"), std::string::npos);
  EXPECT_EQ(svg, to_svg(drawing(plot)));
  EXPECT_EQ(to_image(drawing(plot)), to_image(drawing(plot)));
}

}  // namespace
}  // namespace limes
