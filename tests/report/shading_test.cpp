// Fields on surfaces in space: the colours stay those of the bar.

#include <gtest/gtest.h>

#include <numbers>

#include "limes/report/pictures.h"
#include "report/oklab.h"

namespace limes {
namespace {

using testing::BarReader;
using testing::hue_of;
using testing::oklab_of;

/// A ball, finely enough that facets do not matter, with a value of each point.
template <class Value>
FieldPicture ball(const Value& value) {
  constexpr int n = 64;
  FieldPicture out;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= 2 * n; ++j) {
      const double a = std::numbers::pi * i / n, b = std::numbers::pi * j / n;
      out.points.emplace_back(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      out.values.push_back(value(out.points.back()));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const int v = i * (2 * n + 1) + j, w = v + 2 * n + 1;
      out.triangles.push_back({v, w, w + 1});
      out.triangles.push_back({v, w + 1, v + 1});
    }
  return out;
}

constexpr PictureSize small{120, 120};

/// Calls action(pixel, distance from the middle in radii of the ball) for pixels that the ball covers.
template <class Action>
void for_each_pixel_of_ball(const Image& image, const Action& action) {
  const double width = image.width() - 2 * 10, height = image.height() - 2 * 10;  // the margins
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const double r = std::hypot((2 * (x + 0.5) - image.width()) / width,
                                  (2 * (y + 0.5) - image.height()) / height);
      if (r < 0.96) action(image.pixel(x, y), r);
    }
}

// Under the two lights for surfaces without a field, the same ball goes down to half the lightness.
TEST(FaintShading, KeepsTheHueAndNearlyTheLightness) {
  for (const double value : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    FieldPicture field = ball([&](const Vec3&) { return value; });
    field.scale = ColourScale{};
    const Figure figure =
        field_figure(field, {.size = small, .density = 1, .direction = Vec3(-1, -1.5, -1)});
    const BarReader read_off(*field.scale);
    const Vec3 bar = oklab_of(to_bytes((*field.scale)(value)));
    double darkest = bar.x(), brightest = 0;
    int pixels = 0;
    for_each_pixel_of_ball(figure.image, [&](auto pixel, double r) {
      const Vec3 seen = oklab_of(pixel);
      darkest = std::min(darkest, seen.x());
      brightest = std::max(brightest, seen.x());
      EXPECT_NEAR(hue_of(seen), hue_of(bar), 2) << value;  // bytes are rounded
      EXPECT_NEAR(read_off(pixel).value, value, 0.04) << value << ' ' << r;
      ++pixels;
    });
    EXPECT_GT(pixels, 5000);
    EXPECT_NEAR(brightest / bar.x(), 1, 0.01) << value;
    EXPECT_GT(darkest / bar.x(), 0.95) << value;
    EXPECT_LT(darkest / bar.x(), 0.985) << value;  // the form is seen
  }
}

// The height on the ball, with both signs: a diverging scale. An eye that sees the ball within the angle a meets
// at the angle t from its middle the height sin(asin(sin t / sin a) - t).
TEST(FaintShading, ReadsTheValueOfEveryPixel) {
  const FieldPicture field = ball([](const Vec3& p) { return p.z(); });
  const Figure figure =
      field_figure(field, {.size = small, .density = 1, .direction = Vec3(0, 1, 0)});
  const ColourScale& scale = figure.bar->scale;
  ASSERT_EQ(scale.low, -1);
  const BarReader read_off(scale);
  const FitOptions fit;
  const double tan_a =
      std::tan(fit.opening_angle / 2 * std::numbers::pi / 180) * (1 - 2 * fit.margin);
  const Image& image = figure.image;
  for (int y = 12; y < image.height() - 12; ++y) {
    const double up = -(2 * (y + 0.5) - image.height()) / (image.height() - 2 * 10);
    const double t = std::atan(up * tan_a);
    const double height = std::sin(std::asin(std::sin(t) / std::sin(std::atan(tan_a))) - t);
    EXPECT_NEAR(read_off(image.pixel(image.width() / 2, y)).value, height, 0.1) << y;
  }
}

// A constant with rounding in it is one colour, and no value lies beyond the bar.
TEST(FieldFigure, RoundingMakesNoRange) {
  int n = 0;
  FieldPicture field = ball([&](const Vec3&) { return 3.0 + 1e-15 * (n++ % 5); });
  const Figure figure =
      field_figure(field, {.size = small, .density = 1, .direction = Vec3(-1, -1.5, -1)});
  EXPECT_EQ(figure.bar->scale.low, figure.bar->scale.high);
  EXPECT_FALSE(figure.bar->tip_below || figure.bar->tip_above);
  const double hue = hue_of(oklab_of(to_bytes(ColourMap::sequential()(0.5))));
  for_each_pixel_of_ball(figure.image,
                         [&](auto pixel, double) { EXPECT_NEAR(hue_of(oklab_of(pixel)), hue, 2); });
}

}  // namespace
}  // namespace limes
