// Edges with three faces or more are cut, and known again as junctions.

#include "limes/mesh/junctions.h"
#include "limes/core/error.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "limes/mesh/defects.h"
#include "limes/mesh/measure.h"

namespace limes {
namespace {

Mesh make(std::vector<Vec3> points, const std::vector<int>& quads) {
  std::vector<VertexId> corners;
  for (const int v : quads)
    corners.emplace_back(v);
  Mesh mesh;
  mesh.topology = Topology(static_cast<int>(points.size()), 4, std::move(corners));
  mesh.points = IdArray<VertexId, Vec3>(std::move(points));
  return mesh;
}

/// Two pages that lie flat and one that stands, all on the edge 0-1.
Mesh book() {
  return make(
      {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 1, 1}},
      {0, 2, 3, 1, 0, 1, 5, 4, 1, 0, 6, 7});
}

bool is_surface(const Mesh& mesh) {
  const std::vector<Defect> defects = find_defects(mesh);
  return std::none_of(defects.begin(), defects.end(),
                      [](const Defect& d) { return blocks_refinement(d.kind); });
}

void expect_same_places(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.topology.num_corners(), b.topology.num_corners());
  for (int h = 0; h < a.topology.num_corners(); ++h)
    EXPECT_EQ(a.points[a.topology.corner(HalfedgeId(h))],
              b.points[b.topology.corner(HalfedgeId(h))]);
}

TEST(Junctions, EachPageGetsItsOwnEdge) {
  const Mesh mesh = book();
  EXPECT_FALSE(is_surface(mesh));
  const CutMesh cut = cut_junctions(mesh);
  EXPECT_EQ(cut.num_edges, 1);
  EXPECT_EQ(cut.mesh.points.size(), 8 + 4);
  EXPECT_TRUE(is_surface(cut.mesh));
  EXPECT_EQ(measure(cut.mesh).components, 3);
  expect_same_places(mesh, cut.mesh);
  // both ends of the junction, three times
  EXPECT_EQ(cut.mesh.tags.corners.size(), 6U);
  const auto tied = junction_edges(cut.mesh, Adjacency(cut.mesh.topology));
  EXPECT_EQ(tied.size(), 3U);
  for (const TiedEdge& e : tied)
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(cut.mesh.points[e.ends[i]], cut.mesh.points[e.tied[i]]);
  const auto node = tied_nodes(cut.mesh.points.size(), tied);
  EXPECT_EQ(std::count_if(node.begin(), node.end(), [](VertexId v) { return v.value < 2; }), 6);
}

// A stiffener that ends inside a plate cuts it as far as it goes; at its tip the plate holds together.
TEST(Junctions, EndInsideAPlate) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      x.emplace_back(i, j, 0);
  for (const int a : {0, 1, 3, 4})
    quads.insert(quads.end(), {a, a + 1, a + 4, a + 3});
  x.emplace_back(0, 1, 1);
  x.emplace_back(1, 1, 1);
  quads.insert(quads.end(), {3, 4, 10, 9});  // on the edge from (0, 1) to the middle
  const CutMesh cut = cut_junctions(make(x, quads));
  EXPECT_EQ(cut.num_edges, 1);
  EXPECT_EQ(cut.mesh.points.size(), 11 + 2 + 1);
  EXPECT_TRUE(is_surface(cut.mesh));
  EXPECT_EQ(measure(cut.mesh).components, 2);
  EXPECT_EQ(junction_edges(cut.mesh, Adjacency(cut.mesh.topology)).size(), 3U);
}

// Around both ends of such an edge the plate is in one piece: it would not be tied to the wall.
TEST(Junctions, OfOneEdgeInsideAPlateAreRefused) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      x.emplace_back(i, j, 0);
  for (const int a : {0, 1, 2, 4, 5, 6, 8, 9, 10})
    quads.insert(quads.end(), {a, a + 1, a + 5, a + 4});
  x.emplace_back(1, 1, 1);
  x.emplace_back(2, 1, 1);
  quads.insert(quads.end(), {5, 6, 17, 16});
  try {
    (void)cut_junctions(make(x, quads));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "the edge of vertices 5 and 6 has 3 faces, and both ends lie inside "
              "a piece, which cannot be cut along one edge; split the edge once");
  }
}

TEST(Junctions, TagsFollowTheirEdges) {
  Mesh mesh = book();
  mesh.tags.creases.push_back({VertexId(1), VertexId(7), 3});  // of the page that stands
  mesh.tags.corners.push_back({VertexId(7), 2});
  const CutMesh cut = cut_junctions(mesh);
  const CreaseTag crease = cut.mesh.tags.creases.at(0);
  const Adjacency adjacency(cut.mesh.topology);
  EXPECT_TRUE(find_edge(adjacency, crease.a, crease.b).valid());
  EXPECT_EQ(cut.mesh.points[crease.a], Vec3(0, 1, 0));
  EXPECT_EQ(cut.mesh.tags.corners.at(0), (CornerTag{VertexId(7), 2}));
}

TEST(Junctions, WhatIsNoneStays) {
  const Mesh flat = make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                         {0, 1, 4, 3, 1, 2, 5, 4});
  EXPECT_EQ(cut_junctions(flat).mesh.topology, flat.topology);
  EXPECT_TRUE(junction_edges(flat, Adjacency(flat.topology)).empty());
  // a page that touches the junction with a corner only, and one that is there twice
  const Mesh pages = book();
  std::vector<Vec3> x(pages.points.begin(), pages.points.end());
  x.insert(x.end(), {{0, -1, 0}, {0, -1, -1}, {0, 0, -1}});
  EXPECT_FALSE(
      is_surface(cut_junctions(make(x, {0, 2, 3, 1, 0, 1, 5, 4, 1, 0, 6, 7, 0, 8, 9, 10})).mesh));
  EXPECT_FALSE(is_surface(cut_junctions(make(x, {0, 2, 3, 1, 0, 1, 5, 4, 0, 1, 5, 4})).mesh));
}

}  // namespace
}  // namespace limes
