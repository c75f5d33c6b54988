#include "limes/report/camera.h"

#include <gtest/gtest.h>

#include <random>

#include "limes/core/error.h"
#include "limes/report/render.h"

namespace limes {
namespace {

/// Four long and one high.
Surface long_triangle() {
  Surface s;
  s.points = {{0, 0, 0}, {4, 0, 0}, {0, 1, 0}};
  s.triangles = {{0, 1, 2}};
  return s;
}

TEST(Camera, FitTouchesTheMarginAndHoldsEveryPoint) {
  Scene scene;
  std::mt19937 random(7);
  Surface s;
  for (int i = 0; i < 60; ++i)
    s.points.emplace_back(random() % 1000, random() % 300, random() % 500);
  for (int i = 0; i + 2 < 60; ++i)
    s.triangles.push_back({i, i + 1, i + 2});
  scene.surfaces.push_back(s);
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const PictureSize size{300, 200};
    const Camera camera =
        fit_camera(scene, {1, 2, -1}, {0, 0, 1}, 1.5, {.projection = projection, .margin = 0.1});
    EXPECT_LT((camera.axes * camera.axes.transpose() - Mat3::Identity()).norm(), 1e-12);
    EXPECT_NEAR(camera.axes.determinant(), 1, 1e-12);
    Vec2 low(1e9, 1e9), high(-1e9, -1e9);
    for (const Vec3& p : s.points) {
      low = low.cwiseMin(project(p, camera, size));
      high = high.cwiseMax(project(p, camera, size));
    }
    EXPECT_GE(low[0], 30 - 1e-9);
    EXPECT_GE(low[1], 20 - 1e-9);
    EXPECT_LE(high[0], 270 + 1e-9);
    EXPECT_LE(high[1], 180 + 1e-9);
    const bool touches = std::abs(low[0] - 30) < 1e-6 || std::abs(low[1] - 20) < 1e-6;
    EXPECT_TRUE(touches);
  }
}

TEST(Camera, PlaneModelsKeepTheirProportions) {
  Scene scene;
  scene.surfaces.push_back(long_triangle());
  const PictureSize size = size_for_plane(scene, {800, 800});
  EXPECT_EQ(size.width, 800);
  EXPECT_EQ(size.height, 200);
  const Camera camera = top_camera(scene, 4, 0);
  EXPECT_NEAR((project({4, 1, 0}, camera, size) - Vec2(800, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((project({0, 0, 0}, camera, size) - Vec2(0, 200)).norm(), 0, 1e-9);
}

TEST(Camera, ImpossibleViewsAreInputErrors) {
  Scene scene;
  EXPECT_THROW((void)top_camera(scene, 1), InputError);
  scene.surfaces.push_back(long_triangle());
  EXPECT_THROW((void)fit_camera(scene, {0, 0, -1}, {0, 0, 2}, 1), InputError);
}

}  // namespace
}  // namespace limes
