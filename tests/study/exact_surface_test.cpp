// Exact surfaces: the nearest point by what defines it, and what has none.

#include "limes/study/exact_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "limes/core/error.h"
#include "study/problem_draft.h"

namespace limes {
namespace {

GeometrySettings read(const std::string& table) {
  return *parse_surfaces("[geometry]\n" + table, "s.toml").geometry;
}

struct Case {
  const char* table;
  double (*distance)(const Vec3& x);  // from the surface, in closed form
};
constexpr double pi = 3.14159265358979323846;
/// Of the point in the half plane of axis and x.
double beside(const Vec3& x, const Vec3& point) {
  return std::hypot(x.x() - point.x(), x.y() - point.y());
}
const Case cases[] = {
    {"kind = \"cylinder\"\nradius = 2\npoint = [1, 0, 7]",
     [](const Vec3& x) { return beside(x, Vec3(1, 0, 0)) - 2; }},
    {"kind = \"sphere\"\nradius = 3\npoint = [1, 2, 3]",
     [](const Vec3& x) { return (x - Vec3(1, 2, 3)).norm() - 3; }},
    {"kind = \"plane\"\naxis = [0, 0, 5]\npoint = [0, 0, 2]",
     [](const Vec3& x) { return x.z() - 2; }},
    {"kind = \"cone\"\nangle = 30\npoint = [0, 0, -1]",
     [](const Vec3& x) {
       return beside(x, Vec3::Zero()) * std::cos(pi / 6) - (x.z() + 1) * std::sin(pi / 6);
     }},
    {"kind = \"torus\"\nradius = 3\ntube_radius = 1\npoint = [0, 0, 1]",
     [](const Vec3& x) { return std::hypot(beside(x, Vec3::Zero()) - 3, x.z() - 1) - 1; }}};

// The distance moved is that to the surface, along the normal, and the point reached is on the surface.
TEST(ExactSurface, ProjectsToTheNearestPoint) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in(-4, 4);
  for (const Case& c : cases) {
    const GeometrySettings surface = read(c.table);
    const GeometrySettings* const one = &surface;
    for (int i = 0; i < 200; ++i) {
      const Vec3 x(in(random), in(random), in(random));
      const Vec3 p = project(surface, x);
      // beyond the apex of the cone that is nearest, the formula is that of its plane
      const bool apex = p == surface.point && surface.kind == GeometrySettings::Kind::cone;
      EXPECT_NEAR(c.distance(p), 0, 4e-15) << c.table;
      if (apex) continue;
      EXPECT_NEAR((x - p).norm(), std::abs(c.distance(x)), 1e-14) << c.table;
      EXPECT_NEAR((x - p).dot(outward_normal(surface, p)), c.distance(x), 1e-13) << c.table;
      EXPECT_NEAR((project(std::span(&one, 1), x) - p).norm(), 0, 1e-13) << c.table;
      const auto along = directions_on(std::span(&one, 1), p);
      ASSERT_EQ(along.cols(), 2);
      EXPECT_NEAR((along.transpose() * outward_normal(surface, p)).norm(), 0, 1e-14);
    }
  }
}

TEST(ExactSurface, ApexOfAConeStays) {
  const GeometrySettings cone = read("kind = \"cone\"\nangle = 60\npoint = [1, 2, 3]");
  EXPECT_EQ(project(cone, Vec3(1, 2, 3)), Vec3(1, 2, 3));
  EXPECT_EQ(project(cone, Vec3(1.1, 2, 2)), Vec3(1, 2, 3));  // behind it the apex is nearest
}

// Where two surfaces meet: a torus and a cone from its centre share circles.
TEST(ExactSurface, CommonPointsLieOnBoth) {
  const GeometrySettings torus = read(cases[4].table);
  const GeometrySettings cone = read("kind = \"cone\"\nangle = 80\npoint = [0, 0, 1]");
  const std::array both{&torus, &cone};
  for (int i = 0; i < 12; ++i) {
    const Vec3 p = project(both, Vec3(3.8 * std::cos(i), 3.8 * std::sin(i), 1.8));
    EXPECT_NEAR(cases[4].distance(p), 0, 4e-15);
    EXPECT_NEAR(std::atan2(beside(p, Vec3::Zero()), p.z() - 1), 80 * pi / 180, 4e-15);
    EXPECT_EQ(directions_on(both, p).cols(), 1);
  }
}

TEST(ExactSurface, RefusesPlacesWithoutANearestPoint) {
  const auto refused = [](const std::string& table, const Vec3& x, const char* why) {
    try {
      (void)project(read(table), x);
      ADD_FAILURE() << table;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  refused(cases[0].table, {1, 0, 3}, "(1, 0, 3) is on the axis or at the centre");
  refused(cases[1].table, {1, 2, 3}, "is on the axis or at the centre");
  refused(cases[3].table, {0, 0, 3}, "is on the axis or at the centre");
  refused(cases[4].table, {0, 0, 3}, "is on the axis or at the centre");
  refused(cases[4].table, {0, 3, 1}, "is in the middle of the tube");
}

TEST(Surfaces, AreATableOfAProblemFileOrAFileOfTheirOwn) {
  const SurfaceSettings parts = parse_surfaces(full_parts(), "p.toml");
  EXPECT_EQ(parts.geometry_of_parts.at(0).part, "floor");
  EXPECT_EQ(parts.curves.size(), 1U);
  EXPECT_EQ(parts.seams.size(), 1U);
  EXPECT_EQ(read("kind = \"torus\"\nradius = 3\ntube_radius = 1").tube_radius, 1);
  EXPECT_EQ(read("kind = \"cone\"\nangle = 20").angle, 20);
}

TEST(Surfaces, SayWhatIsWrong) {
  const auto refused = [](const std::string& text, const std::string& message) {
    try {
      (void)parse_surfaces(text, "s.toml");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), message);
    }
  };
  refused("", "s.toml: [geometry] is missing: an exact surface to place vertices on");
  refused("[geometri]\n", "s.toml:1: a problem has no key 'geometri'; did you mean 'geometry'?");
  refused("[geometry]\nkind = \"cone\"\n",
          "s.toml:1: [geometry] angle is missing; a cone needs it");
  refused("[geometry]\nkind = \"torus\"\nradius = 1\n",
          "s.toml:1: [geometry] tube_radius is missing; a torus needs it");
  refused(
      "[geometry]\nkind = \"torus\"\nradius = 1\ntube_radius = 1\n",
      "s.toml:4: [geometry] tube_radius is 1; that of a torus without self-intersections is less "
      "than its radius, 1");
  refused("[geometry]\nkind = \"sphere\"\nradius = 1\naxis = [1, 0, 0]\n",
          "s.toml:4: [geometry] axis is no key of a sphere; remove it");
  refused("[geometry]\nkind = \"plane\"\naxis = [0, 0, 0]\n",
          "s.toml:3: [geometry] axis has no direction; it must not be 0");
}

}  // namespace
}  // namespace limes
