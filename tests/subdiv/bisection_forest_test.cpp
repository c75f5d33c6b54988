#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "limes/core/error.h"
#include "limes/mesh/measure.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/bisection_forest.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/forest_checks.h"

namespace limes {
namespace {

std::vector<Model> polygon_models() {
  return {{"tetrahedron", shaken(shapes::tetrahedron())},
          {"icosahedron", shaken(shapes::icosahedron())},
          {"cube", shaken(shapes::cube())},
          {"torus", shaken(shapes::torus(5, 4))},
          {"grid", shaken(shapes::grid(3, 2))},
          {"hole", shaken(shapes::grid_with_hole(3))},
          {"heptagon", shaken(shapes::polygon(7))},
          {"triangle star", shaken(shapes::triangle_star(5, 2))},
          {"cylinder", shaken(shapes::cylinder(5, 2))},
          {"half disk", shaken(shapes::half_disk(3, 1))}};
}

/// The split of four-eight without its smoothing.
Scheme four_eight_in_place() {
  Scheme scheme = find_scheme("four-eight");
  scheme.edge_rule = linear_edge;
  scheme.vertex_rule = linear_vertex;
  scheme.interpolatory = true;
  return scheme;
}

/// Uniform refinement is another program's: faces in its order, with its corners, on all levels.
TEST(BisectionForest, AllLeavesIsFourEightRefinement) {
  const Scheme scheme = four_eight_in_place();
  for (const Model& model : polygon_models()) {
    SCOPED_TRACE(model.name);
    BisectionForest forest(model.mesh);
    for (int level = 1; level <= 6; ++level) {
      forest.refine(forest.leaves());
      const Mesh ours = forest_mesh(forest).mesh;
      const Mesh uniform = refine(model.mesh, scheme, {.levels = level});
      ASSERT_EQ(ours.topology.num_faces(), uniform.topology.num_faces());
      ASSERT_EQ(ours.topology.num_vertices(), uniform.topology.num_vertices());
      for (int f = 0; f < ours.topology.num_faces(); ++f)
        for (std::size_t i = 0; i < 3; ++i)
          ASSERT_LE((ours.points[ours.topology.face(FaceId(f))[i]] -
                     uniform.points[uniform.topology.face(FaceId(f))[i]])
                        .norm(),
                    1e-15)
              << "level " << level << " face " << f;
    }
  }
}

std::vector<FaceId> some(const BisectionForest& forest, std::mt19937& random, unsigned one_in,
                         int finest) {
  std::vector<FaceId> chosen;
  for (const FaceId f : forest.leaves())
    if (random() % one_in == 0 && forest.ancestry(f).level < finest) chosen.push_back(f);
  return chosen;
}

TEST(BisectionForest, RandomSequencesStayConforming) {
  constexpr int finest = 8;
  for (const Model& model : polygon_models()) {
    SCOPED_TRACE(model.name);
    std::vector<Vec3> uniform;
    {
      BisectionForest all(model.mesh);
      for (int level = 0; level <= finest; ++level)
        all.refine(all.leaves());
      for (int v = 0; v < all.num_vertices(); ++v)
        uniform.push_back(all.position(VertexId(v)));
    }
    int split = 0, merged = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      BisectionForest forest(model.mesh);
      for (int step = 0; step < 8; ++step) {
        split += forest.refine(some(forest, random, 5, finest));
        std::vector<FaceId> away;
        for (const FaceId f : forest.leaves())
          if (step == 4 || random() % 6 != 0) away.push_back(f);
        merged += forest.coarsen(away);
        const Mesh mesh = forest_mesh(forest).mesh;
        expect_conforming(mesh, model.mesh);
        expect_positions_among(mesh, uniform);
        if (testing::Test::HasFailure()) return;
      }
    }
    EXPECT_GT(merged, 0);
    EXPECT_GT(split, merged);
  }
}

/// Up and down again: the control mesh.
TEST(BisectionForest, CoarseningEverythingGivesTheControlMeshBack) {
  const Mesh control = shapes::icosahedron();
  BisectionForest forest(control);
  std::mt19937 random(3);
  for (int k = 0; k < 9; ++k)
    forest.refine(some(forest, random, 4, 20));
  const int made = forest.num_vertices();
  while (forest.coarsen(forest.leaves()) > 0) {
  }
  EXPECT_EQ(forest_mesh(forest).mesh.topology, control.topology);
  EXPECT_EQ(forest.num_vertices(), made);
}

/// A square: four triangles around its centre. One is halved alone, its side being the boundary; a child of
/// it across a spoke asks for the next triangle, which is halved on the boundary, and its child goes along.
TEST(BisectionForest, CountsOnASquare) {
  BisectionForest forest(shapes::grid(1, 1));
  EXPECT_EQ(forest.refine(std::array{FaceId(0)}), 1);
  EXPECT_EQ(forest.leaves().size(), 4U);
  EXPECT_EQ(forest.refine(std::array{forest.leaves()[0]}), 1);
  EXPECT_EQ(forest.leaves().size(), 5U);
  // (s, centre, v0) is halved across centre-v0; beyond lies triangle 3 of the square.
  EXPECT_EQ(forest.refine(std::array{forest.leaves()[0]}), 3);
  EXPECT_EQ(forest.leaves().size(), 8U);
  const Mesh mesh = forest_mesh(forest).mesh;
  EXPECT_EQ(mesh.topology.num_vertices(), 4 + 1 + 1 + 2);
  EXPECT_NEAR(measure(mesh).area, 1, 1e-15);
}

/// Angles of a triangle, ascending.
std::array<double, 3> angles_of(const Mesh& mesh, FaceId f) {
  const auto v = mesh.topology.face(f);
  std::array<double, 3> angles;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = mesh.points[v[(i + 1) % 3]] - mesh.points[v[i]];
    const Vec3 b = mesh.points[v[(i + 2) % 3]] - mesh.points[v[i]];
    angles[i] = std::atan2(a.cross(b).norm(), a.dot(b));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Newest vertex bisection makes at most four kinds of triangles of one, whatever the number of levels
/// [mitchell_1991]: the smallest angle stays.
TEST(BisectionForest, MakesFourShapesOfATriangle) {
  for (const Model& model : polygon_models()) {
    SCOPED_TRACE(model.name);
    BisectionForest forest(model.mesh);
    forest.refine(forest.leaves());
    const std::size_t num_first = forest.leaves().size();
    std::mt19937 random(11);
    for (int round = 0; round < 12; ++round)
      forest.refine(some(forest, random, 3, 12));
    const ForestMesh made = forest_mesh(forest);
    std::map<std::pair<int, std::int64_t>, std::vector<std::array<double, 3>>> shapes;
    for (int f = 0; f < made.mesh.topology.num_faces(); ++f) {
      const FaceAncestry a = forest.ancestry(made.leaves[static_cast<std::size_t>(f)]);
      const std::array<double, 3> angles = angles_of(made.mesh, FaceId(f));
      auto& known = shapes[{a.root.value, a.path >> (a.level - 1)}];
      const auto same = [&](const std::array<double, 3>& other) {
        return std::abs(other[0] - angles[0]) + std::abs(other[2] - angles[2]) < 1e-9;
      };
      if (std::none_of(known.begin(), known.end(), same)) known.push_back(angles);
    }
    EXPECT_EQ(shapes.size(), num_first);
    for (const auto& [triangle, kinds] : shapes)
      EXPECT_LE(kinds.size(), 4U);
  }
}

/// One split asks for 2 k triangles and a control face at most, and over many steps towards a point the
/// splits that were not asked for are a bounded share [binev_dahmen_devore_2004]: here each step asks for one
/// leaf.
TEST(BisectionForest, OneSplitCausesFewOthers) {
  BisectionForest forest(shapes::torus(8, 6));
  int split = 0;
  constexpr int steps = 300;
  std::mt19937 random(5);
  for (int step = 0; step < steps; ++step) {
    std::vector<FaceId> leaves = forest.leaves();
    // One of the deepest half of the leaves, so that levels differ as they can.
    std::stable_sort(leaves.begin(), leaves.end(), [&](FaceId a, FaceId b) {
      return forest.ancestry(a).level > forest.ancestry(b).level;
    });
    const FaceId leaf = leaves[random() % (step % 2 == 0 ? 3 : leaves.size())];
    const int level = forest.ancestry(leaf).level;
    if (level >= 30) continue;
    const int count = forest.refine(std::array{leaf});
    EXPECT_LE(count, 2 * level + 1);
    split += count;
  }
  EXPECT_LT(split, 5 * steps);
}

TEST(BisectionForest, AncestryIsSideAndBits) {
  BisectionForest forest(shapes::icosahedron());
  for (int k = 0; k < 4; ++k)
    forest.refine(forest.leaves());
  const std::vector<FaceId> leaves = forest.leaves();
  ASSERT_EQ(leaves.size(), 20U * 3 * 8);
  for (std::size_t i = 0; i < leaves.size(); ++i)
    EXPECT_EQ(forest.ancestry(leaves[i]),
              (FaceAncestry{FaceId(i / 24), 4, static_cast<std::int64_t>(i % 24)}));
}

TEST(BisectionForest, HandsDownTagsAndGroups) {
  Mesh control = shapes::grid(3, 3);
  control.groups.push_back({"middle", {FaceId(4)}});
  const auto v = control.topology.face(FaceId(4));
  control.tags.creases = {{v[0], v[1], infinite_sharpness}, {v[1], v[2], 1.0F}};
  control.tags.corners = {{v[0], infinite_sharpness}};
  BisectionForest forest(control);
  for (int k = 0; k < 3; ++k) {
    std::vector<FaceId> in_middle;
    for (const FaceId f : forest.leaves())
      if (forest.ancestry(f).root == FaceId(4)) in_middle.push_back(f);
    forest.refine(in_middle);
  }
  const Mesh mesh = forest_mesh(forest).mesh;
  double sharp = 0;
  for (const CreaseTag& crease : mesh.tags.creases)
    sharp += (mesh.points[crease.a] - mesh.points[crease.b]).norm();
  EXPECT_NEAR(sharp, 1, 1e-14);  // the other has lost its sharpness
  ASSERT_EQ(mesh.tags.corners.size(), 1U);
  ASSERT_EQ(mesh.groups.size(), 1U);
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    EXPECT_EQ(
        std::binary_search(mesh.groups[0].faces.begin(), mesh.groups[0].faces.end(), FaceId(f)),
        mesh.face_fields[0].values[static_cast<std::size_t>(f)] == 4);
}

TEST(BisectionForest, RefusesCreasesOfChaikin) {
  Mesh control = shapes::grid(2, 2);
  control.tags.creases.push_back({VertexId(1), VertexId(4), 2});
  (void)BisectionForest(control);
  control.tags.crease_method = CreaseMethod::chaikin;
  EXPECT_THROW((void)BisectionForest(control), InputError);
}

TEST(BisectionForest, RefusesTheDeepestLevelWhole) {
  BisectionForest forest(shapes::polygon(3));
  while (forest.ancestry(forest.leaves()[0]).level < BisectionForest::max_level)
    forest.refine(std::array{forest.leaves()[0]});
  const std::vector<FaceId> before = forest.leaves();
  EXPECT_THROW(forest.refine(before), InputError);
  EXPECT_EQ(forest.leaves(), before);
}

}  // namespace
}  // namespace limes
