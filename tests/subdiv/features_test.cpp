#include "limes/subdiv/features.h"

#include <gtest/gtest.h>

#include "limes/core/error.h"

namespace limes {
namespace {

/// n triangles around vertex 0, closed, and a square that shares no vertex with them.
Topology fan_and_square(int n) {
  std::vector<VertexId> corners;
  std::vector<int> offsets{0};
  const auto face = [&](std::initializer_list<int> vertices) {
    for (const int v : vertices)
      corners.emplace_back(v);
    offsets.push_back(static_cast<int>(corners.size()));
  };
  for (int i = 0; i < n; ++i)
    face({0, 1 + i, 1 + (i + 1) % n});
  face({n + 1, n + 2, n + 3, n + 4});
  return Topology(n + 5, std::move(offsets), std::move(corners));
}

// Half of them from the hub, half towards it. A search around the hub alone would take 5e9 steps.
TEST(ResolveTags, FindsTheSpokesOfALargeFan) {
  constexpr int n = 100'000;
  const Topology topology = fan_and_square(n);
  const Adjacency adjacency(topology);
  Tags tags;
  for (int i = 0; i < n; ++i) {
    const VertexId hub(0), rim(1 + i);
    tags.creases.push_back(i % 2 == 0 ? CreaseTag{hub, rim, float(i + 1)}
                                      : CreaseTag{rim, hub, float(i + 1)});
  }
  const Features features = resolve_tags(adjacency, tags, BoundaryRule::edges);
  ASSERT_EQ(features.edges.size(), std::size_t{n});
  for (const SharpEdge& e : features.edges) {
    const int a = adjacency.from(e.halfedge).value, b = adjacency.to(e.halfedge).value;
    ASSERT_EQ(std::min(a, b), 0);
    ASSERT_EQ(float(std::max(a, b)), e.sharpness);
  }
}

TEST(ResolveTags, LeavesBoundaryEdgesAndNamesWhatIsNoEdge) {
  const int n = 5;
  const Topology topology = fan_and_square(n);
  const Adjacency adjacency(topology);
  const auto resolve = [&](int a, int b) {
    Tags tags;
    tags.creases = {{VertexId(a), VertexId(b), 1.0F}};
    return resolve_tags(adjacency, tags, BoundaryRule::edges).edges.size();
  };
  EXPECT_EQ(resolve(3, 0), 1U);
  EXPECT_EQ(resolve(1, 2), 0U);  // on the boundary
  EXPECT_EQ(resolve(n, 1), 0U);
  EXPECT_EQ(resolve(n + 1, n + 4), 0U);
  EXPECT_EQ(resolve(n + 4, n + 1), 0U);
  for (const auto& [a, b] :
       {std::pair(1, 3), std::pair(n + 1, n + 3), std::pair(0, n + 1), std::pair(2, 2)})
    EXPECT_THROW((void)resolve(a, b), InputError) << a << ' ' << b;
}

}  // namespace
}  // namespace limes
