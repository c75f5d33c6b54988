// Pictures of stresses of shells, pixel by pixel against exact stresses.

#include "limes/study/shell_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "convergence/plane_meshes.h"
#include "limes/study/run.h"
#include "report/oklab.h"

namespace limes {
namespace {

using testing::BarReader;

bool is_paper(std::span<const std::uint8_t> pixel) {
  return std::all_of(pixel.begin(), pixel.end(), [](int c) { return c == 255; });
}

ShellResult solved(const Problem& problem, const Mesh& mesh) {
  ShellResult result;
  result.model = build_shell_model(problem, mesh);
  result.solution = solve_shell(result.model);
  return result;
}

/// A strip pulled in x by the force 3 per length, its right half twice as thick: the stress is 3, then 3/2.
ShellResult stepped_strip() {
  const Problem problem = parse_problem(R"([units]
length = "mm"
force = "N"
[mesh]
file = "m.obj"
scheme = "linear"
[model]
kind = "mitc4"
[[material]]
young = 7
poisson = 0
thickness = 2
[[material]]
where = "x <= 1"
young = 7
poisson = 0
thickness = 1
[[support]]
where = "x == 0"
fix = ["ux", "uz", "rx", "ry"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == 2"
force_per_length = [3, 0, 0]
)",
                                        "p.toml");
  return solved(problem, testing::grid(8, 4, [](const Vec2& p) { return Vec2(2 * p.x(), p.y()); }));
}

// Every pixel of the surface has the colour that the bar has at one of the two stresses; a mean of them, as
// values averaged at the step would show, is nowhere.
TEST(ShellPictures, StressJumpsWhereTheThicknessDoes) {
  const ShellResult result = stepped_strip();
  for (const ShellSide side : {ShellSide::top, ShellSide::bottom}) {
    const Figure figure = ShellPictures(result).von_mises(side);
    const ColourScale& scale = figure.bar->scale;
    const BarReader read_off(scale);
    EXPECT_EQ(scale.low, 0);
    EXPECT_NEAR(scale.high, 3, 1e-9);
    EXPECT_FALSE(figure.bar->tip_above);
    EXPECT_EQ(figure.bar->unit, "N/mm²");
    int thin = 0, thick = 0, mean = 0, lines = 0;
    for (int y = 0; y < figure.image.height(); ++y)
      for (int x = 0; x < figure.image.width(); ++x) {
        const auto pixel = figure.image.pixel(x, y);
        if (is_paper(pixel)) continue;
        const testing::Reading seen = read_off(pixel);
        constexpr double step = 3 / 500.0;  // of readings, and 4 % for the shading
        const bool on_bar = seen.distance < 0.03;
        if (on_bar && std::abs(seen.value - 3) < 0.12 + step)
          ++thin;
        else if (on_bar && std::abs(seen.value - 1.5) < 0.12 + step)
          ++thick;
        else if (on_bar && seen.value > 1.7 && seen.value < 2.7)
          ++mean;
        else
          ++lines;
      }
    EXPECT_GT(thin, 50'000);
    EXPECT_GT(thick, 50'000);
    EXPECT_EQ(mean, 0);
    EXPECT_LT(lines, 0.1 * (thin + thick));
  }
}

/// Where a figure made by field_figure() in space has a point, in pixels of its image; lines add `reach`.
class PixelFinder {
 public:
  PixelFinder(const ShellModel& model, const PictureOptions& options) : size_(options.size) {
    Scene scene;
    Surface surface;
    surface.points = model.mesh->points.vector();
    for (int f = 0; f < model.mesh->topology.num_faces(); ++f) {
      const auto c = model.mesh->topology.face(FaceId(f));
      surface.triangles.push_back({c[0].value, c[1].value, c[2].value});
      surface.triangles.push_back({c[0].value, c[2].value, c[3].value});
    }
    scene.surfaces.push_back(surface);
    camera_ = fit_camera(scene, shell_view_direction(), options.up,
                         static_cast<double>(size_.width) / size_.height);
    for (const Vec3& p : surface.points)
      corner_ = corner_.cwiseMin(project(p, camera_, size_));
  }

  [[nodiscard]] Vec2 operator()(const Vec3& p) const {
    constexpr double density = 2, margin = 10, reach = 0.7;  // half a border
    return density * (project(p, camera_, size_) - corner_ + Vec2::Constant(margin + reach));
  }

 private:
  PictureSize size_;
  Camera camera_;
  Vec2 corner_ = Vec2::Constant(std::numeric_limits<double>::infinity());
};

// No element of this roof hides another.
TEST(ShellPictures, EveryElementHasTheColourOfItsStress) {
  const ShellResult result =
      run_shell_problem(read_problem(std::filesystem::path(LIMES_DATA_DIR) / "hole_5.toml"));
  const PixelFinder pixel_of(result.model, {});
  for (const ShellSide side : {ShellSide::top, ShellSide::bottom}) {
    const Figure figure = ShellPictures(result).von_mises(side);
    const ColourScale& scale = figure.bar->scale;
    const BarReader read_off(scale);
    for (int f = 0; f < result.model.mesh->topology.num_faces(); ++f) {
      const ShellQuad quad = result.model.quad(FaceId(f));
      const ShellSection section = result.model.section(FaceId(f));
      const double z = (side == ShellSide::top ? 0.5 : -0.5) * section.thickness;
      const double stress = shell_von_mises(
          mitc4_resultants(quad, section, result.model.unknowns(FaceId(f), result.solution.u),
                           {0, 0}),
          section.thickness, z);
      const Vec2 at = pixel_of(quad.position({0.2, 0.2}));  // not on the diagonal
      const testing::Reading seen =
          read_off(figure.image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y())));
      EXPECT_NEAR(seen.value, stress, 0.045 * scale.high) << f;
    }
  }
}

// A cylinder whose faces point outwards, seen from outside and from inside.
TEST(ShellPictures, CaptionsSayWhichSideIsSeen) {
  const ShellResult strip = stepped_strip();
  EXPECT_NE(ShellPictures(strip).von_mises(ShellSide::top).caption.find("this view shows the top"),
            std::string::npos);
  const std::vector<std::string> coarse{"mesh.levels=1"};
  const ShellResult cylinder = run_shell_problem(
      read_problem(std::filesystem::path(LIMES_DATA_DIR) / "cylinder_plate_a.toml", coarse));
  EXPECT_NE(ShellPictures(cylinder).von_mises(ShellSide::top).caption.find("shows both sides"),
            std::string::npos);
}

// A point load: the bar ends below its peak and says so, the caption has the peak.
TEST(ShellPictures, PeaksDoNotBleachTheRest) {
  const ShellResult result = run_shell_problem(
      read_problem(std::filesystem::path(LIMES_DATA_DIR) / "pinched_cylinder.toml"));
  const Figure figure = ShellPictures(result).von_mises(ShellSide::top);
  EXPECT_TRUE(figure.bar->tip_above);
  EXPECT_EQ(figure.caption.find("Largest: "), 0U);
  EXPECT_GT(std::stod(figure.caption.substr(9)), 1.5 * figure.bar->scale.high);
}

}  // namespace
}  // namespace limes
