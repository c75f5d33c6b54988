#include <gtest/gtest.h>

#include <array>
#include <set>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/forest_checks.h"
#include "subdiv/interpolatory.h"

namespace limes {
namespace {

const Scheme& kobbelt() {
  return find_scheme("kobbelt");
}

/// Counts and positions of another program, tests/data/interpolatory/README.md.
TEST(Forest, AgreesWithAnotherProgramOnANoisyCube) {
  const nlohmann::json golden = read_interpolatory("adaptive_cube_noisy");
  const Mesh control = net_of(golden);
  Forest forest(control, kobbelt(), {});
  forest.refine(forest.leaves());
  const std::array<FaceAncestry, 2> marks{{{FaceId(0), 1, 0}, {FaceId(0), 2, 0}}};
  for (std::size_t step = 0; step < marks.size(); ++step) {
    SCOPED_TRACE(step);
    const auto& expected = golden.at("steps")[step];
    forest.refine(std::array{leaf_at(forest, marks[step])});
    const Mesh mesh = forest_mesh(forest, Closure::conforming).mesh;
    EXPECT_EQ(static_cast<int>(forest.leaves().size()), expected.at("leaves").get<int>());
    EXPECT_EQ(mesh.topology.num_faces(), expected.at("faces").get<int>());
    EXPECT_EQ(mesh.topology.num_vertices(), expected.at("vertices").get<int>());
    EXPECT_EQ(mesh.topology.uniform_face_size(), 4);

    std::vector<Vec3> ours = mesh.points.vector(), theirs;
    for (const auto& x : expected.at("used_positions"))
      theirs.emplace_back(x[0].get<double>(), x[1].get<double>(), x[2].get<double>());
    ASSERT_EQ(ours.size(), theirs.size());
    // Their nearest neighbour, since rounding may change the order of a sort.
    for (const Vec3& x : ours) {
      double nearest = 1;
      for (const Vec3& y : theirs)
        nearest = std::min(nearest, (x - y).cwiseAbs().maxCoeff());
      EXPECT_LE(nearest, 1e-13 * size_of(control));
    }
  }
}

Mesh creased_cube() {
  Mesh mesh = shapes::cube();
  for (int i = 0; i < 4; ++i) {
    const auto face = mesh.topology.face(FaceId(0));
    mesh.tags.creases.push_back({face[static_cast<std::size_t>(i)],
                                 face[static_cast<std::size_t>((i + 1) % 4)], infinite_sharpness});
  }
  return mesh;
}

std::vector<Model> models() {
  return {{"cube", shaken(shapes::cube())},
          {"creased cube", shaken(creased_cube())},
          {"torus", shaken(shapes::torus(5, 4))},
          {"grid", shaken(shapes::grid(3, 2))},
          {"strip", shaken(shapes::grid(4, 1))},
          {"hole", shaken(shapes::grid_with_hole(3))},
          {"disk of valence 5", shaken(shapes::disk(5, 2))},
          {"star of valence 3", shaken(shapes::star(3, 1))},
          {"half disk", shaken(shapes::half_disk(3, 1))},
          {"cylinder", shaken(shapes::cylinder(5, 2))}};
}

/// Twenty sequences of five steps on each of ten models.
void expect_properties_kept(const Scheme& scheme) {
  constexpr int finest = 3;
  for (const Model& model : models()) {
    SCOPED_TRACE(model.name);
    const std::vector<Mesh> uniform = uniform_levels(model.mesh, scheme, finest + 1);
    int split = 0, merged = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const SplitUnit unit = seed % 4 == 3 ? SplitUnit::faces : SplitUnit::families;
      Forest forest(model.mesh, scheme, {}, unit);
      for (int step = 0; step < 5; ++step) {
        split += forest.refine(some_leaves(forest, random, 6, finest));
        const unsigned one_in = step == 2 ? 1 : 8;  // 1: all leaves are marked
        merged += forest.coarsen(all_but_some(forest, random, one_in));
        expect_balanced(forest);
        const Closure closure = unit == SplitUnit::faces ? Closure::triangles : Closure::conforming;
        const Mesh mesh = forest_mesh(forest, closure).mesh;
        if (closure == Closure::conforming) {
          ASSERT_EQ(mesh.topology.uniform_face_size(), 4);
        }
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

TEST(Forest, RandomSequencesKeepEveryProperty) {
  expect_properties_kept(kobbelt());
}

TEST(Forest, RandomSequencesOfTheLinearSchemeKeepEveryProperty) {
  expect_properties_kept(find_scheme("linear"));
}

TEST(Forest, CoarseningEverythingGivesTheControlMeshBack) {
  const Mesh control = shapes::torus(5, 4);
  Forest forest(control, kobbelt(), {});
  forest.refine(std::array{FaceId(3)});
  forest.refine(std::array{leaf_at(forest, {FaceId(3), 1, 2})});
  while (forest.coarsen(forest.leaves()) > 0) {
  }
  EXPECT_EQ(forest_mesh(forest, Closure::conforming).mesh.topology, control.topology);
}

/// Uniform marks make the mesh of uniform refinement, its faces in the same order.
TEST(Forest, AllLeavesIsUniformRefinement) {
  const Mesh control = shaken(shapes::disk(5, 2));
  for (const char* name : {"kobbelt", "linear"}) {
    const Scheme& scheme = find_scheme(name);
    Forest forest(control, scheme, {});
    for (int level = 1; level <= 2; ++level)
      forest.refine(forest.leaves());
    expect_uniform_positions(forest, uniform_levels(control, scheme, 2));
    EXPECT_EQ(static_cast<int>(forest.leaves().size()), 16 * control.topology.num_faces());
  }
}

TEST(Forest, HangingVerticesAreMiddles) {
  Forest forest(shapes::grid(3, 3), find_scheme("linear"), {}, SplitUnit::faces);
  forest.refine(std::array{FaceId(4)});
  const ForestMesh made = forest_mesh(forest, Closure::hanging);
  EXPECT_EQ(made.mesh.topology.num_faces(), 12);
  ASSERT_EQ(made.hanging.size(), 4U);
  const auto& x = made.mesh.points;
  for (const HangingVertex& h : made.hanging)
    EXPECT_EQ(x[h.vertex], 0.5 * (x[h.ends[0]] + x[h.ends[1]]));
}

/// The face fields of a mesh whose faces are the leaves say which face of uniform refinement each is.
// Where vertices hang, each side of a crease has edges that the other does not; all are sharp.
TEST(Forest, CreasesAreWholeOnBothSidesOfHangingVertices) {
  Mesh control = shapes::grid(4, 4);
  for (int i = 0; i < 4; ++i)
    control.tags.creases.push_back({VertexId(5 * i + 2), VertexId(5 * i + 7), infinite_sharpness});
  Forest forest(control, find_scheme("linear"), {}, SplitUnit::faces);
  forest.refine(std::vector<FaceId>{FaceId(5), FaceId(6), FaceId(10)});
  const ForestMesh made = forest_mesh(forest, Closure::hanging);
  const double x = control.points[VertexId(2)].x();
  std::set<std::pair<VertexId, VertexId>> tagged, expected;
  for (const CreaseTag& c : made.mesh.tags.creases)
    EXPECT_TRUE(tagged.insert(std::minmax(c.a, c.b)).second);
  for (int f = 0; f < made.mesh.topology.num_faces(); ++f)
    for (int i = 0; i < 4; ++i) {
      const VertexId a = made.mesh.topology.face(FaceId(f))[static_cast<std::size_t>(i)],
                     b = made.mesh.topology.face(FaceId(f))[static_cast<std::size_t>((i + 1) % 4)];
      if (made.mesh.points[a].x() == x && made.mesh.points[b].x() == x)
        expected.insert(std::minmax(a, b));
    }
  EXPECT_EQ(tagged, expected);
  EXPECT_EQ(expected.size(), 2U + 2U + 3U);  // whole; split on both sides; on one
}

TEST(Forest, FaceFieldsNameTheFaceOfUniformRefinement) {
  const Mesh control = shaken(shapes::disk(5, 2));
  const std::vector<Mesh> uniform = uniform_levels(control, kobbelt(), 3);
  Forest forest(control, kobbelt(), {}, SplitUnit::faces);
  forest.refine(std::array{FaceId(3)});
  forest.refine(std::array{leaf_at(forest, {FaceId(3), 1, 2})});
  forest.refine(std::array{leaf_at(forest, {FaceId(3), 2, 9})});
  const Mesh mesh = forest_mesh(forest, Closure::hanging).mesh;
  ASSERT_EQ(mesh.face_fields.size(), 3U);
  const auto value = [&](std::size_t field, int f) {
    return mesh.face_fields[field].values[static_cast<std::size_t>(f)];
  };
  int finest = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const int level = static_cast<int>(value(1, f));
    const Mesh& fine = uniform[static_cast<std::size_t>(level)];
    const FaceId number((value(0, f) << (2 * level)) + value(2, f));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(mesh.points[mesh.topology.face(FaceId(f))[i]],
                fine.points[fine.topology.face(number)[i]]);
    finest += level == 3 ? 1 : 0;
  }
  EXPECT_EQ(finest, 4);
}

/// Groups and holes are the faces below theirs, whatever closes the mesh; a crease stays whole.
TEST(Forest, HandsDownNamesThroughEveryClosure) {
  Mesh control = shapes::grid(3, 3);
  control.groups.push_back({"middle", {FaceId(4)}});
  control.tags.holes = {FaceId(5)};
  const auto middle = control.topology.face(FaceId(4));
  control.tags.creases.push_back({middle[0], middle[1], infinite_sharpness});
  const double length = (control.points[middle[0]] - control.points[middle[1]]).norm();
  for (const Closure closure : {Closure::conforming, Closure::triangles, Closure::hanging}) {
    const SplitUnit unit = closure == Closure::conforming ? SplitUnit::families : SplitUnit::faces;
    Forest forest(control, find_scheme("linear"), {}, unit);
    forest.refine(std::array{FaceId(4)});
    forest.refine(std::array{leaf_at(forest, {FaceId(4), 1, 0})});
    const Mesh mesh = forest_mesh(forest, closure).mesh;
    ASSERT_EQ(mesh.face_fields.size(), 3U);
    std::vector<FaceId> in_middle, in_hole;
    for (int f = 0; f < mesh.topology.num_faces(); ++f) {
      const std::int64_t root = mesh.face_fields[0].values[static_cast<std::size_t>(f)];
      if (root == 4) in_middle.emplace_back(f);
      if (root == 5) in_hole.emplace_back(f);
    }
    ASSERT_EQ(mesh.groups.size(), 1U);
    EXPECT_EQ(mesh.groups[0].faces, in_middle);
    EXPECT_EQ(mesh.tags.holes, in_hole);
    EXPECT_GT(in_middle.size(), 4U);
    double sharp = 0;
    for (const CreaseTag& crease : mesh.tags.creases)
      sharp += (mesh.points[crease.a] - mesh.points[crease.b]).norm();
    if (closure != Closure::hanging) {
      EXPECT_NEAR(sharp, length, 1e-14);
    }
  }
}

TEST(Forest, NamesWhatItCannotTake) {
  EXPECT_THROW(
      Forest(shapes::grid(2, 2), find_scheme("catmull-clark"), {.boundary = BoundaryRule::none}),
      InputError);
  EXPECT_THROW(Forest(shapes::tetrahedron(), find_scheme("catmull-clark"), {}), InputError);
  EXPECT_THROW(Forest(shapes::polygon(5), find_scheme("linear"), {}), InputError);
  EXPECT_THROW(Forest(shapes::cube(), find_scheme("loop"), {}), InputError);
  EXPECT_THROW(Forest(shapes::icosahedron(), find_scheme("sqrt3"), {}), UsageError);
}

}  // namespace
}  // namespace limes
