#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/forest_seams.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/forest_checks.h"

// Forests on meshes of triangles: red-green refinement.

namespace limes {
namespace {

/// Quads cut along their first diagonal.
Mesh cut(const Mesh& quads) {
  Mesh mesh;
  mesh.points = quads.points;
  std::vector<VertexId> corners;
  for (int f = 0; f < quads.topology.num_faces(); ++f) {
    const auto v = quads.topology.face(FaceId(f));
    corners.insert(corners.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
  }
  mesh.topology = Topology(quads.topology.num_vertices(), 3, std::move(corners));
  return mesh;
}

/// Vertices 0 to 5 at +-x, +-y, +-z; face 0 is that of +x, +y, +z.
Mesh octahedron() {
  Mesh mesh;
  for (const Vec3& x : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1),
                        Vec3(0, 0, -1)})
    mesh.points.push_back(x);
  std::vector<VertexId> corners;
  for (const auto& f : {std::array{0, 2, 4},
                        {2, 1, 4},
                        {1, 3, 4},
                        {3, 0, 4},
                        {2, 0, 5},
                        {1, 2, 5},
                        {3, 1, 5},
                        {0, 3, 5}})
    for (const int v : f)
      corners.emplace_back(v);
  mesh.topology = Topology(6, 3, std::move(corners));
  return mesh;
}

Mesh creased_icosahedron() {
  Mesh mesh = shapes::icosahedron();
  const auto v = mesh.topology.face(FaceId(0));
  mesh.tags.creases = {{v[0], v[1], infinite_sharpness}, {v[1], v[2], 1.5F}};
  mesh.tags.corners = {{v[0], infinite_sharpness}};
  return mesh;
}

std::vector<Model> triangle_models() {
  return {{"tetrahedron", shaken(shapes::tetrahedron())},
          {"octahedron", shaken(octahedron())},
          {"icosahedron", shaken(shapes::icosahedron())},
          {"creased icosahedron", shaken(creased_icosahedron())},
          {"torus", shaken(cut(shapes::torus(5, 4)))},
          {"grid", shaken(cut(shapes::grid(3, 2)))},
          {"strip", shaken(cut(shapes::grid(4, 1)))},
          {"hole", shaken(cut(shapes::grid_with_hole(3)))},
          {"star of valence 7", shaken(shapes::triangle_star(7, 2))},
          {"cylinder", shaken(cut(shapes::cylinder(5, 2)))}};
}

int num_edges(const Mesh& mesh) {
  return Adjacency(mesh.topology).num_edges();
}

/// One face of an octahedron is split: the others at its corners stay, since they are on level 0. Three
/// neighbours have one split side and become two triangles: 4 + 3 * 2 + 4 = 14; three new vertices.
TEST(TriangleForest, CountsOnAnOctahedron) {
  Forest forest(octahedron(), find_scheme("linear"), {});
  EXPECT_EQ(forest.refine(std::array{FaceId(0)}), 1);
  EXPECT_EQ(forest.leaves().size(), 11U);
  const Mesh once = forest_mesh(forest, Closure::conforming).mesh;
  EXPECT_EQ(once.topology.num_faces(), 14);
  EXPECT_EQ(once.topology.num_vertices(), 9);
  EXPECT_EQ(num_edges(once), 21);

  // The child at vertex 0 needs the three other faces there.
  EXPECT_EQ(forest.refine(std::array{leaf_at(forest, {FaceId(0), 1, 0})}), 4);
  EXPECT_EQ(forest.leaves().size(), 4U + 15U + 4U);
  const Mesh twice = forest_mesh(forest, Closure::conforming).mesh;
  // The four faces around vertex 1 share a side each with a split one: 8 triangles. Of the 15 leaves of
  // level 1 three lie beside the split child, its sibling in the middle and two across its other sides.
  EXPECT_EQ(twice.topology.num_faces(), 8 + 18 + 4);
  // 6, the middles of the 8 sides of the four split faces, and those of the split child.
  EXPECT_EQ(twice.topology.num_vertices(), 6 + 8 + 3);
  EXPECT_EQ(measure(twice).euler, 2);
  EXPECT_NEAR(measure(twice).area, 4 * std::numbers::sqrt3, 1e-13);
}

/// The middle child needs the three faces across the sides, and no others.
TEST(TriangleForest, TheMiddleNeedsTheFacesAcrossTheSides) {
  Forest forest(octahedron(), find_scheme("linear"), {});
  forest.refine(std::array{FaceId(0)});
  EXPECT_EQ(forest.refine(std::array{leaf_at(forest, {FaceId(0), 1, 3})}), 4);
  // Three faces share two sides each with split faces, the one opposite none: 3 * 3 + 1. Level 1: 15
  // leaves, of which the three around the middle have a split side: 18.
  const Mesh mesh = forest_mesh(forest, Closure::conforming).mesh;
  EXPECT_EQ(mesh.topology.num_faces(), 10 + 18 + 4);
  EXPECT_EQ(measure(mesh).euler, 2);
}

/// Three split sides make four triangles, as the forest would.
TEST(TriangleForest, AFaceBetweenThreeSplitFacesBecomesRed) {
  const Mesh control = octahedron();
  Forest forest(control, find_scheme("linear"), {});
  forest.refine(std::array{FaceId(1), FaceId(3), FaceId(4)});
  const ForestMesh made = forest_mesh(forest, Closure::conforming);
  EXPECT_EQ(std::count(made.leaves.begin(), made.leaves.end(), FaceId(0)), 4);
  for (const FaceId f : {FaceId(2), FaceId(5), FaceId(7)})
    EXPECT_EQ(std::count(made.leaves.begin(), made.leaves.end(), f), 3);
  EXPECT_EQ(std::count(made.leaves.begin(), made.leaves.end(), FaceId(6)), 1);
  EXPECT_EQ(measure(made.mesh).euler, 2);
}

void expect_triangle_properties_kept(const Scheme& scheme) {
  constexpr int finest = 3;
  for (const Model& model : triangle_models()) {
    if (!scheme.creases && !model.mesh.tags.creases.empty()) continue;
    SCOPED_TRACE(model.name);
    const std::vector<Mesh> uniform =
        uniform_levels(model.mesh, forest_scheme(scheme, model.mesh.topology), finest + 1);
    int split = 0, merged = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      Forest forest(model.mesh, scheme, {});
      for (int step = 0; step < 5; ++step) {
        split += forest.refine(some_leaves(forest, random, 6, finest));
        merged += forest.coarsen(all_but_some(forest, random, step == 2 ? 1 : 8));
        expect_balanced(forest);
        const Mesh mesh = forest_mesh(forest, Closure::conforming).mesh;
        ASSERT_EQ(mesh.topology.uniform_face_size(), 3);
        expect_conforming(mesh, model.mesh);
        expect_uniform_positions(forest, uniform);
        expect_positions_among(mesh, uniform.back().points.vector());
        if (testing::Test::HasFailure()) return;
      }
    }
    EXPECT_GT(merged, 0);
    EXPECT_GT(split, merged);
  }
}

TEST(TriangleForest, RandomSequencesOfButterflyKeepEveryProperty) {
  expect_triangle_properties_kept(find_scheme("butterfly"));
}

TEST(TriangleForest, RandomSequencesOfTheLinearSchemeKeepEveryProperty) {
  expect_triangle_properties_kept(find_scheme("linear"));
}

TEST(TriangleForest, CoarseningEverythingGivesTheControlMeshBack) {
  const Mesh control = cut(shapes::torus(5, 4));
  Forest forest(control, find_scheme("butterfly"), {});
  forest.refine(std::array{FaceId(3)});
  forest.refine(std::array{leaf_at(forest, {FaceId(3), 1, 3})});
  while (forest.coarsen(forest.leaves()) > 0) {
  }
  EXPECT_EQ(forest_mesh(forest, Closure::conforming).mesh.topology, control.topology);
}

/// Corners of linear refinement are dyadic points of the control face, without rounding here.
TEST(TriangleForest, LinearVerticesAreDyadicPoints) {
  Forest forest(octahedron(), find_scheme("linear"), {});
  for (int k = 0; k < 6; ++k)
    forest.refine(std::array{forest.leaves()[static_cast<std::size_t>(k)]});
  for (const FaceId f : forest.leaves()) {
    const double scale = std::ldexp(1.0, forest.ancestry(f).level);
    for (const VertexId v : forest.corners(f)) {
      const Vec3 x = scale * forest.nodes().position(v);
      EXPECT_EQ(x.cwiseAbs().sum(), scale);
      EXPECT_EQ(x, Vec3(x.array().round()));
    }
  }
}

TEST(TriangleForest, HangingVerticesAreMiddles) {
  Forest forest(octahedron(), find_scheme("linear"), {});
  forest.refine(std::array{FaceId(0)});
  const ForestMesh made = forest_mesh(forest, Closure::hanging);
  EXPECT_EQ(made.mesh.topology.num_faces(), 11);
  ASSERT_EQ(made.hanging.size(), 3U);
  const auto& x = made.mesh.points;
  for (const HangingVertex& h : made.hanging)
    EXPECT_EQ(x[h.vertex], 0.5 * (x[h.ends[0]] + x[h.ends[1]]));
}

/// A crease and a group go through the closure whole.
TEST(TriangleForest, HandsDownTagsAndGroups) {
  Mesh control = cut(shapes::grid(3, 3));
  control.groups.push_back({"middle", {FaceId(8), FaceId(9)}});
  const auto v = control.topology.face(FaceId(8));
  control.tags.creases.push_back({v[0], v[2], infinite_sharpness});
  Forest forest(control, find_scheme("linear"), {});
  forest.refine(std::array{FaceId(8)});
  forest.refine(std::array{leaf_at(forest, {FaceId(8), 1, 3})});
  const Mesh mesh = forest_mesh(forest, Closure::conforming).mesh;
  double sharp = 0;
  for (const CreaseTag& crease : mesh.tags.creases)
    sharp += (mesh.points[crease.a] - mesh.points[crease.b]).norm();
  EXPECT_NEAR(sharp, std::numbers::sqrt2, 1e-14);
  ASSERT_EQ(mesh.groups.size(), 1U);
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const std::int64_t root = mesh.face_fields[0].values[static_cast<std::size_t>(f)];
    EXPECT_EQ(
        std::binary_search(mesh.groups[0].faces.begin(), mesh.groups[0].faces.end(), FaceId(f)),
        root == 8 || root == 9);
  }
}

/// Face 4, (y, x, -z) stretched along y: its sides to faces 0 and 7 are split. Of the diagonals, the one
/// from the middle of y-x to -z is shorter, sqrt(3.5), than that from the middle of x-(-z) to y.
TEST(TriangleForest, TakesTheShorterDiagonal) {
  Mesh control = octahedron();
  control.points[VertexId(2)] = Vec3(0, 3, 0);
  Forest forest(control, find_scheme("linear"), {});
  forest.refine(std::array{FaceId(0), FaceId(7)});
  const ForestMesh made = forest_mesh(forest, Closure::conforming);
  EXPECT_EQ(std::count(made.leaves.begin(), made.leaves.end(), FaceId(4)), 3);
  double longest = 0;  // of the sides that are not the control mesh's
  for (int f = 0; f < made.mesh.topology.num_faces(); ++f) {
    if (made.leaves[static_cast<std::size_t>(f)] != FaceId(4)) continue;
    const auto v = made.mesh.topology.face(FaceId(f));
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = v[i], b = v[(i + 1) % 3];
      if (std::max(a, b).value > 5)
        longest = std::max(longest, (made.mesh.points[a] - made.mesh.points[b]).norm());
    }
  }
  EXPECT_NEAR(longest, std::sqrt(3.5), 1e-12);
}

/// Two triangles, tied along one side each, in opposite directions and between different corners.
TEST(TriangleForest, MatchesSeams) {
  Mesh control;
  for (const Vec3& x :
       {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)})
    control.points.push_back(x);
  std::vector<VertexId> corners;
  for (const int v : {0, 1, 2, 5, 4, 3})
    corners.emplace_back(v);
  control.topology = Topology(6, 3, std::move(corners));
  const std::array<TiedEdge, 1> seams{{{{VertexId(0), VertexId(1)}, {VertexId(3), VertexId(4)}}}};
  Forest forest(control, find_scheme("linear"), {});
  forest.refine(std::array{FaceId(0)});
  forest.refine(std::array{leaf_at(forest, {FaceId(0), 1, 1})});
  match_seams(forest, seams);
  const ForestMesh made = forest_mesh(forest, Closure::conforming);
  const std::vector<TiedEdge> tied = tied_edges(forest, made, seams);
  EXPECT_EQ(tied.size(), 3U);  // halves of level 1, and those of one of them
  for (const TiedEdge& e : tied)
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_NE(e.ends[i], e.tied[i]);
      EXPECT_EQ(made.mesh.points[e.ends[i]], made.mesh.points[e.tied[i]]);
    }
}

TEST(TriangleForest, NamesTheFaceThatIsNoTriangle) {
  try {
    const Forest forest(shapes::cube(), find_scheme("loop"), {});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "face 0 has 4 corners; local refinement by loop needs triangles");
  }
}

}  // namespace
}  // namespace limes
