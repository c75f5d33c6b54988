#include "limes/subdiv/triangle_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "subdiv/meshes48.h"
#include "subdiv/zoo.h"

namespace limes {
namespace {

/// Faces whatever their order and first corner.
std::multiset<std::array<int, 3>> faces_of(const Topology& topology) {
  std::multiset<std::array<int, 3>> faces;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    std::array<int, 3> k{face[0].value, face[1].value, face[2].value};
    std::rotate(k.begin(), std::min_element(k.begin(), k.end()), k.end());
    faces.insert(k);
  }
  return faces;
}

int euler(const Topology& topology) {
  return topology.num_vertices() - Adjacency(topology).num_edges() + topology.num_faces();
}

std::vector<Mesh> start_meshes() {
  return {shapes::icosahedron(), triangulated(shapes::torus(5, 4)),
          triangulated(shapes::grid(3, 2)), fan(7, Centre::first)};
}

TEST(TriangleMesh, FlipTakesTheOtherDiagonal) {
  const Mesh square = triangulated(shapes::grid(1, 1));  // (0, 1, 3), (0, 3, 2)
  TriangleMesh mesh{Adjacency(square.topology)};
  mesh.flip(HalfedgeId(2));  // 3-0
  EXPECT_EQ(faces_of(mesh.topology()), (std::multiset<std::array<int, 3>>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(TriangleMesh, WeldsUndoSplits) {
  for (const Mesh& start : start_meshes()) {
    const Adjacency adjacency(start.topology);
    const auto before = faces_of(start.topology);
    for (int h = 0; h < start.topology.num_corners(); ++h) {
      TriangleMesh mesh(adjacency);
      const VertexId b = mesh.to(HalfedgeId(h));
      const VertexId s = mesh.split_edge(HalfedgeId(h));
      EXPECT_EQ(euler(mesh.topology()), euler(start.topology));
      // The second child (s, b, c) of the face was added first.
      const HalfedgeId back(3 * start.topology.num_faces());
      ASSERT_EQ(mesh.from(back), s);
      ASSERT_EQ(mesh.to(back), b);
      const bool boundary = !adjacency.twin(HalfedgeId(h)).valid();
      ASSERT_TRUE(mesh.can_weld_edge(back)) << boundary;
      mesh.weld_edge(back);
      EXPECT_EQ(faces_of(mesh.topology()), before);
    }
    for (int f = 0; f < start.topology.num_faces(); ++f) {
      TriangleMesh mesh(adjacency);
      const VertexId s = mesh.split_face(FaceId(f));
      EXPECT_EQ(euler(mesh.topology()), euler(start.topology));
      const HalfedgeId out = mesh.halfedge(FaceId(f), 2);
      ASSERT_EQ(mesh.from(out), s);
      ASSERT_TRUE(mesh.can_weld_face(out));
      mesh.weld_face(out);
      EXPECT_EQ(faces_of(mesh.topology()), before);
    }
  }
}

TEST(TriangleMesh, FlipIsItsOwnInverse) {
  for (const Mesh& start : start_meshes()) {
    const Adjacency adjacency(start.topology);
    int flips = 0;
    for (int h = 0; h < start.topology.num_corners(); ++h) {
      TriangleMesh mesh(adjacency);
      if (!mesh.can_flip(HalfedgeId(h))) continue;
      ++flips;
      const FaceId f = mesh.face(HalfedgeId(h));
      mesh.flip(HalfedgeId(h));
      EXPECT_EQ(euler(mesh.topology()), euler(start.topology));
      mesh.flip(mesh.halfedge(f, 0));
      EXPECT_EQ(faces_of(mesh.topology()), faces_of(start.topology));
    }
    EXPECT_GT(flips, 0);
  }
}

TEST(TriangleMesh, RefusesWhatWouldBreakTheSurface) {
  const Mesh tetrahedron = shapes::tetrahedron();
  const TriangleMesh mesh{Adjacency(tetrahedron.topology)};
  for (int h = 0; h < 12; ++h)
    EXPECT_FALSE(mesh.can_flip(HalfedgeId(h)));  // the other diagonal is an edge
  for (int h = 0; h < 12; ++h)
    EXPECT_FALSE(mesh.can_weld_edge(HalfedgeId(h)));
  const Mesh hexagon = fan(6, Centre::first);
  const TriangleMesh open{Adjacency(hexagon.topology)};
  EXPECT_FALSE(open.can_flip(HalfedgeId(1)));  // on the boundary
  EXPECT_FALSE(open.can_weld_face(HalfedgeId(0)));
  EXPECT_THROW(TriangleMesh{Adjacency(shapes::cube().topology)}, InputError);
}

TEST(TriangleMesh, StaysASurfaceUnderAnything) {
  for (const Mesh& start : start_meshes()) {
    TriangleMesh mesh{Adjacency(start.topology)};
    std::mt19937 random(7);
    const int expected = euler(start.topology);
    std::array<int, 5> done{};
    for (int i = 0; i < 3000; ++i) {
      const HalfedgeId h(static_cast<int>(random() % static_cast<unsigned>(3 * mesh.num_faces())));
      if (!mesh.has_face(mesh.face(h))) continue;
      const int size = mesh.topology().num_faces();
      const auto what = random() % 5;
      if (what == 0 && size < 60) mesh.split_edge(h), ++done[0];
      if (what == 1 && size < 60) mesh.split_face(mesh.face(h)), ++done[1];
      if (what == 2 && mesh.can_flip(h)) mesh.flip(h), ++done[2];
      if (what == 3 && size > 12 && mesh.can_weld_edge(h)) mesh.weld_edge(h), ++done[3];
      if (what == 4 && size > 12 && mesh.can_weld_face(h)) mesh.weld_face(h), ++done[4];
      if (i % 10 == 0) {
        EXPECT_EQ(euler(mesh.topology()), expected);  // and Adjacency takes it
      }
    }
    for (const int count : done)
      EXPECT_GT(count, 20);
  }
}

}  // namespace
}  // namespace limes
