#include "limes/report/figure_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "limes/core/error.h"

namespace limes {
namespace {

LegendEntry entry(const char* label) {
  return {.label = label};
}

/// A figure of width x height units in one colour.
Figure plain(int width, int height, const Colour& colour, std::vector<LegendEntry> legend = {}) {
  Figure figure;
  figure.image = Image(width, height);
  figure.density = 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      figure.image.blend(x, y, colour, 1);
  figure.legend = std::move(legend);
  return figure;
}

/// Notes where images and texts are put.
class NotingCanvas final : public Canvas {
 public:
  struct Box {
    Vec2 corner, size;
  };
  void polyline(std::span<const Vec2>, const Stroke&) override {}
  void polygon(std::span<const Vec2>, const Paint&) override {}
  void circle(const Vec2&, double, const Paint&) override {}
  void text(const Vec2& at, std::string_view label, const TextStyle&) override {
    texts.emplace_back(label);
    lowest_text = std::max(lowest_text, at[1]);
  }
  void image(const Vec2& corner, const Vec2& size, const Image&) override {
    images.push_back({corner, size});
  }
  std::vector<Box> images;
  std::vector<std::string> texts;
  double lowest_text = 0;
};

NotingCanvas drawn(const Drawing& drawing) {
  NotingCanvas canvas;
  drawing.draw(canvas);
  return canvas;
}

bool overlap(const NotingCanvas::Box& a, const NotingCanvas::Box& b) {
  return (a.corner.array() < (b.corner + b.size).array()).all() &&
         (b.corner.array() < (a.corner + a.size).array()).all();
}

TEST(FigureGrid, ImagesStandInRowsAndColumnsWithoutOverlap) {
  FigureGrid grid{.columns = 2};
  grid.figures = {plain(310, 40, palette::red), plain(400, 90, palette::green),
                  plain(500, 60, palette::yellow)};
  const Drawing drawing = limes::drawing(grid);
  const NotingCanvas canvas = drawn(drawing);
  ASSERT_EQ(canvas.images.size(), 3U);
  const auto& [a, b, c] = std::tie(canvas.images[0], canvas.images[1], canvas.images[2]);
  EXPECT_EQ(a.corner[1], b.corner[1]);
  EXPECT_EQ(a.corner[0], c.corner[0]);
  EXPECT_GE(b.corner[0], c.corner[0] + c.size[0]) << "the widest figure sets the column";
  EXPECT_GE(c.corner[1], b.corner[1] + b.size[1]) << "the highest figure sets the row";
  for (const auto& box : canvas.images) {
    EXPECT_LE(box.corner[0] + box.size[0], drawing.width);
    EXPECT_LE(box.corner[1] + box.size[1], drawing.height);
    for (const auto& other : canvas.images)
      EXPECT_TRUE(&box == &other || !overlap(box, other));
  }
}

TEST(FigureGrid, SaysEveryLegendEntryOnceInTheFiguresOrder) {
  FigureGrid grid{.columns = 2, .title = "Both"};
  grid.figures = {plain(300, 40, palette::red, {entry("b"), entry("d")}),
                  plain(300, 40, palette::red, {entry("a"), entry("b"), entry("c"), entry("d")}),
                  plain(300, 40, palette::red, {entry("d"), entry("e")})};
  const Drawing drawing = limes::drawing(grid);
  const NotingCanvas canvas = drawn(drawing);
  EXPECT_EQ(canvas.texts, (std::vector<std::string>{"Both", "a", "b", "c", "d", "e"}));
  EXPECT_LT(canvas.lowest_text, drawing.height);
  EXPECT_GT(canvas.lowest_text, canvas.images.back().corner[1] + canvas.images.back().size[1]);
}

TEST(FigureGrid, FiguresLookAsTheyDoAlone) {
  const Figure figure = plain(320, 30, palette::orange);
  const Image alone = to_image(drawing(figure), 1);
  FigureGrid grid{.columns = 2};
  grid.figures = {figure, figure};
  const Image both = to_image(drawing(grid), 1);
  ASSERT_EQ(both.width(), 2 * alone.width());
  for (int y = 0; y < std::min(alone.height(), both.height()); ++y) {
    for (int x = 0; x < both.width(); ++x)
      ASSERT_TRUE(std::ranges::equal(both.pixel(x, y), alone.pixel(x % alone.width(), y)))
          << x << ", " << y;
  }
}

TEST(FigureGrid, RefusesNothingToShow) {
  EXPECT_THROW((void)drawing(FigureGrid{}), InputError);
  FigureGrid grid{.columns = 0};
  grid.figures = {plain(10, 10, palette::red)};
  EXPECT_THROW((void)drawing(grid), InputError);
}

}  // namespace
}  // namespace limes
