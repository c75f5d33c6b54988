// limes adapt --surfaces: vertices on exact surfaces.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "cli/program.h"
#include "limes/io/io.h"
#include "limes/mesh/measure.h"
#include "limes/study/shell_placement.h"

namespace limes::test {
namespace {

std::vector<std::string> adapt(const std::string& mesh, const std::string& surfaces,
                               const std::string& output, const std::string& where,
                               const std::string& levels) {
  return {"adapt",  mesh,      "-o",  output,     "--scheme", "linear", "--surfaces",
          surfaces, "--where", where, "--levels", levels,     "--json"};
}

Mesh adapted(const TempFolder& folder, std::vector<std::string> arguments) {
  const Result result = run_limes(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_FALSE(folder.list().empty());
  return read_mesh(arguments[3]).mesh;
}

using Point = std::array<double, 3>;
std::set<Point> points_of(const Mesh& mesh) {
  std::set<Point> points;
  for (const Vec3& x : mesh.points)
    points.insert({x.x(), x.y(), x.z()});
  return points;
}

TEST(AdaptSurfaces, VerticesLieOnTheSurface) {
  const TempFolder folder;
  const std::string sphere =
      folder.file("sphere.toml", "[geometry]\nkind = \"sphere\"\nradius = 2\n");
  const Mesh ball =
      adapted(folder, adapt(data_file("cube.obj"), sphere, folder / "a.ply", "z > 0", "4"));
  EXPECT_EQ(measure(ball).euler, 2);
  EXPECT_GT(ball.points.size(), 100);
  for (const Vec3& x : ball.points)
    EXPECT_NEAR(x.norm(), 2, 2e-14);

  const std::string torus =
      folder.file("torus.toml", "[geometry]\nkind = \"torus\"\nradius = 2\ntube_radius = 0.75\n");
  const Mesh ring =
      adapted(folder, adapt(data_file("torus.obj"), torus, folder / "b.ply", "x > 0", "3"));
  EXPECT_EQ(measure(ring).euler, 0);
  for (const Vec3& x : ring.points)
    EXPECT_NEAR(std::hypot(std::hypot(x.x(), x.y()) - 2, x.z()), 0.75, 1e-14);
}

// The same places as uniform refinement, which another function computes, bit for bit.
TEST(AdaptSurfaces, PlacesAreThoseOfUniformRefinement) {
  const TempFolder folder;
  const std::string surfaces = data_file("hole_5.toml"), mesh = data_file("hole_5.obj");
  const std::string near_hole = "hypot(25 * atan2(x, z), y) < 12";
  const Problem problem = read_problem(surfaces);
  Mesh control = read_mesh(mesh).mesh;
  const std::set<Point> uniform = points_of(refined_on_surfaces(problem, control, 4));
  EXPECT_EQ(points_of(adapted(folder, adapt(mesh, surfaces, folder / "u.ply", "all", "4"))),
            uniform);
  for (const char* closure : {"conforming", "triangles", "hanging"}) {
    auto arguments = adapt(mesh, surfaces, folder / "a.ply", near_hole, "4");
    arguments.insert(arguments.end(), {"--closure", closure});
    const Mesh local = adapted(folder, arguments);
    EXPECT_LT(local.points.size(), static_cast<int>(uniform.size()));
    const std::set<Point> points = points_of(local);
    EXPECT_TRUE(std::includes(uniform.begin(), uniform.end(), points.begin(), points.end()))
        << closure;
    int rim = 0;
    for (const Vec3& x : local.points) {
      EXPECT_NEAR(std::hypot(x.x(), x.z()), 25, 25e-14);
      rim += std::abs(std::hypot(25 * std::atan2(x.x(), x.z()), x.y()) - 5) < 1e-12;
    }
    EXPECT_GE(rim, 65) << closure;  // all of the rim is refined twice at least
  }
}

/// On a cylinder of radius 6 at 45 degrees, and on the plane z = 0.
bool is_on_ellipse(const Vec3& x, double tolerance) {
  const Vec3 axis = Vec3(1, 0, 1).normalized();
  return std::abs(x.z()) < tolerance &&
         std::abs((x - x.dot(axis) * axis).norm() - 6) < 6 * tolerance;
}

/// Edges of one face on the ellipse that a cylinder and a plate share, by their ends, of one part.
std::set<std::array<Point, 2>> edges_on_seam(const Mesh& mesh, const FaceGroup& part) {
  std::map<std::array<Point, 2>, int> faces;
  for (const FaceId f : part.faces) {
    const auto face = mesh.topology.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 a = mesh.points[face[i]], b = mesh.points[face[(i + 1) % face.size()]];
      std::array ends{Point{a.x(), a.y(), a.z()}, Point{b.x(), b.y(), b.z()}};
      if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
      if (is_on_ellipse(a, 1e-9) && is_on_ellipse(b, 1e-9)) ++faces[ends];
    }
  }
  std::set<std::array<Point, 2>> rim;
  for (const auto& [ends, count] : faces)
    if (count == 1) rim.insert(ends);
  return rim;
}

TEST(AdaptSurfaces, SeamsStayClosedAndLieOnBothSurfaces) {
  const TempFolder folder;
  for (const char* closure : {"conforming", "triangles", "hanging"}) {
    auto arguments =
        adapt(data_file("cylinder_plate_6_quads.obj"), data_file("cylinder_plate_b.toml"),
              folder / "a.obj", "x > 3 and z < 3 and z > -0.1", "3");
    arguments.insert(arguments.end(), {"--closure", closure});
    const Mesh mesh = adapted(folder, arguments);
    ASSERT_EQ(mesh.parts.size(), 2U);
    const auto one = edges_on_seam(mesh, mesh.parts[0]), other = edges_on_seam(mesh, mesh.parts[1]);
    EXPECT_EQ(one, other) << closure;
    EXPECT_GT(one.size(), 8U) << closure;
    EXPECT_LT(one.size(), 64U) << closure;
    for (const auto& ends : one)
      for (const Point& p : ends)
        EXPECT_TRUE(is_on_ellipse(Vec3(p[0], p[1], p[2]), 1e-14)) << closure;
  }
}

TEST(AdaptSurfaces, RefusesWhatDoesNotFit) {
  const TempFolder folder, files;
  const std::string out = folder / "x.ply", cube = data_file("cube.obj");
  const auto refused = [&](const std::string& text, int code, const std::string& message) {
    const std::string surfaces = files.file("s.toml", text);
    expect_failure(run_limes(adapt(cube, surfaces, out, "all", "1")), code, message);
  };
  refused("[geometry]\nkind = \"cone\"\n", 3,
          "s.toml:1: [geometry] angle is missing; a cone needs it");
  refused("[geometry]\nkind = \"sphere\"\nradius = 0\n", 3,
          "s.toml:3: [geometry] radius is 0; it must be a number > 0");
  refused("kind = 3\n", 3, "s.toml:1: a problem has no key 'kind'");
  refused("[geometry\n", 3, "s.toml:1: ");
  refused("[[seam]]\nparts = [\"a\", \"b\"]\n", 3, "s.toml: [geometry] is missing");
  refused("[geometry]\npart = \"lid\"\nkind = \"sphere\"\nradius = 1\n", 3,
          "s.toml:2: there is no part 'lid'; known are cube");
  refused("[geometry]\nkind = \"sphere\"\nradius = 1\npoint = [1, 1, 1]\n", 3,
          "s.toml:1: a vertex at (1, 1, 1) is on the axis or at the centre of [geometry]");
  refused("[geometry]\nkind = \"sphere\"\nradius = 1\n[[curve]]\nwhere = \"all\"\nzero = \"x\"\n",
          3, "s.toml:5: 'all' selects no boundary edge of the control mesh");
  const std::string plate = data_file("cylinder_plate_6_quads.obj");
  expect_failure(run_limes(adapt(plate,
                                 files.file("s.toml",
                                            "[geometry]\npart = \"plate\"\nkind = \"plane\"\n"
                                            "axis = [0, 0, 1]\n"),
                                 out, "all", "1")),
                 3,
                 "s.toml:2: every part needs a [geometry] to place vertices on; face 0 has none");
  expect_failure(run_limes(adapt(cube, files / "none.toml", out, "all", "1")), 3, "none.toml");
  auto arguments = adapt(cube, files.file("s.toml", "[geometry]\nkind = \"sphere\"\nradius = 1\n"),
                         out, "all", "1");
  arguments[5] = "kobbelt";
  expect_failure(run_limes(arguments), 2, "--surfaces: vertices start halfway between others");
  EXPECT_TRUE(folder.list().empty());
}

/// The file that is wrong comes first in the message.
TEST(AdaptSurfaces, RefusesPlacementsWithoutArea) {
  const TempFolder folder, files;
  std::string mesh = data_file("cube.obj");
  const auto refused = [&](const std::string& text, const std::string& where,
                           const std::string& message) {
    const std::string surfaces = files.file("s.toml", text);
    const Result result = run_limes(adapt(mesh, surfaces, folder / "x.ply", where, "3"));
    expect_failure(result, 3, message);
    EXPECT_EQ(result.err.find("limes: " + surfaces + ":1: "), 0U) << result.err;
  };
  refused(
      "[geometry]\nkind = \"cone\"\nangle = 30\npoint = [0, 0, 9]\n", "all",
      "face 0 has no area on this surface: its vertices come to one point or line at (0, 0, 9)");
  refused("[geometry]\nkind = \"sphere\"\nradius = 1\npoint = [1e20, 0, 0]\n", "all",
          "face 0 has no area on this surface");
  refused("[geometry]\nkind = \"plane\"\naxis = [1, 0, 0]\n", "all", "has no area on this surface");
  // Only a vertex of the refinement has no place, in the middle of a face.
  mesh = files.file("quad.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
  refused("[geometry]\nkind = \"graph\"\nheight = \"1 / (abs(x) + abs(y)) - 0.5\"\n", "all",
          "has no finite value at (0, 0)");
  EXPECT_TRUE(folder.list().empty());
}

TEST(AdaptSurfaces, BytesDoNotDependOnThreads) {
  const TempFolder folder;
  for (const char* threads : {"1", "4"}) {
    auto arguments = adapt(data_file("hole_5.obj"), data_file("hole_5.toml"),
                           folder / (std::string(threads) + ".vtu"), "y < 5", "3");
    arguments.insert(arguments.end(), {"--threads", threads});
    ASSERT_EQ(run_limes(arguments).exit_code, 0);
  }
  EXPECT_EQ(read_file(folder / "1.vtu"), read_file(folder / "4.vtu"));
}

}  // namespace
}  // namespace limes::test
