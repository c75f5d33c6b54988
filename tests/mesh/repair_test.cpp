#include "limes/mesh/repair.h"

#include <gtest/gtest.h>

#include "limes/core/error.h"
#include "limes/mesh/adjacency.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/pieces.h"
#include "mesh/meshes.h"

namespace limes {
namespace {

bool is_clean(const Mesh& mesh) {
  return find_defects(mesh).empty();
}

TEST(Repair, LeavesASoundMeshAlone) {
  Mesh cube = make_cube();
  cube.tags.creases = {{VertexId(0), VertexId(1), 2.5F}};
  cube.groups = {{"top", {FaceId(1)}}};
  cube.face_lines = {1, 2, 3, 4, 5, 6};
  const RepairResult result = repair(cube);
  EXPECT_TRUE(result.done.empty());
  EXPECT_EQ(result.mesh.topology, cube.topology);
  EXPECT_EQ(result.mesh.points.vector(), cube.points.vector());
  EXPECT_EQ(result.mesh.tags.creases, cube.tags.creases);
  EXPECT_EQ(result.mesh.groups[0].faces, cube.groups[0].faces);
  EXPECT_EQ(result.mesh.face_lines, cube.face_lines);
}

TEST(Repair, TurnsTheSmallerPart) {
  Mesh cube = make_mesh(
      8, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  cube.points = make_cube().points;
  const RepairResult result = repair(cube);
  ASSERT_EQ(result.done.size(), 1U);
  EXPECT_EQ(result.done[0], "turned 1 face around so that neighbours run alike (3)");
  EXPECT_EQ(corners_of(result.mesh, 3), (std::vector{3, 2, 6, 7}));  // the first corner stays
  EXPECT_EQ(corners_of(result.mesh, 0), (std::vector{0, 2, 3, 1}));
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, TurnsEveryPieceOnItsOwn) {
  // two pairs of triangles; in the second pair both ways are as long: the first face stays
  const Mesh mesh = make_mesh(8, {{0, 1, 2}, {0, 1, 3}, {4, 5, 6}, {4, 5, 7}});
  const RepairResult result = repair(mesh);
  EXPECT_EQ(corners_of(result.mesh, 0), (std::vector{0, 1, 2}));
  EXPECT_EQ(corners_of(result.mesh, 1), (std::vector{0, 3, 1}));
  EXPECT_EQ(corners_of(result.mesh, 2), (std::vector{4, 5, 6}));
  EXPECT_EQ(corners_of(result.mesh, 3), (std::vector{4, 7, 5}));
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, RefusesAMoebiusStrip) {
  const Mesh strip =
      make_mesh(10, {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {6, 7, 9, 8}, {8, 9, 0, 1}});
  EXPECT_THROW(repair(strip), InputError);
}

TEST(Repair, RefusesAMoebiusStripThatADuplicateHid) {
  const Mesh strip = make_mesh(
      10, {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {6, 7, 9, 8}, {8, 9, 0, 1}, {0, 1, 3, 2}});
  EXPECT_THROW(repair(strip), InputError);
}

// Triangles at the vertex 0: one, two that share an edge, and one.
TEST(Pieces, FansApartKeepTheFirstAndCopyTheOthersInOrder) {
  const Mesh mesh = make_mesh(8, {{0, 1, 2}, {3, 4, 0}, {0, 6, 7}, {0, 4, 5}});
  EXPECT_TRUE(has_bow_ties(Adjacency(mesh.topology, Adjacency::Check::edges)));
  const FansApart apart = fans_apart(mesh.topology);
  EXPECT_EQ(apart.original, (std::vector{VertexId(0), VertexId(0)}));
  std::vector<int> corners;
  for (const VertexId v : apart.corners)
    corners.push_back(v.value);
  EXPECT_EQ(corners, (std::vector{0, 1, 2, 3, 4, 8, 9, 6, 7, 8, 4, 5}));
  const Topology surface(10, {0, 3, 6, 9, 12}, apart.corners);
  EXPECT_FALSE(has_bow_ties(Adjacency(surface, Adjacency::Check::edges)));
}

TEST(Repair, SplitsABowTieWithItsTags) {
  Mesh mesh = make_mesh(5, {{0, 1, 2}, {2, 3, 4}});
  mesh.tags.corners = {{VertexId(2), 3.0F}, {VertexId(0), 1.0F}};
  mesh.tags.creases = {{VertexId(1), VertexId(2), 1.0F}, {VertexId(3), VertexId(2), 2.0F}};
  const RepairResult result = repair(mesh);
  ASSERT_EQ(result.done.size(), 1U);
  EXPECT_EQ(result.done[0], "split 1 vertex where fans of faces met (2); 1 vertex added");
  EXPECT_EQ(corners_of(result.mesh, 0), (std::vector{0, 1, 2}));
  EXPECT_EQ(corners_of(result.mesh, 1), (std::vector{5, 3, 4}));
  EXPECT_EQ(result.mesh.points[VertexId(5)], mesh.points[VertexId(2)]);
  const std::vector<CornerTag> corners{
      {VertexId(2), 3.0F}, {VertexId(0), 1.0F}, {VertexId(5), 3.0F}};
  EXPECT_EQ(result.mesh.tags.corners, corners);
  const std::vector<CreaseTag> creases{{VertexId(1), VertexId(2), 1.0F},
                                       {VertexId(3), VertexId(5), 2.0F}};
  EXPECT_EQ(result.mesh.tags.creases, creases);
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, SplitsIntoAsManyAsThereAreFans) {
  const Mesh mesh = make_mesh(7, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}});
  const RepairResult result = repair(mesh);
  EXPECT_EQ(corners_of(result.mesh, 1)[0], 7);
  EXPECT_EQ(corners_of(result.mesh, 2)[0], 8);
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, SplitsAFaceThatMeetsItselfInAPoint) {
  const RepairResult result = repair(make_mesh(5, {{0, 1, 2, 0, 3, 4}}));
  EXPECT_EQ(corners_of(result.mesh, 0), (std::vector{0, 1, 2, 5, 3, 4}));
}

TEST(Repair, KeepsACornerThatIsGivenTwiceInARowTogether) {
  const RepairResult result = repair(make_mesh(6, {{0, 0, 1, 2}, {3, 4, 0, 0}}));
  EXPECT_EQ(corners_of(result.mesh, 0), (std::vector{0, 0, 1, 2}));
  EXPECT_EQ(corners_of(result.mesh, 1), (std::vector{3, 4, 5, 5}));
}

TEST(Repair, RemovesUnusedVerticesAndTheirTags) {
  Mesh mesh = make_mesh(6, {{1, 3, 5}});
  mesh.tags.corners = {{VertexId(0), 1.0F}, {VertexId(5), 2.0F}};
  mesh.tags.creases = {{VertexId(3), VertexId(5), 4.0F}};
  const RepairResult result = repair(mesh);
  ASSERT_EQ(result.done.size(), 1U);
  EXPECT_EQ(result.done[0], "removed 3 vertices of no face (0, 2, 4) with 1 tag");
  EXPECT_EQ(corners_of(result.mesh, 0), (std::vector{0, 1, 2}));
  EXPECT_EQ(result.mesh.points[VertexId(1)], mesh.points[VertexId(3)]);
  EXPECT_EQ(result.mesh.tags.corners, (std::vector<CornerTag>{{VertexId(2), 2.0F}}));
  EXPECT_EQ(result.mesh.tags.creases, (std::vector<CreaseTag>{{VertexId(1), VertexId(2), 4.0F}}));
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, LeavesOutRepeatedFacesAndKeepsNames) {
  Mesh mesh = make_mesh(4, {{0, 1, 2}, {1, 2, 0}, {2, 1, 3}});
  mesh.face_lines = {5, 6, 7};
  mesh.groups = {{"a", {FaceId(0), FaceId(1)}}, {"b", {FaceId(1)}}, {"c", {FaceId(2)}}};
  mesh.parts = {{"p", {FaceId(0), FaceId(1), FaceId(2)}}};
  mesh.tags.holes = {FaceId(2)};
  const RepairResult result = repair(mesh);
  EXPECT_EQ(result.done[0], "left out 1 face that repeats an earlier one (1)");
  EXPECT_EQ(result.mesh.topology.num_faces(), 2);
  EXPECT_EQ(result.mesh.face_lines, (std::vector{5, 7}));
  ASSERT_EQ(result.mesh.groups.size(), 2U);
  EXPECT_EQ(result.mesh.groups[0].faces, (std::vector{FaceId(0)}));
  EXPECT_EQ(result.mesh.groups[1].name, "c");
  EXPECT_EQ(result.mesh.groups[1].faces, (std::vector{FaceId(1)}));
  EXPECT_EQ(result.mesh.parts[0].faces, (std::vector{FaceId(0), FaceId(1)}));
  EXPECT_EQ(result.mesh.tags.holes, (std::vector{FaceId(1)}));
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, NamesTheFacesOfTheGivenMesh) {
  // face 1 repeats face 0, so face 3 becomes face 2 before it is turned
  const RepairResult result = repair(make_mesh(5, {{0, 1, 2}, {0, 1, 2}, {1, 0, 3}, {1, 2, 4}}));
  ASSERT_EQ(result.done.size(), 2U);
  EXPECT_EQ(result.done[1], "turned 1 face around so that neighbours run alike (3)");
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, LeavesOutTagsOnNothing) {
  Mesh mesh = make_cube();
  mesh.tags.creases = {{VertexId(0), VertexId(7), 1.0F}, {VertexId(-4), VertexId(1), 1.0F}};
  mesh.tags.corners = {{VertexId(8), 1.0F}, {VertexId(1), -1.0F}};
  mesh.tags.holes = {FaceId(2), FaceId(6)};
  const RepairResult result = repair(mesh);
  ASSERT_EQ(result.done.size(), 1U);
  EXPECT_EQ(result.done[0].substr(0, 15), "left out 5 tags");
  EXPECT_EQ(result.mesh.tags.holes, (std::vector{FaceId(2)}));
  EXPECT_TRUE(is_clean(result.mesh));
}

TEST(Repair, LeavesABadEdge) {
  const Mesh mesh = make_mesh(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_TRUE(repair(mesh).done.empty());
}

TEST(Repair, WhatIsCleanHasAnAdjacency) {
  const RepairResult result = repair(make_mesh(6, {{0, 1, 2}, {0, 1, 3}, {2, 4, 5}}));
  ASSERT_TRUE(is_clean(result.mesh));
  const Adjacency adjacency(result.mesh.topology);
  EXPECT_EQ(adjacency.num_edges(), 8);
}

}  // namespace
}  // namespace limes
