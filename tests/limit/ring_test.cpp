#include "limes/limit/ring.h"

#include <gtest/gtest.h>

#include "limes/mesh/shapes.h"
#include "limit/surface.h"
#include "limit/zoo.h"

namespace limes::test {
namespace {

/// Number of plain rings; each must be what the general walk finds.
int count_plain_rings(const Model& model) {
  const Scheme& scheme = find_scheme("catmull-clark");
  const Adjacency adjacency(model.topology);
  const Sharpness sharpness(adjacency, model.features);
  int count = 0;
  for (int f = 0; f < model.topology.num_faces(); ++f) {
    const auto plain = plain_ring(adjacency, sharpness, FaceId(f));
    if (!plain) continue;
    ++count;
    const Ring ring = gather_ring(adjacency, model.features, sharpness, scheme, FaceId(f));
    EXPECT_EQ(ring.vertices, std::vector<VertexId>(plain->begin(), plain->end()));
    EXPECT_EQ(ring.topology.num_faces(), 9);
    EXPECT_TRUE(ring.features.edges.empty() && ring.features.vertices.empty());
  }
  return count;
}

TEST(PlainRing, HasTheOrderOfTheGeneralWalk) {
  EXPECT_EQ(count_plain_rings(make_model(shapes::torus(5, 6))), 30);
  EXPECT_EQ(count_plain_rings(make_model(shapes::torus(3, 5))), 0) << "vertices appear twice";
  EXPECT_EQ(count_plain_rings(make_model(shapes::grid(6, 5))), 12) << "inner faces";
  EXPECT_EQ(count_plain_rings(make_model(shapes::disk(5, 1))), 0);
  for (const Shape& shape : limit_shapes())
    count_plain_rings(make_model(shape.mesh, shape.boundary));
}

TEST(PlainRing, HasNothingSharpAtItsCorners) {
  Mesh mesh = shapes::torus(5, 6);
  const auto corners = mesh.topology.face(FaceId(7));
  mesh.tags.creases.push_back({corners[0], corners[1], 1.5F});
  // the faces around its two ends: 4 + 4, of which the 2 beside it count twice
  EXPECT_EQ(count_plain_rings(make_model(mesh)), 30 - 6);
  mesh.tags.creases.clear();
  mesh.tags.corners.push_back({corners[0], 0.5F});
  EXPECT_EQ(count_plain_rings(make_model(mesh)), 30 - 4);
}

}  // namespace
}  // namespace limes::test
