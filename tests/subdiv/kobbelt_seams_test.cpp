#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"

// Creases, seams, several parts at a curve, cusps: docs/theory/kobbelt.md.

namespace limes {
namespace {

const Scheme& kobbelt() {
  return find_scheme("kobbelt");
}

RefineOptions with_corners(CornerRule rule, int levels) {
  RefineOptions options{.levels = levels};
  options.corners = rule;
  return options;
}

Mesh noisy(Mesh mesh) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  for (Vec3& x : mesh.points)
    x += Vec3(shift(random), shift(random), shift(random));
  return mesh;
}

/// The faces of several meshes side by side.
Mesh joined(const std::vector<Mesh>& parts) {
  Mesh all;
  std::vector<VertexId> corners;
  for (const Mesh& part : parts) {
    for (const VertexId v : part.topology.corners())
      corners.emplace_back(v.value + all.points.size());
    for (const CornerTag& tag : part.tags.corners)
      all.tags.corners.push_back({VertexId(tag.vertex.value + all.points.size()), tag.sharpness});
    for (const Vec3& x : part.points)
      all.points.push_back(x);
  }
  all.topology = Topology(all.points.size(), 4, std::move(corners));
  return all;
}

/// columns x lines quads, placed by a map from (i, j).
template <class Place>
Mesh sheet(int columns, int lines, const Place& place) {
  Mesh mesh = shapes::grid(columns, lines);
  for (Vec3& x : mesh.points)
    x = place(x.x(), x.y());
  return mesh;
}

/// A 6 x 4 grid with noise, creased along the middle.
Mesh creased_grid() {
  Mesh mesh = noisy(shapes::grid(6, 4));
  for (int j = 0; j < 4; ++j)
    mesh.tags.creases.push_back({VertexId(3 + 7 * j), VertexId(3 + 7 * (j + 1)), 10.0F});
  return mesh;
}

TEST(KobbeltCrease, IsTwoOpenNetsAlongACommonCurve) {
  const Mesh whole = creased_grid();
  const Mesh left = sheet(3, 4, [&](double i, double j) {
    return whole.points[VertexId(static_cast<int>(i + 7 * j))];
  });
  const Mesh right = sheet(3, 4, [&](double i, double j) {
    return whole.points[VertexId(static_cast<int>(3 + i + 7 * j))];
  });
  const Mesh fine = refine(whole, kobbelt(), {.levels = 3});
  const Mesh fine_left = refine(left, kobbelt(), {.levels = 3});
  const Mesh fine_right = refine(right, kobbelt(), {.levels = 3});
  double apart = 0;
  for (int f = 0; f < fine.topology.num_faces(); ++f) {
    const int control = f / 64, column = control % 6, line = control / 6;
    const Mesh& part = column < 3 ? fine_left : fine_right;
    const FaceId own(64 * (3 * line + column % 3) + f % 64);
    for (std::size_t i = 0; i < 4; ++i)
      apart = std::max(apart, (fine.points[fine.topology.face(FaceId(f))[i]] -
                               part.points[part.topology.face(own)[i]])
                                  .norm());
  }
  EXPECT_LE(apart, 1e-14);
  EXPECT_EQ(fine.tags.creases.size(), 32U);
}

/// The points of one seam, seen by several parts: number of different positions and of vertices.
struct SeamCount {
  std::size_t positions, vertices;
};
template <class OnSeam>
SeamCount count_seam(const Mesh& mesh, const OnSeam& on_seam) {
  const Adjacency adjacency(mesh.topology);
  std::map<std::array<double, 3>, int> found;
  std::size_t vertices = 0;
  for (int v = 0; v < mesh.points.size(); ++v) {
    const Vec3& x = mesh.points[VertexId(v)];
    if (!adjacency.is_boundary(VertexId(v)) || !on_seam(x)) continue;
    ++found[{x.x(), x.y(), x.z()}];
    ++vertices;
  }
  return {found.size(), vertices};
}

/// Three sheets of 3 x 6 quads that meet in the curve x = y = 0 ... z = 0 .. 6, bent.
Mesh three_sheets() {
  const auto curve = [](double t) { return Vec3(std::sin(t / 3), 0.2 * t * t / 6, t); };
  const auto leaf = [&](const Vec3& direction, bool turned) {
    return sheet(3, 6, [=](double i, double j) {
      return Vec3(curve(turned ? 6 - j : j) + (turned ? 3 - i : i) * direction);
    });
  };
  // One of them runs along the seam the other way.
  return joined({leaf({1, 0.1, 0}, false), leaf({-0.6, 1, 0}, true), leaf({-0.6, -1, 0}, false)});
}

TEST(KobbeltSeam, ThreePartsShareTheirCurveBitForBit) {
  for (const CornerRule rule : {CornerRule::by_angle, CornerRule::none, CornerRule::all}) {
    const Mesh control = three_sheets();
    std::vector<Vec3> seam;
    for (int j = 0; j <= 6; ++j)
      seam.push_back(control.points[VertexId(4 * j)]);
    const Mesh fine = refine(control, kobbelt(), with_corners(rule, 3));
    const SeamCount count = count_seam(fine, [&](const Vec3& x) {
      return std::abs(x.y() - 0.2 * x.z() * x.z() / 6) < 0.05 &&
             std::abs(x.x() - std::sin(x.z() / 3)) < 0.05;
    });
    EXPECT_EQ(count.positions, 49U);
    EXPECT_EQ(count.vertices, 3U * 49U);
  }
}

/// A vertex of three or more parts breaks the curve in each, whatever the angle; with CornerRule::none
/// only where the curves leave no choice.
TEST(KobbeltSeam, BreaksWhereThreePartsMeet) {
  const auto corners = [](const Mesh& mesh, CornerRule rule) {
    return refine(mesh, kobbelt(), with_corners(rule, 1)).tags.corners.size();
  };
  EXPECT_EQ(corners(three_sheets(), CornerRule::none), 3U * 2U);  // the ends of the seam
  EXPECT_EQ(corners(three_sheets(), CornerRule::by_angle), 3U * 7U + 3U * 2U);
  // A half and two quarters of a square: straight on for the half, but three parts.
  const auto square = [](double x, double y, int columns, int lines) {
    return sheet(columns, lines, [=](double i, double j) { return Vec3(x + i, y + j, 0); });
  };
  const Mesh tee = joined({square(0, 0, 4, 2), square(0, 2, 2, 2), square(2, 2, 2, 2)});
  const Mesh fine = refine(tee, kobbelt(), with_corners(CornerRule::none, 1));
  int middle = 0;
  for (const CornerTag& tag : fine.tags.corners)
    middle += fine.points[tag.vertex] == Vec3(2, 2, 0) ? 1 : 0;
  EXPECT_EQ(middle, 3);
  // Two parts leave a straight seam smooth, but for its ends, where two boundaries join it.
  const Mesh two = joined({square(0, 0, 4, 2), square(0, 2, 4, 2)});
  EXPECT_EQ(corners(two, CornerRule::none), 4U);
}

TEST(KobbeltSeam, PartsBreakTogether) {
  const auto square = [](double y) {
    return sheet(4, 2, [=](double i, double j) { return Vec3(i, y + j, 0); });
  };
  Mesh two = joined({square(0), square(2)});
  two.tags.corners = {{VertexId(2 + 5 * 2), 10.0F}};  // in the middle of the seam, of one part
  const Mesh fine = refine(two, kobbelt(), with_corners(CornerRule::none, 2));
  int broken = 0;
  for (const CornerTag& tag : fine.tags.corners)
    broken += fine.points[tag.vertex] == Vec3(2, 2, 0) ? 1 : 0;
  EXPECT_EQ(broken, 2);
}

/// A hole whose boundary shrinks to a point [kobbelt_1996, Fig. 5]: a disk without its middle,
/// lifted to a tip.
TEST(KobbeltCusp, IsAHoleThatShrankToAPoint) {
  Mesh mesh = shapes::cylinder(8, 3);
  const Vec3 tip(0.1, 0.2, 3);
  double top = 0;
  for (const Vec3& x : mesh.points)
    top = std::max(top, x.z());
  for (Vec3& x : mesh.points) {
    const double up = x.z() / top;
    x = x.z() == top ? tip : Vec3((1 - up * up) * x.x(), (1 - up * up) * x.y(), 3 * up);
  }
  const Mesh fine = refine(mesh, kobbelt(), with_corners(CornerRule::by_angle, 4));
  const Adjacency adjacency(fine.topology);
  int at_tip = 0;
  for (int v = 0; v < fine.points.size(); ++v) {
    const Vec3& x = fine.points[VertexId(v)];
    ASSERT_TRUE(x.allFinite());
    if (adjacency.is_boundary(VertexId(v)) && x.z() > 2) {
      EXPECT_LE((x - tip).norm(), 1e-15);
      ++at_tip;
    } else {
      EXPECT_LT(x.z(), tip.z() + 0.1);
    }
  }
  EXPECT_EQ(at_tip, 8 * 16);
}

void expect_refusal(const Mesh& mesh, const std::string& word) {
  try {
    (void)refine(mesh, kobbelt(), {.levels = 1});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(KobbeltCrease, RefusesWhatItCannotDefine) {
  Mesh mesh = shapes::cube();
  mesh.tags.creases = {{VertexId(0), VertexId(1), 2.5F}};
  expect_refusal(mesh, "sharpness 2.5");
  mesh.tags.creases = {{VertexId(0), VertexId(1), 10.0F}};
  expect_refusal(mesh, "single edge");
  mesh.tags.creases = {};
  mesh.tags.corners = {{VertexId(3), 1.0F}};
  expect_refusal(mesh, "corner 3");
  Mesh triangles = shapes::tetrahedron();
  expect_refusal(triangles, "face 0");
}

/// A crease that ends inside the surface.
TEST(KobbeltCrease, MayEndInTheSurface) {
  Mesh mesh = shapes::grid(6, 6);
  for (Vec3& x : mesh.points)
    x.z() = 0.3 * std::abs(x.x() - 3) * std::max(0.0, 3 - x.y());
  for (int j = 0; j < 3; ++j)
    mesh.tags.creases.push_back({VertexId(3 + 7 * j), VertexId(3 + 7 * (j + 1)), 10.0F});
  const Mesh fine = refine(mesh, kobbelt(), {.levels = 3});
  EXPECT_EQ(fine.tags.creases.size(), 24U);
  for (const Vec3& x : fine.points) {
    ASSERT_TRUE(x.allFinite());
    if (std::abs(x.x() - 3) < 1e-12) {
      EXPECT_NEAR(x.z(), 0, 0.1);
    }
  }
}

/// Partial updates renew everything that changed, through extrapolated vertices too.
TEST(KobbeltUpdate, AgreesWithRefinementFromScratch) {
  for (const Mesh& control : {creased_grid(), noisy(shapes::half_disk(4, 3))}) {
    const Adjacency adjacency(control.topology);
    const Features features = control_features(adjacency, control, kobbelt(), {});
    const RefinementStep step(adjacency, features, kobbelt());
    for (int moved = 0; moved < control.points.size(); ++moved) {
      std::vector<Vec3> points = control.points.vector();
      std::vector<Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
      step.apply(points, fine);
      points[static_cast<std::size_t>(moved)] += Vec3(0.3, 0.2, -0.1);
      const VertexId changed(moved);
      (void)step.update(points, {&changed, 1}, fine);
      std::vector<Vec3> expected(fine.size());
      step.apply(points, expected);
      EXPECT_EQ(fine, expected) << moved;
    }
  }
}

}  // namespace
}  // namespace limes
