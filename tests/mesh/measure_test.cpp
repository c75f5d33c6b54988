#include "limes/mesh/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/meshes.h"

namespace limes {
namespace {

using Histogram = std::map<int, int>;

TEST(Measure, Cube) {
  const MeshMeasure m = measure(make_cube());
  EXPECT_EQ(m.vertices, 8);
  EXPECT_EQ(m.edges, 12);
  EXPECT_EQ(m.faces, 6);
  EXPECT_EQ(m.components, 1);
  EXPECT_EQ(m.boundary_loops, 0);
  EXPECT_EQ(m.euler, 2);
  EXPECT_EQ(m.valence_interior, (Histogram{{3, 8}}));
  EXPECT_TRUE(m.valence_boundary.empty());
  EXPECT_EQ(m.bounds.lower, Vec3(0, 0, 0));
  EXPECT_EQ(m.bounds.upper, Vec3(1, 1, 1));
  EXPECT_DOUBLE_EQ(m.bounds.diagonal(), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(m.area, 6.0);
}

TEST(Measure, OpenBoxAndALooseTriangle) {
  Mesh mesh = make_mesh(
      12, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {8, 9, 10}});
  for (int i = 0; i < 8; ++i)
    mesh.points[VertexId(i)] = make_cube().points[VertexId(i)];
  mesh.points[VertexId(8)] = Vec3(5, 0, 0);
  mesh.points[VertexId(9)] = Vec3(8, 0, 0);
  mesh.points[VertexId(10)] = Vec3(5, 4, 0);
  mesh.points[VertexId(11)] = Vec3(100, 0, 0);  // of no face: counts in `vertices` alone
  const MeshMeasure m = measure(mesh);
  EXPECT_EQ(m.vertices, 12);
  EXPECT_EQ(m.edges, 15);
  EXPECT_EQ(m.components, 2);
  EXPECT_EQ(m.boundary_loops, 2);
  EXPECT_EQ(m.euler, 11 - 15 + 6);
  EXPECT_EQ(m.valence_interior, (Histogram{{3, 4}}));
  EXPECT_EQ(m.valence_boundary, (Histogram{{2, 3}, {3, 4}}));
  EXPECT_EQ(m.bounds.upper, Vec3(8, 4, 1));
  EXPECT_DOUBLE_EQ(m.area, 5.0 + 6.0);
}

TEST(Measure, ConcavePolygon) {
  Mesh mesh = make_mesh(5, {{0, 1, 2, 3, 4}});
  mesh.points.vector() = {Vec3(0, 0, 7), Vec3(4, 0, 7), Vec3(4, 4, 7), Vec3(2, 1, 7),
                          Vec3(0, 4, 7)};
  EXPECT_DOUBLE_EQ(measure(mesh).area, 16.0 - 6.0);
}

TEST(Measure, SizesThatDoNotSquare) {
  for (const double size : {1e-300, 1e300}) {
    Mesh mesh = make_cube();
    for (Vec3& x : mesh.points)
      x *= size;
    EXPECT_NEAR(measure(mesh).bounds.diagonal() / size, std::sqrt(3.0), 1e-15);
    EXPECT_DOUBLE_EQ(face_area(mesh, FaceId(0)).relative, 0.5);
  }
  Mesh all = make_cube();  // corners at the largest doubles
  for (Vec3& x : all.points)
    x = (2.0 * x - Vec3::Ones()) * std::numeric_limits<double>::max();
  EXPECT_DOUBLE_EQ(face_area(all, FaceId(0)).relative, 0.5);
  Mesh across = make_mesh(3, {{0, 1, 2}});
  across.points.vector() = {Vec3(-1.5e308, 0, 0), Vec3(1.5e308, 0, 0), Vec3(0, 1e308, 0)};
  EXPECT_DOUBLE_EQ(face_area(across, FaceId(0)).relative, 1.5 / (9 + 1));
}

TEST(Measure, BrokenMeshes) {
  const MeshMeasure bow_tie = measure(make_mesh(5, {{0, 1, 2}, {2, 3, 4}}));
  EXPECT_EQ(bow_tie.components, 1);
  EXPECT_EQ(bow_tie.boundary_loops, 1);
  EXPECT_EQ(bow_tie.valence_boundary, (Histogram{{2, 4}, {4, 1}}));
  const MeshMeasure fan = measure(make_mesh(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(fan.edges, 7);
  EXPECT_EQ(fan.euler, 1);
  const MeshMeasure nothing = measure(Mesh());
  EXPECT_EQ(nothing.components, 0);
  EXPECT_EQ(nothing.bounds.diagonal(), 0);
  const MeshMeasure point = measure(make_mesh(1, {{0}}));
  EXPECT_EQ(point.edges, 0);
  EXPECT_EQ(point.components, 1);
  EXPECT_EQ(point.euler, 2);
}

}  // namespace
}  // namespace limes
