#include "limes/adapt/loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "convergence/plane_meshes.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

Forest unit_square() {
  return {
      testing::grid(2, 2, [](const Vec2& p) { return p; }), find_scheme("linear"), {.levels = 0}};
}

/// What interpolation of a function with second derivatives near the origin alone would leave.
StepSolution bump(const ForestMesh& forest) {
  const Mesh& mesh = forest.mesh;
  StepSolution out{mesh.topology.num_vertices(), mesh.topology.num_faces(), 1.0, {}};
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto corners = mesh.topology.face(FaceId(f));
    Vec3 centre = Vec3::Zero();
    for (const VertexId v : corners)
      centre += 0.25 * mesh.points[v];
    const double size = (mesh.points[corners[2]] - mesh.points[corners[0]]).norm();
    out.squares.push_back(std::pow(size, 4) * std::exp(-20 * centre.norm()));
  }
  return out;
}

TEST(AdaptiveLoop, FiguresOfAStepAreThoseOfItsSquares) {
  Forest forest = unit_square();
  const AdaptHistory history =
      solve_adaptively(forest, {.max_steps = 1, .reference_energy = 20.5}, [](const ForestMesh&) {
        return StepSolution{7, 3, 12.5, {1, 3, 0, 7}};
      });
  ASSERT_EQ(history.steps.size(), 1U);
  EXPECT_EQ(history.end, "max_steps");
  const AdaptStep& step = history.steps[0];
  EXPECT_EQ(step.dofs, 7);
  EXPECT_EQ(step.elements, 3);
  EXPECT_EQ(step.strain_energy, 12.5);
  EXPECT_DOUBLE_EQ(step.error_estimate, std::sqrt(11.0));
  EXPECT_DOUBLE_EQ(step.relative_error, std::sqrt(11.0 / 36));  // of 2 * 12.5 + 11
  EXPECT_DOUBLE_EQ(step.true_error.value(), 4);                 // sqrt(2 (20.5 - 12.5))
  EXPECT_DOUBLE_EQ(step.effectivity.value(), std::sqrt(11.0) / 4);
}

TEST(AdaptiveLoop, EndsAtEachTarget) {
  const auto end = [](const AdaptTargets& targets) {
    Forest forest = unit_square();
    return solve_adaptively(forest, targets, bump);
  };
  const AdaptHistory error = end({.error = 1e-3});
  EXPECT_EQ(error.end, "target_error");
  EXPECT_LE(error.steps.back().relative_error, 1e-3);
  for (std::size_t i = 0; i + 1 < error.steps.size(); ++i)
    EXPECT_GT(error.steps[i].relative_error, 1e-3);

  const AdaptHistory steps = end({.max_steps = 4});
  EXPECT_EQ(steps.end, "max_steps");
  EXPECT_EQ(steps.steps.size(), 4U);

  const AdaptHistory dofs = end({.max_dofs = 300, .dofs_per_vertex = 2, .max_steps = 100});
  EXPECT_EQ(dofs.end, "max_dofs");
  EXPECT_LE(dofs.steps.back().dofs, 150);  // vertices
  EXPECT_GT(dofs.steps.back().dofs, 75);

  EXPECT_EQ(end({.max_seconds = 1e-9}).steps.size(), 1U);
  Forest forest = unit_square();
  const AdaptHistory none = solve_adaptively(forest, {}, [](const ForestMesh& mesh) {
    return StepSolution{1, 1, 1, std::vector<double>(mesh.leaves.size(), 0.0)};
  });
  EXPECT_EQ(none.end, "no error left");
  EXPECT_EQ(none.steps.size(), 1U);
}

// All of the error stays in the leaf at the origin.
TEST(AdaptiveLoop, EndsAtTheDeepestLevel) {
  for (const int deepest : {Forest::max_level, 5}) {
    Forest forest = unit_square();
    const AdaptHistory history = solve_adaptively(
        forest, {.deepest_level = deepest, .max_steps = 100}, [](const ForestMesh& mesh) {
          StepSolution out{1, 1, 1, std::vector<double>(mesh.leaves.size(), 0.0)};
          out.squares[0] = 1;
          return out;
        });
    EXPECT_EQ(history.end, "max_level");
    EXPECT_EQ(static_cast<int>(history.steps.size()), 1 + deepest);
    EXPECT_EQ(forest.ancestry(forest.leaves().front()).level, deepest);
  }
}

TEST(AdaptiveLoop, TheFirstMeshIsSolvedWhateverItsSize) {
  Forest forest = unit_square();
  const AdaptHistory history = solve_adaptively(forest, {.max_dofs = 1}, bump);
  EXPECT_EQ(history.end, "max_dofs");
  EXPECT_EQ(history.steps.size(), 1U);
}

TEST(AdaptiveLoop, RefinesWhereTheErrorIs) {
  Forest forest = unit_square();
  (void)solve_adaptively(forest, {.max_dofs = 500}, bump);
  int deepest = 0, shallowest = Forest::max_level;
  for (const FaceId leaf : forest.leaves()) {
    const int level = forest.ancestry(leaf).level;
    for (const VertexId v : forest.corners(leaf)) {
      const Vec3& x = forest.nodes().position(v);
      if (x == Vec3::Zero()) deepest = std::max(deepest, level);
      if (x == Vec3(1, 1, 0)) shallowest = std::min(shallowest, level);
    }
  }
  EXPECT_GE(deepest, shallowest + 3);
}

// A leaf that the closure splits has the sum of its faces' squares: one of two leaves with 3 faces of
// 1 each is marked before the other with 2.
TEST(AdaptiveLoop, SquaresOfALeafsFacesAddUp) {
  Forest forest = unit_square();
  const std::vector<FaceId> one{forest.leaves().front()};
  (void)forest.refine(one);
  const ForestMesh mesh = forest_mesh(forest, Closure::conforming);
  std::vector<int> faces_of_root(4, 0);
  for (const FaceId leaf : mesh.leaves)
    ++faces_of_root[static_cast<std::size_t>(forest.ancestry(leaf).root.value)];
  const auto most = std::max_element(faces_of_root.begin() + 1, faces_of_root.end());
  ASSERT_GT(*most, 1);
  const auto root = static_cast<int>(most - faces_of_root.begin());
  (void)solve_adaptively(
      forest, {.mark = MarkingKind::fraction, .share = 1e-3, .max_steps = 2},
      [&](const ForestMesh& step) {
        StepSolution out{1, 1, 1, {}};
        for (const FaceId leaf : step.leaves) {
          const FaceAncestry a = forest.ancestry(leaf);
          out.squares.push_back(a.root == FaceId(root) ? 1.0 : a.level == 0 ? 0.0 : 1.5);
        }
        return out;
      });
  EXPECT_TRUE(forest.is_split(FaceId(root)));
}

}  // namespace
}  // namespace limes
