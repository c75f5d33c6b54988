#include <gtest/gtest.h>

#include <algorithm>

#include "limes/limit/forest_limits.h"
#include "limes/limit/limit_surface.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

/// Vertices of Catmull-Clark forests lie where the limit surface of the control mesh is: at the corners
/// of a leaf, whose place in its control face follows from its path.
void expect_on_limit(const Mesh& control, const std::vector<FaceAncestry>& marks,
                     const RefineOptions& options = {}) {
  const Scheme& scheme = find_scheme("catmull-clark");
  Forest forest(control, scheme, options, SplitUnit::families, forest_limits(scheme));
  forest.refine(forest.leaves());
  for (const FaceAncestry& mark : marks) {
    const std::vector<FaceId> leaves = forest.leaves();
    const auto leaf = std::find_if(leaves.begin(), leaves.end(),
                                   [&](FaceId f) { return forest.ancestry(f) == mark; });
    ASSERT_NE(leaf, leaves.end());
    forest.refine(std::vector{*leaf});
  }
  (void)forest_mesh(forest, Closure::conforming);
  const Adjacency adjacency(control.topology);
  const LimitBasis basis(control.topology, control_features(adjacency, control, scheme, options),
                         scheme);
  const LimitSurface surface(basis, control.points.span());
  // Corners of child i of the unit square with corners p: (p_i, side i, middle, side i - 1).
  for (const FaceId f : forest.leaves()) {
    const FaceAncestry a = forest.ancestry(f);
    std::array<Vec2, 4> square{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    for (int level = a.level - 1; level >= 0; --level) {
      const auto i = static_cast<std::size_t>((a.path >> (2 * level)) & 3);
      const Vec2 middle = 0.5 * (square[0] + square[2]);
      square = {square[i], 0.5 * (square[i] + square[(i + 1) % 4]), middle,
                0.5 * (square[(i + 3) % 4] + square[i])};
    }
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_LE(
          (forest.nodes().position(forest.corners(f)[i]) - surface.position(a.root, 0, square[i]))
              .norm(),
          1e-13)
          << "root " << a.root.value << " level " << a.level << " path " << a.path;
  }
}

TEST(ForestLimits, LieOnTheLimitSurface) {
  expect_on_limit(shapes::cube(), {{FaceId(0), 1, 0}, {FaceId(0), 2, 0}});
  expect_on_limit(shapes::grid(3, 2), {{FaceId(0), 1, 0}, {FaceId(0), 2, 1}, {FaceId(4), 1, 2}});
  const std::vector<FaceAncestry> beside_valence_5{{FaceId(1), 1, 0}, {FaceId(1), 2, 0}};
  expect_on_limit(shapes::disk(5, 1), beside_valence_5);
  expect_on_limit(shapes::disk(5, 1), beside_valence_5,
                  {.weights = ExtraordinaryWeights::quarters});
}

}  // namespace
}  // namespace limes
