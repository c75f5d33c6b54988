#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

#include "limes/core/error.h"
#include "limes/report/render.h"

namespace limes {
namespace {

constexpr RenderOptions pixel_exact{.size = {200, 160}, .density = 1, .samples = 1};

/// Sees the rectangle [0, 200] x [0, 160] so that one unit is one pixel.
Camera pixel_camera() {
  Camera camera;
  camera.eye = Vec3(100, 80, 100);
  camera.half_height = 80;
  return camera;
}

Surface flat(std::vector<Vec3> points, std::vector<std::array<int, 3>> triangles) {
  Surface s;
  s.points = std::move(points);
  s.triangles = std::move(triangles);
  s.shading = Shading::flat;
  return s;
}

/// A jittered grid over [10, 190] x [10, 150], every cell cut along a random diagonal, both
/// orientations mixed, vertices on awkward fractions; the outline stays straight.
Surface random_triangles(unsigned seed) {
  constexpr int n = 23;
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  Surface s;
  s.shading = Shading::flat;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      const double dx = inner ? 0.45 * uniform() : 0, dy = inner ? 0.45 * uniform() : 0;
      s.points.emplace_back(10 + 180 * (i + dx) / n, 10 + 140 * (j + dy) / n, 0);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      if (random() % 2 == 0) {
        s.triangles.push_back({a, b, c});
        s.triangles.push_back({c, a, d});
      } else {
        s.triangles.push_back({b, a, d});
        s.triangles.push_back({b, c, d});
      }
    }
  }
  return s;
}

int count_pixels(const Image& image, const Colour& colour) {
  const auto bytes = to_bytes(colour);
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      count += std::equal(bytes.begin(), bytes.end(), image.pixel(x, y).begin()) ? 1 : 0;
  return count;
}

TEST(Render, NeighboursLeaveNoGap) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Scene scene;
    scene.surfaces.push_back(random_triangles(seed));
    scene.surfaces[0].colour = Colour::hex(0x336699);
    const Image image = render(scene, pixel_camera(), pixel_exact);
    EXPECT_EQ(count_pixels(image, Colour::hex(0x336699)), 180 * 140) << seed;
    EXPECT_EQ(count_pixels(image, palette::paper), 200 * 160 - 180 * 140) << seed;
  }
}

/// Each triangle drawn alone: the numbers of their pixels add up to the whole only if no pixel is
/// hit twice (and none missed).
TEST(Render, NeighboursHitNoPixelTwice) {
  const Surface all = random_triangles(4);
  int sum = 0;
  for (const auto& triangle : all.triangles) {
    Scene scene;
    scene.surfaces.push_back(flat(all.points, {triangle}));
    scene.surfaces[0].colour = Colour::hex(0);
    sum += count_pixels(render(scene, pixel_camera(), pixel_exact), Colour::hex(0));
  }
  EXPECT_EQ(sum, 180 * 140);
}

/// Corners on pixel centres: every sample on an edge is a tie.
TEST(Render, TiesOnEdgesGoToExactlyOneTriangle) {
  const std::vector<Vec3> points{
      {10.5, 10.5, 0}, {60.5, 10.5, 0}, {60.5, 60.5, 0}, {10.5, 60.5, 0}, {35.5, 35.5, 0}};
  const std::vector<std::array<int, 3>> fan{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  int sum = 0;
  for (const auto& triangle : fan) {
    Scene scene;
    scene.surfaces.push_back(flat(points, {triangle}));
    scene.surfaces[0].colour = Colour::hex(0);
    sum += count_pixels(render(scene, pixel_camera(), pixel_exact), Colour::hex(0));
  }
  EXPECT_EQ(sum, 50 * 50);
}

TEST(Render, NearerTriangleHidesWhateverTheOrder) {
  const std::vector<Vec3> points{{20, 20, 0},  {180, 20, 0},  {100, 140, 0},
                                 {20, 20, 10}, {180, 20, 10}, {100, 140, 10}};
  for (const bool near_first : {false, true}) {
    Surface s = flat(points, {{0, 1, 2}, {3, 4, 5}});
    s.triangle_colours = {Colour::hex(0xff0000), Colour::hex(0x00ff00)};
    if (near_first) {
      std::swap(s.triangles[0], s.triangles[1]);
      std::swap(s.triangle_colours[0], s.triangle_colours[1]);
    }
    Scene scene;
    scene.surfaces.push_back(s);
    const Image image = render(scene, pixel_camera(), pixel_exact);
    EXPECT_EQ(count_pixels(image, Colour::hex(0xff0000)), 0);
    EXPECT_GT(count_pixels(image, Colour::hex(0x00ff00)), 9000);
  }
}

/// Two rectangles that cross along x = 100: each is seen on its half.
TEST(Render, CrossingTrianglesMeetWhereDepthsAreEqual) {
  Surface s = flat({{20, 20, -10},
                    {180, 20, 10},
                    {180, 140, 10},
                    {20, 140, -10},
                    {20, 20, 10},
                    {180, 20, -10},
                    {180, 140, -10},
                    {20, 140, 10}},
                   {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  const Colour rising = Colour::hex(0xff0000), falling = Colour::hex(0x0000ff);
  s.triangle_colours = {rising, rising, falling, falling};
  Scene scene;
  scene.surfaces.push_back(s);
  const Image image = render(scene, pixel_camera(), pixel_exact);
  EXPECT_EQ(count_pixels(image, rising), 80 * 120);
  EXPECT_EQ(count_pixels(image, falling), 80 * 120);
  EXPECT_EQ(image.pixel(99, 80)[2], 255);
  EXPECT_EQ(image.pixel(100, 80)[0], 255);
}

/// A value linear in x and y: every pixel has the colour of the value at its centre.
TEST(Render, ValuesAreColouredPerPixel) {
  Surface s = flat({{0, 0, 0}, {200, 0, 0}, {200, 160, 0}, {0, 160, 0}}, {{0, 1, 2}, {0, 2, 3}});
  for (const Vec3& p : s.points)
    s.values.push_back(2 * p[0] - p[1]);
  s.scale = scale_for(range_of(s.values));
  Scene scene;
  scene.surfaces.push_back(s);
  const Image image = render(scene, pixel_camera(), pixel_exact);
  for (int y = 0; y < 160; y += 13) {
    for (int x = 0; x < 200; x += 13) {
      const double value = 2 * (x + 0.5) - (160 - (y + 0.5));
      const auto expected = to_bytes(s.scale(value));
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(image.pixel(x, y)[c], expected[c], 4) << x << ' ' << y;
    }
  }
}

/// In perspective the middle of an edge is not the middle of its picture. A plane that recedes from
/// the eye carries its own x as value: each pixel must show the x that its ray meets.
TEST(Render, PerspectiveInterpolatesOnTheSurface) {
  Surface s = flat({{-1, -1, 0}, {1, -1, -4}, {1, 1, -4}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  s.values = {-1, 1, 1, -1};
  s.scale = {.map = &ColourMap::sequential(), .low = -1, .high = 1};
  Scene scene;
  scene.surfaces.push_back(s);
  Camera camera;
  camera.projection = Projection::perspective;
  camera.eye = Vec3(0, 0, 3);
  camera.half_height = 0.5;
  const Image image = render(scene, camera, {.size = {200, 200}, .density = 1, .samples = 1});
  int tested = 0;
  for (int px = 40; px < 160; ++px) {
    const double slope = ((px + 0.5) / 100 - 1) * 0.5;   // x / distance along the ray
    const double x = slope * (3 + 2) / (1 - 2 * slope);  // where z = -2 - 2 x
    if (std::abs(x) > 0.95) continue;
    ++tested;
    const auto expected = to_bytes(s.scale(x));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(image.pixel(px, 100)[c], expected[c], 5) << px;
  }
  EXPECT_GT(tested, 60);
}

TEST(Render, IsoLineLiesWhereTheValueIs) {
  Surface s = flat({{0, 0, 0}, {200, 0, 0}, {200, 160, 0}, {0, 160, 0}}, {{0, 1, 2}, {0, 2, 3}});
  s.values = {0, 200, 200, 0};
  s.scale = {.map = &ColourMap::sequential(), .low = 0, .high = 200};
  Scene scene;
  scene.surfaces.push_back(s);
  const Image plain = render(scene, pixel_camera(), pixel_exact);
  scene.surfaces[0].scale.iso_lines = {50.5};
  const Image lined = render(scene, pixel_camera(), pixel_exact);
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 200; ++x) {
      const bool same =
          std::equal(plain.pixel(x, y).begin(), plain.pixel(x, y).end(), lined.pixel(x, y).begin());
      EXPECT_EQ(same, x != 50) << x << ' ' << y;
    }
  }
}

TEST(Render, LinesAreTestedAgainstDepthUnlessOnTop) {
  Scene scene;
  scene.surfaces.push_back(
      flat({{50, 20, 0}, {150, 20, 0}, {150, 140, 0}, {50, 140, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  Lines line;
  line.points = {{10, 80, -5}, {190, 80, -5}};
  line.segments = {{0, 1}};
  line.width = 2;
  line.colour = Colour::hex(0xff00ff);
  scene.lines = {line};
  EXPECT_EQ(count_pixels(render(scene, pixel_camera(), pixel_exact), line.colour),
            (180 - 100) * 2 + 4);  // a quarter of a pixel circle at each end
  scene.lines[0].on_top = true;
  EXPECT_EQ(count_pixels(render(scene, pixel_camera(), pixel_exact), line.colour), 180 * 2 + 4);
  scene.lines[0].on_top = false;  // on the surface itself it is seen
  scene.lines[0].points = {{10, 80, 0}, {190, 80, 0}};
  EXPECT_EQ(count_pixels(render(scene, pixel_camera(), pixel_exact), line.colour), 180 * 2 + 4);
}

TEST(Render, TrianglesBehindTheEyeAreCutOff) {
  Surface floor = flat({{-50, -1, 50}, {50, -1, 50}, {0, -1, -200}}, {{0, 1, 2}});
  floor.colour = Colour::hex(0x008000);
  Scene scene;
  scene.surfaces.push_back(floor);
  Camera camera;
  camera.projection = Projection::perspective;
  camera.eye = Vec3(0, 0, 0);
  camera.half_height = 1;
  const Image image = render(scene, camera, {.size = {100, 100}, .density = 1, .samples = 1});
  EXPECT_EQ(image.pixel(50, 99)[1], 0x80);  // the floor below
  EXPECT_EQ(image.pixel(50, 10)[0], 255);   // nothing above the horizon
  EXPECT_EQ(count_pixels(image, floor.colour) + count_pixels(image, palette::paper), 100 * 100);
}

TEST(Render, ArraysThatDoNotFitAreInputErrors) {
  Scene scene;
  scene.surfaces.push_back(flat({{0, 0, 0}, {4, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}));
  EXPECT_THROW((void)render(scene, pixel_camera(), pixel_exact), InputError);
  scene.surfaces[0].triangles = {{0, 1, 2}};
  scene.surfaces[0].values = {1, 2};
  EXPECT_THROW((void)render(scene, pixel_camera(), pixel_exact), InputError);
  scene.surfaces[0].values.clear();
  scene.surfaces[0].points[1][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)render(scene, pixel_camera(), pixel_exact), InputError);
}

TEST(Render, TwiceTheSameBytesAndSupersamplingKeepsTheMeanColour) {
  Scene scene;
  scene.surfaces.push_back(random_triangles(9));
  for (const Vec3& p : scene.surfaces[0].points)
    scene.surfaces[0].values.push_back(std::sin(p[0] / 20) * p[1]);
  scene.surfaces[0].scale = scale_for(range_of(scene.surfaces[0].values));
  RenderOptions options = pixel_exact;
  const Image once = render(scene, pixel_camera(), options);
  EXPECT_EQ(once, render(scene, pixel_camera(), options));
#ifdef LIMES_WITH_TBB
  {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(once, render(scene, pixel_camera(), options));
  }
#endif
  options.samples = 4;
  const Image smooth = render(scene, pixel_camera(), options);
  const auto mean = [](const Image& image) {
    return std::accumulate(image.bytes().begin(), image.bytes().end(), 0.0) /
           static_cast<double>(image.bytes().size());
  };
  EXPECT_NEAR(mean(once), mean(smooth), 0.2);
}

}  // namespace
}  // namespace limes
