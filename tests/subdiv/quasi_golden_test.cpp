#include <gtest/gtest.h>

#include <algorithm>

#include "limes/subdiv/quasi_four_eight.h"
#include "subdiv/golden48.h"

// Quasi 4-8 subdivision beside results computed elsewhere (tests/data/quasi48).

namespace limes {
namespace {

std::vector<std::vector<int>> edges_of(const Tags& tags) {
  std::vector<std::vector<int>> edges;
  for (const CreaseTag& t : tags.creases)
    edges.push_back({std::min(t.a, t.b).value, std::max(t.a, t.b).value});
  std::sort(edges.begin(), edges.end());
  return edges;
}
std::vector<int> vertices_of(const Tags& tags) {
  std::vector<int> vertices;
  for (const CornerTag& t : tags.corners)
    vertices.push_back(t.vertex.value);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

TEST(QuasiFourEight, AgreesWithGoldenData) {
  const auto files = golden48::read("quasi48_");
  ASSERT_EQ(files.size(), 13U);
  for (const golden48::File& file : files) {
    for (const auto& [steps, expected] : file.after) {
      SCOPED_TRACE(file.name + " after " + std::to_string(steps));
      const auto result = refine_quasi_four_eight(file.input.mesh, {.levels = steps});
      EXPECT_EQ(result.mesh.topology.corners().size(), expected.mesh.topology.corners().size());
      EXPECT_TRUE(
          std::ranges::equal(result.mesh.topology.corners(), expected.mesh.topology.corners()));
      EXPECT_EQ(result.num_unsplit_faces.back(), expected.unsplit_faces);
      EXPECT_EQ(edges_of(result.mesh.tags), expected.tagged_edges);
      EXPECT_EQ(vertices_of(result.mesh.tags), expected.tagged_vertices);
      ASSERT_EQ(result.mesh.points.size(), expected.mesh.points.size());
      for (int v = 0; v < result.mesh.points.size(); ++v)
        EXPECT_LE((result.mesh.points[VertexId(v)] - expected.mesh.points[VertexId(v)]).norm(),
                  1e-12)
            << "vertex " << v;
    }
  }
}

}  // namespace
}  // namespace limes
