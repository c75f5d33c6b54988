#include "limes/study/result_pictures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/annulus.h"
#include "study/solved.h"

namespace limes {
namespace {

PlaneResult solved_ring() {
  Solved s = solve(steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "y == 0"
fix = ["uy"]
[[load]]
where = "x^2 + y^2 < 1.01"
pressure = 1.0
)",
                   testing::annulus(8, 2));
  return {std::move(s.model), std::move(s.solution), {}, {}, {}, {}, 0, {}};
}

/// Distance from the image's centre to the nearest pixel that is not white, in units of half the width.
double white_radius(const Image& image) {
  double least = 2;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const auto pixel = image.pixel(x, y);
      if (std::all_of(pixel.begin(), pixel.end(), [](int c) { return c == 255; })) continue;
      const double dx = 2 * (x + 0.5) / image.width() - 1, dy = 2 * (y + 0.5) / image.height() - 1;
      least = std::min(least, std::hypot(dx, dy));
    }
  return least;
}

// The hole has half the radius of the ring. Eight chords instead of its border would reach inwards
// to cos(pi / 8) = 0.92 of that.
TEST(ResultPictures, BordersOfFacesFollowTheCurve) {
  const PlaneResult result = solved_ring();
  EXPECT_NEAR(white_radius(ResultPictures(result).stress_xx().image), 0.5, 0.01);
}

TEST(ResultPictures, DisplacementsAreDrawnLargeEnoughToSee) {
  for (const double largest : {1e-12, 0.0021, 0.0039, 0.0041, 0.03, 1.0, 7e5}) {
    const double drawn = largest * exaggeration(largest, 3.0) / 3.0;
    EXPECT_LE(drawn, 0.1 * (1 + 1e-12)) << largest;
    EXPECT_GE(drawn, 0.04 * (1 - 1e-12)) << largest;
  }
  EXPECT_EQ(exaggeration(0.003, 1), 20);
  EXPECT_EQ(exaggeration(0, 1), 1);
  const PlaneResult result = solved_ring();
  const Figure figure = ResultPictures(result).deformed();
  EXPECT_NE(figure.caption.find("Displacements are drawn 0."), std::string::npos) << figure.caption;
}

TEST(ResultJson, NamesTheUnits) {
  PlaneResult result = solved_ring();
  EXPECT_EQ(result_json(result)["units"].dump(), "{}");
  result.model.problem.units = {.length = "m", .force = "kN"};
  EXPECT_EQ(result_json(result)["units"].dump(), R"({"length":"m","force":"kN"})");
}

// Two holes beside each other are paper, and so is the side between them; the other faces are not.
TEST(ErrorFigure, LeavesHolesOpen) {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return p; });
  mesh.tags.holes = {FaceId(5), FaceId(6)};
  AdaptiveRun run;
  for (int f = 0; f < 16; ++f)
    run.squares.push_back(f == 5 || f == 6 ? 0 : f + 1);
  const Image image = error_figure(run, mesh, std::nullopt).image;
  const auto is_paper = [&](double x, double y) {
    const auto pixel = image.pixel(static_cast<int>(x * image.width()),
                                   static_cast<int>((1 - y) * image.height()));
    return std::ranges::all_of(pixel, [](int c) { return c == 255; });
  };
  for (int f = 0; f < 16; ++f)
    EXPECT_EQ(is_paper((f % 4 + 0.5) / 4, (f / 4 + 0.5) / 4), f == 5 || f == 6) << f;
  EXPECT_TRUE(is_paper(0.5, 0.375));
  EXPECT_FALSE(is_paper(0.5, 0.625));
}

}  // namespace
}  // namespace limes
