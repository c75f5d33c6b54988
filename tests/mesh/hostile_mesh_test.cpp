#include <gtest/gtest.h>

#include <cmath>

#include "limes/mesh/defects.h"
#include "limes/mesh/measure.h"
#include "limes/mesh/repair.h"
#include "mesh/meshes.h"

// Large meshes that punish anything quadratic: with 200,000 of each the tests would not end.

namespace limes {
namespace {

constexpr int many = 200000;

Mesh triangles(int num_vertices, const std::vector<std::array<int, 3>>& faces) {
  std::vector<VertexId> corners;
  for (const auto& face : faces)
    for (const int v : face)
      corners.emplace_back(v);
  Mesh mesh;
  mesh.topology = Topology(num_vertices, 3, std::move(corners));
  for (int i = 0; i < num_vertices; ++i)
    mesh.points.push_back(Vec3(std::cos(i), std::sin(i), 0));  // no three on a line
  return mesh;
}

TEST(HostileMesh, OneFaceAgainAndAgain) {
  std::vector<std::array<int, 3>> faces(many, {0, 1, 2});
  faces.resize(2 * many, {2, 1, 0});
  const Mesh mesh = triangles(3, faces);
  EXPECT_EQ(measure(mesh).edges, 3);
  const RepairResult result = repair(mesh);
  EXPECT_EQ(result.mesh.topology.num_faces(), 2);
  EXPECT_EQ(find_defects(result.mesh).size(), 1U);  // a pillow
}

TEST(HostileMesh, ManyFansAtOneVertexWithManyTags) {
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < many; ++i)
    faces.push_back({0, 2 * i + 1, 2 * i + 2});
  Mesh mesh = triangles(2 * many + 1, faces);
  for (int i = 0; i < many; ++i) {
    mesh.tags.corners.push_back({VertexId(0), 1.0F + static_cast<float>(i % 3)});
    mesh.tags.creases.push_back({VertexId(0), VertexId(1), 1});
  }
  EXPECT_EQ(find_defects(mesh).front().kind, DefectKind::non_manifold_vertex);
  const RepairResult result = repair(mesh);
  EXPECT_EQ(result.mesh.points.size(), 3 * many);
  EXPECT_EQ(result.mesh.tags.corners.size(), static_cast<std::size_t>(2 * many - 1));
  EXPECT_EQ(result.mesh.tags.corners.back(), (CornerTag{VertexId(3 * many - 1), 2.0F}));
  EXPECT_TRUE(find_defects(result.mesh).empty());
}

TEST(HostileMesh, ManyFacesOnOneEdge) {
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < many; ++i)
    faces.push_back({0, 1, i + 2});
  const Mesh mesh = triangles(many + 2, faces);
  const auto defects = find_defects(mesh);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].faces.size(), static_cast<std::size_t>(many));
  EXPECT_LT(defects[0].message.size(), 200U);
  EXPECT_EQ(measure(mesh).valence_boundary.at(2), many);
}

TEST(HostileMesh, AStripThatIsTurnedAtEveryFace) {
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < many; ++i)
    faces.push_back({i, i + 1, i + 2});  // all the same way: every second one runs against
  const Mesh mesh = triangles(many + 2, faces);
  const RepairResult result = repair(mesh);
  ASSERT_EQ(result.done.size(), 1U);
  EXPECT_EQ(result.done[0].rfind("turned 100000 faces", 0), 0U);
}

TEST(HostileMesh, OneFaceWithManyCorners) {
  std::vector<VertexId> corners;
  for (int i = 0; i < many; ++i)
    corners.emplace_back(i);
  Mesh mesh = triangles(many, {});
  mesh.topology = Topology(many, many, corners);
  EXPECT_TRUE(find_defects(mesh).empty());
  corners.insert(corners.end(), corners.begin(), corners.end());
  mesh.topology = Topology(many, 2 * many, corners);
  EXPECT_EQ(find_defects(mesh).front().kind, DefectKind::repeated_corner);
}

}  // namespace
}  // namespace limes
