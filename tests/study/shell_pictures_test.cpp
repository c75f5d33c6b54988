// Pictures of stresses of shells, pixel by pixel against exact stresses.

#include "limes/study/shell_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

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

/// A shell of steel on the plane z = 0.
ShellResult held_below(const Mesh& mesh) {
  return solved(parse_problem(R"([mesh]
file = "m.obj"
scheme = "linear"
[model]
kind = "mitc4"
[material]
young = 2e5
poisson = 0.3
thickness = 0.1
[[support]]
where = "z == 0"
fix = ["ux", "uy", "uz", "rx", "ry", "rz"]
[[load]]
where = "all"
force_per_area = [0, 0, -1]
)",
                              "p.toml"),
                mesh);
}

/// A pipe around z, of radius 1 and height 2, whose faces point outwards.
Mesh pipe(int around, int along) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double a = 2 * std::numbers::pi * i / around;
      x.emplace_back(std::cos(a), std::sin(a), 2.0 * j / along);
      const int next = (i + 1) % around, v = around * j;
      if (j < along)
        quads.insert(quads.end(), {v + i, v + next, v + around + next, v + around + i});
    }
  return testing::make_mesh(std::move(x), std::move(quads));
}

Mesh cube() {
  return testing::make_mesh(
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}},
      {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7});
}

Mesh turned_over(const Mesh& mesh) {
  std::vector<int> quads;
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    for (int k = 3; k >= 0; --k)
      quads.push_back(mesh.topology.face(FaceId(f))[static_cast<std::size_t>(k)].value);
  return testing::make_mesh(mesh.points.vector(), std::move(quads));
}

// What a closed shell turns away is hidden; into a pipe one looks from above.
TEST(ShellPictures, CaptionsSayWhichSideIsSeen) {
  const auto seen = [](const ShellResult& result) {
    const std::string caption = ShellPictures(result).von_mises(ShellSide::top).caption;
    return caption.substr(caption.find("this view shows"));
  };
  const ShellResult strip = stepped_strip();
  EXPECT_EQ(seen(strip), "this view shows the top.");
  EXPECT_EQ(seen(solved(strip.model.problem, turned_over(strip.model.control))),
            "this view shows the bottom.");
  EXPECT_EQ(seen(held_below(cube())), "this view shows the top.");
  EXPECT_EQ(seen(held_below(turned_over(cube()))), "this view shows the bottom.");
  EXPECT_EQ(seen(held_below(pipe(24, 6))), "this view shows both sides.");
}

TEST(ShellPictures, CaptionsHaveTheLargestStressWithUnits) {
  ShellResult strip = stepped_strip();
  const std::string caption = ShellPictures(strip).von_mises(ShellSide::top).caption;
  EXPECT_EQ(caption.find("Largest: 3 N/mm² at ("), 0U) << caption;
  EXPECT_NE(caption.find(") mm. Top is"), std::string::npos) << caption;
  strip.solution.u.setZero();
  EXPECT_EQ(ShellPictures(strip).von_mises(ShellSide::top).caption.find("No stress. Top is"), 0U);
}

// The view to turn has no bar: its caption says what the colours mean. Of fine meshes there is no view.
TEST(ShellPictures, ReportsSayWhatTheViewShows) {
  const auto page = [](const ShellResult& result) { return report_files(result).back().bytes; };
  ShellResult strip = stepped_strip();
  EXPECT_NE(page(strip).find("the pictures above: from 0 to 3 N/mm<sup>2</sup>."),
            std::string::npos);
  strip.model = build_shell_model(strip.model.problem, testing::grid(72, 70, [](const Vec2& p) {
                                    return Vec2(2 * p.x(), p.y());
                                  }));
  strip.solution.u = VectorX::Zero(strip.model.num_unknowns());
  EXPECT_NE(page(strip).find("There is no view to turn: the mesh has more than 5000 elements."),
            std::string::npos);
}

TEST(ShellPictures, ResultsNameTheUnits) {
  const nlohmann::ordered_json units = result_json(stepped_strip())["units"];
  EXPECT_EQ(units.dump(), R"({"length":"mm","force":"N","rotation":"rad"})");
}

// 1e-200 squared is 0.
TEST(ShellPictures, DisplacementsMayBeTiny) {
  ShellResult strip = stepped_strip();
  const double largest = ShellPictures(strip).displacement().bar->scale.high;
  strip.solution.u *= 1e-200;
  EXPECT_NEAR(ShellPictures(strip).displacement().bar->scale.high / largest, 1e-200, 1e-212);
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
