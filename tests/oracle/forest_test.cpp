#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "limes/limit/forest_limits.h"
#include "limes/subdiv/forest.h"
#include "limes/subdiv/schemes.h"
#include "oracle/osd.h"
#include "oracle/shapes.h"

// Vertices of locally refined meshes against OpenSubdiv's uniform refinement and its limit masks.

namespace limes::oracle {
namespace {

/// The limits, by OpenSubdiv's masks, of the vertices that level `level` has; none if a mask is inexact.
std::vector<Vec3> limits_of_level(const Mesh& mesh, const Scheme& scheme, BoundaryRule boundary,
                                  int level) {
  const int deepest = level + 3;  // semi-sharp creases are gone
  const auto refiner = make_refiner(mesh, scheme, boundary);
  const auto positions = refine_uniformly(*refiner, mesh, deepest);
  const auto limits = limit_of_last_level(*refiner, positions.back());
  std::vector<Vec3> wanted;
  for (int v = 0; v < refiner->GetLevel(level).GetNumVertices(); ++v) {
    int deep = v;
    for (int k = level; k < deepest; ++k)
      deep = refiner->GetLevel(k).GetVertexChildVertex(deep);
    if (!has_exact_limit(refiner->GetLevel(deepest), deep)) return {};
    wanted.push_back(limits[static_cast<std::size_t>(deep)]);
  }
  return wanted;
}

class OpenSubdivForest : public testing::TestWithParam<Case> {};

/// Random leaves are split up to level 3: every vertex is one of OpenSubdiv's.
TEST_P(OpenSubdivForest, VerticesAreLimitsOfUniformRefinement) {
  const Mesh mesh = read_shape(GetParam().shape);
  const Scheme& scheme = find_scheme("loop");
  if (mesh.topology.num_faces() > 200) GTEST_SKIP() << "too large to search";
  const std::vector<Vec3> theirs = limits_of_level(mesh, scheme, GetParam().boundary, 3);
  if (theirs.empty()) GTEST_SKIP() << "OpenSubdiv has no exact limits at some vertex";
  Forest forest(mesh, scheme, {.boundary = GetParam().boundary}, SplitUnit::faces,
                forest_limits(scheme));
  std::mt19937 random(1987);
  for (int round = 0; round < 3; ++round) {
    std::vector<FaceId> marked;
    for (const FaceId f : forest.leaves())
      if (forest.ancestry(f).level < 3 && random() % 4 == 0) marked.push_back(f);
    forest.refine(marked);
  }
  ASSERT_GT(forest.leaves().size(), static_cast<std::size_t>(mesh.topology.num_faces()));
  std::vector<bool> seen(static_cast<std::size_t>(forest.nodes().size()), false);
  for (const FaceId f : forest.leaves())
    for (const VertexId v : forest.corners(f)) {
      if (seen[static_cast<std::size_t>(v.value)]) continue;
      seen[static_cast<std::size_t>(v.value)] = true;
      const Vec3& x = forest.nodes().position(v);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec3& y : theirs)
        nearest = std::min(nearest, (x - y).norm());
      ASSERT_LE(nearest, 1e-13 * size_of(mesh)) << x.transpose();
    }
}

/// Rule none drops faces, which a forest does not do.
std::vector<Case> forest_cases() {
  std::vector<Case> cases = manifold_cases("loop");
  cases.erase(std::remove_if(cases.begin(), cases.end(),
                             [](const Case& c) { return c.boundary == BoundaryRule::none; }),
              cases.end());
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Loop, OpenSubdivForest, testing::ValuesIn(forest_cases()),
                         [](const auto& c) { return name_of(c.param); });

}  // namespace
}  // namespace limes::oracle
