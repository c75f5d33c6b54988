#include "limes/report/axes_triad.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "limes/report/pictures.h"

namespace limes {
namespace {

Scene cube_corners() {
  Scene scene;
  Surface s;
  s.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  scene.surfaces.push_back(s);
  return scene;
}

std::vector<Vec3> random_directions(int count) {
  std::mt19937 random(5);
  std::vector<Vec3> out;
  while (static_cast<int>(out.size()) < count) {
    Vec3 d;
    for (double& c : d)
      c = static_cast<double>(random()) / 2147483648.0 - 1;
    if (d.head<2>().norm() > 0.05) out.push_back(d);
  }
  return out;
}

// The axes point to where the picture has the ends of unit vectors.
TEST(AxesTriad, PointsAsThePictureDoes) {
  const Scene scene = cube_corners();
  for (const Vec3& direction : random_directions(50)) {
    const Camera camera =
        fit_camera(scene, direction, Vec3(0, 0, 1), 1.0, {.projection = Projection::orthographic});
    const AxesTriad triad(camera.axes);
    const Vec2 origin = project(Vec3::Zero(), camera, {400, 400});
    const double unit = 200 / camera.half_height;
    for (int i = 0; i < 3; ++i) {
      const Vec2 end = project(Vec3::Unit(i), camera, {400, 400}) - origin;
      EXPECT_LT((triad.end(i) / 30 - end / unit).norm(), 1e-12) << i;
    }
  }
}

// Three letters, on the page, whatever the view; along an axis too.
TEST(AxesTriad, LettersStandOnThePage) {
  std::vector<Vec3> directions = random_directions(40);
  directions.insert(directions.end(),
                    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, -1, 0}, {-1, 1, 0}});
  FieldPicture field;
  field.points = cube_corners().surfaces[0].points;
  field.triangles = cube_corners().surfaces[0].triangles;
  field.values = {1, 2, 3, 4};
  const std::regex letter("<text[^>]* x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"[^>]*>([xyz])</text>");
  for (const Vec3& direction : directions) {
    const Drawing page = drawing(field_figure(
        field, {.size = {160, 120}, .density = 1, .direction = direction, .axes = true}));
    const std::string svg = to_svg(page);
    std::string letters;
    std::vector<Vec2> at;
    for (std::sregex_iterator it(svg.begin(), svg.end(), letter), end; it != end; ++it) {
      letters += (*it)[3];
      at.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
    }
    std::sort(letters.begin(), letters.end());
    ASSERT_EQ(letters, "xyz") << svg;
    for (const Vec2& p : at) {
      EXPECT_GT(p.x(), 5) << direction.transpose();
      EXPECT_LT(p.x(), page.width - 5) << direction.transpose();
      EXPECT_GT(p.y(), 10) << direction.transpose();
      EXPECT_LT(p.y(), page.height - 2) << direction.transpose();
    }
  }
}

// Looking along (1, -1, 0), x and y are one line on the page.
TEST(AxesTriad, LettersDoNotOverlap) {
  std::vector<Vec3> directions = random_directions(2000);
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      if (x != 0 || y != 0)
        for (const double z : {-1.0, 0.0, 0.1, 1.0})
          directions.emplace_back(x, y, z);
  for (const Vec3& direction : directions) {
    const AxesTriad triad(fit_camera(cube_corners(), direction, Vec3(0, 0, 1), 1.0).axes);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j)
        EXPECT_GT((triad.label(i) - triad.label(j)).norm(), 12.99) << direction.transpose();
  }
  const AxesTriad line(fit_camera(cube_corners(), {1, -1, 0}, Vec3(0, 0, 1), 1.0).axes);
  EXPECT_LT((line.end(0) - line.end(1)).norm(), 1e-9);
  EXPECT_GT(line.label(0).norm(), line.label(1).norm());  // y points to the eye
}

TEST(AxesTriad, PlaneModelsHaveNone) {
  FieldPicture field;
  field.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  field.triangles = {{0, 1, 2}};
  field.values = {1, 2, 3};
  EXPECT_FALSE(field_figure(field, {.size = {90, 90}, .density = 1, .axes = true}).axes);
}

}  // namespace
}  // namespace limes
