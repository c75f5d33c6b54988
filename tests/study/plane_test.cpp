#include <gtest/gtest.h>

#include "study/solved.h"
#include "study/tension.h"

namespace limes {
namespace {

const std::string tension = testing::tension("1", "0.6");

// Two corners of a square under its own weight: each carries half, by symmetry, though the functions
// of the two overlap.
TEST(Reactions, AreSharedFairlyByNeighbours) {
  const std::string text = steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "vertex:0"
fix = ["ux", "uy"]
[[support]]
where = "vertex:1"
fix = ["uy"]
[[load]]
where = "all"
force_per_area = [0, -1]
)";
  const Solved s = solve(text, testing::grid(1, 1, [](const Vec2& p) { return p; }));
  EXPECT_NEAR(s.solution.reactions[0].force(1), 0.5, 1e-10);
  EXPECT_NEAR(s.solution.reactions[1].force(1), 0.5, 1e-10);
}

// Hole faces are no part of the domain: what remains is a narrower strip with sides of its own.
TEST(Holes, BoundTheDomain) {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return p; });
  for (const int f : {12, 13, 14, 15})
    mesh.tags.holes.emplace_back(f);
  std::string text = steel + tension;
  text.replace(text.find("at = [1, 1, 0]"), 14, "at = [1, 0.75, 0]");
  const Solved s = solve(text, mesh);
  EXPECT_NEAR(s.probes[0].state.u.x(), 0.4, 1e-10);
  EXPECT_NEAR(s.probes[0].state.u.y(), -0.75 * 0.1, 1e-10);
  EXPECT_NEAR(s.solution.reactions[0].force(0), -0.6 * 0.75, 1e-10);
  // The border of the hole carries loads: pushing on it is a compression across the strip.
  const std::string push = steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "y == 0"
fix = ["uy"]
[[support]]
where = "vertex:0"
fix = ["ux"]
[[load]]
where = "y == 0.75"
pressure = 1.5
[[probe]]
name = "top"
at = [1, 0.75, 0]
)";
  const PlaneState top = solve(push, mesh).probes[0].state;
  EXPECT_NEAR(top.stress(1), -1.5, 1e-9);
  EXPECT_NEAR(top.u.y(), -1.5 / 3.0 * 0.75, 1e-10);
}

TEST(Probes, FindPointsNextToAnExtraordinaryVertex) {
  Mesh mesh = testing::regular_polygon(5);
  std::string text = steel + R"(
[model]
kind = "plane-stress"
[[support]]
where = "all"
fix = ["ux", "uy"]
)";
  for (const char* at : {"[0.05, 0.05]", "[0.03, 0.01]", "[-0.2, 0.001]", "[0, 0]"})
    text += std::string("[[probe]]\nname = \"") + at + "\"\nat = " + at + "\n";
  for (const ProbeResult& p : solve(text, mesh).probes)
    EXPECT_LT(p.distance, 1e-9) << p.name;
}

TEST(RigidMotion, IsNamed) {
  const Mesh mesh = testing::grid(2, 2, [](const Vec2& p) { return p; });
  const std::string model = steel + "[model]\nkind = \"plane-stress\"\n";
  EXPECT_NE(message_of(model + "[[support]]\nwhere = \"x == 0\"\nfix = [\"ux\"]\n", mesh)
                .find("p.toml: the model can still move along y"),
            std::string::npos);
  EXPECT_NE(message_of(model + "[[support]]\nwhere = \"x == 0\"\nfix = [\"uy\"]\n", mesh)
                .find("move along x"),
            std::string::npos);
  EXPECT_NE(message_of(model + "[[support]]\nwhere = \"vertex:8\"\nfix = [\"ux\", \"uy\"]\n", mesh)
                .find("turn about (1, 1)"),
            std::string::npos);
}

// Two squares that touch in the middle of a grid, where holes are cut off by creases: nothing but one
// value is common to both.
TEST(RigidMotion, NamesTheHinge) {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return p; });
  for (const int f : {2, 3, 6, 7, 8, 9, 12, 13})
    mesh.tags.holes.emplace_back(f);
  for (int i = 0; i < 4; ++i)
    for (const auto& [a, b] : {std::pair(10 + i, 11 + i), std::pair(2 + 5 * i, 7 + 5 * i)})
      mesh.tags.creases.push_back({VertexId(a), VertexId(b), infinite_sharpness});
  const std::string text = steel + "[model]\nkind = \"plane-stress\"\n[[support]]\n";
  const std::string hinge = "p.toml: the model can still turn about (0.5, 0.5), vertex 12, ";
  const std::string held = text + "where = \"x == 0\"\nfix = [\"ux\", \"uy\"]\n";
  EXPECT_EQ(message_of(held, mesh).substr(0, hinge.size()), hinge);
  const std::string second = "[[support]]\nwhere = \"vertex:24\"\nfix = [\"uy\"]\n";
  EXPECT_EQ(message_of(held + second, mesh), "no error");
  // Without creases the functions reach across: value and slope are common, and there is no hinge.
  mesh.tags.creases.clear();
  EXPECT_EQ(message_of(held, mesh), "no error");
}

TEST(Messages, NameThePlace) {
  const Mesh mesh = testing::grid(2, 2, [](const Vec2& p) { return p; });
  std::string endless = steel + tension;
  endless.replace(endless.find("[0.6, 0]"), 8, "[\"1/(x-1)\", 0]");
  EXPECT_NE(message_of(endless, mesh).find("has no finite value at (1, "), std::string::npos);
  Mesh bent = mesh;
  bent.points[VertexId(4)].z() = 0.1;
  EXPECT_NE(message_of(steel + tension, bent).find("not plane"), std::string::npos);
  Mesh folded = mesh;
  folded.points[VertexId(4)] = Vec3(2.5, 2.5, 0);
  const std::string place = "m.obj: face 1: the surface is folded";
  for (const char* levels : {"", "levels = 2\n"})  // the face is that of the file
    EXPECT_EQ(message_of(levels + steel + tension, folded).substr(0, place.size()), place);
  const std::string periodic =
      steel + "[model]\nkind = \"plane-stress\"\n[periodic]\ngradient = [[1, 0.1], [0.1, 1]]\n";
  Mesh shifted = testing::grid(3, 3, [](const Vec2& p) {
    return Vec2(p.x(), p.x() == 0 && p.y() > 0 && p.y() < 0.5 ? p.y() + .1 : p.y());
  });
  EXPECT_NE(message_of(periodic, shifted).find("has no partner on the right"), std::string::npos);
}

}  // namespace
}  // namespace limes
