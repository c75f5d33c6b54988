#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"

// Catmull-Clark's weights as printed in the papers, the numbering, and bits that do not depend on
// where a walk starts.

namespace limes {
namespace {

const Scheme& catmull_clark() {
  return find_scheme("catmull-clark");
}

SparseMatrix matrix_of(const Mesh& mesh, BoundaryRule boundary = BoundaryRule::edges) {
  const Adjacency adjacency(mesh.topology);
  const Features features = resolve_tags(adjacency, mesh.tags, boundary);
  return RefinementStep(adjacency, features, catmull_clark()).matrix();
}

/// Weights of one row by old vertex, without zeros.
std::map<int, double> row_of(const SparseMatrix& S, int row) {
  std::map<int, double> weights;
  for (SparseMatrix::InnerIterator it(S, row); it; ++it)
    if (it.value() != 0.0) weights[static_cast<int>(it.col())] = it.value();
  return weights;
}

/// 3 x 3 grid: vertices 0 to 15, row by row; 5, 6, 9, 10 are inside. Edges are numbered by first
/// appearance: face 0 = (0, 1, 5, 4) has edges 0-1, 1-5, 5-4, 4-0, and so on.
TEST(CatmullClark, HasTheRegularWeightsExactly) {
  const Mesh grid = shapes::grid(3, 3);
  const SparseMatrix S = matrix_of(grid);
  const std::map<int, double> vertex5{{5, 9.0 / 16}, {1, 3.0 / 32}, {4, 3.0 / 32},
                                      {6, 3.0 / 32}, {9, 3.0 / 32}, {0, 1.0 / 64},
                                      {2, 1.0 / 64}, {8, 1.0 / 64}, {10, 1.0 / 64}};
  EXPECT_EQ(row_of(S, 5), vertex5);
  const std::map<int, double> edge_1_5{{1, 3.0 / 8},  {5, 3.0 / 8},  {0, 1.0 / 16},
                                       {4, 1.0 / 16}, {2, 1.0 / 16}, {6, 1.0 / 16}};
  EXPECT_EQ(row_of(S, 16 + 1), edge_1_5);
  const std::map<int, double> boundary_edge{{0, 0.5}, {1, 0.5}};
  EXPECT_EQ(row_of(S, 16 + 0), boundary_edge);
  const std::map<int, double> boundary1{{1, 0.75}, {0, 0.125}, {2, 0.125}};
  EXPECT_EQ(row_of(S, 1), boundary1);
  const std::map<int, double> corner0{{0, 0.75}, {1, 0.125}, {4, 0.125}};
  EXPECT_EQ(row_of(S, 0), corner0);
  EXPECT_EQ(row_of(matrix_of(grid, BoundaryRule::edges_and_corners), 0),
            (std::map<int, double>{{0, 1.0}}));
  const std::map<int, double> face0{{0, 0.25}, {1, 0.25}, {5, 0.25}, {4, 0.25}};
  EXPECT_EQ(row_of(S, 16 + 24), face0);
}

/// beta and gamma of [catmull_clark_1978]: V' = (n - 3)/n V + 2/n of the edge midpoints' mean + 1/n of
/// the face points' mean, summed up for quads.
TEST(CatmullClark, HasTheIrregularVertexWeights) {
  for (const int n : {3, 5, 8}) {
    const std::map<int, double> row = row_of(matrix_of(shapes::disk(n, 1)), 0);
    const double own = (n - 3.0) / n + 2.0 / n * 0.5 + 1.0 / n * 0.25;
    EXPECT_NEAR(row.at(0), own, 1e-15);
    EXPECT_EQ(row.size(), static_cast<std::size_t>(2 * n + 1));
    double neighbours = 0;
    for (const auto& [v, w] : row)
      if (v != 0) neighbours += w;
    EXPECT_NEAR(neighbours, 1 - own, 1e-15);
  }
}

/// Two quads: old vertices, edges by first appearance, faces; child i = (v_i, e_i, f, e_{i-1}).
TEST(CatmullClark, NumbersChildrenAsPromised) {
  const Mesh strip = shapes::grid(2, 1);  // faces (0 1 4 3) and (1 2 5 4)
  const Mesh fine = refine(strip, catmull_clark(), {});
  // edges: 0-1, 1-4, 4-3, 3-0, 1-2, 2-5, 5-4 are 6 to 12; faces 13 and 14
  const std::vector<std::array<int, 4>> expected{{0, 6, 13, 9},   {1, 7, 13, 6},  {4, 8, 13, 7},
                                                 {3, 9, 13, 8},   {1, 10, 14, 7}, {2, 11, 14, 10},
                                                 {5, 12, 14, 11}, {4, 7, 14, 12}};
  ASSERT_EQ(fine.topology.num_faces(), 8);
  for (int f = 0; f < 8; ++f)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(fine.topology.face(FaceId(f))[i].value, expected[static_cast<std::size_t>(f)][i]);
}

/// Faces in another order that start at other corners: the same bits at every old vertex.
TEST(CatmullClark, BitsDoNotDependOnWhereFacesStart) {
  Mesh mesh = shapes::torus(7, 5);
  std::mt19937 random(3);
  std::vector<int> order(static_cast<std::size_t>(mesh.topology.num_faces()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<VertexId> corners;
  for (const int f : order) {
    const auto face = mesh.topology.face(FaceId(f));
    const std::size_t first = random() % 4;
    for (std::size_t i = 0; i < 4; ++i)
      corners.push_back(face[(first + i) % 4]);
  }
  Mesh shuffled = mesh;
  shuffled.topology = Topology(mesh.topology.num_vertices(), 4, corners);
  const Mesh a = refine(mesh, catmull_clark(), {.levels = 3});
  const Mesh b = refine(shuffled, catmull_clark(), {.levels = 3});
  for (int v = 0; v < mesh.topology.num_vertices(); ++v)
    EXPECT_EQ(a.points[VertexId(v)], b.points[VertexId(v)]);
  const auto sorted = [](const Mesh& m) {
    std::vector<std::array<double, 3>> points;
    for (const Vec3& x : m.points)
      points.push_back({x.x(), x.y(), x.z()});
    std::sort(points.begin(), points.end());
    return points;
  };
  EXPECT_EQ(sorted(a), sorted(b));
}

/// What the children of a mesh inherit.
TEST(Refine, CarriesGroupsPartsHolesAndTags) {
  Mesh mesh = shapes::grid(2, 1);
  mesh.groups = {{"left", {FaceId(0)}}, {"all", {FaceId(0), FaceId(1)}}};
  mesh.parts = {{"a", {FaceId(1)}}, {"b", {FaceId(0)}}};
  mesh.tags.holes = {FaceId(1)};
  mesh.tags.creases = {{VertexId(1), VertexId(4), 2.5F}};
  mesh.tags.corners = {{VertexId(0), 1.25F}};
  const Mesh fine = refine(mesh, catmull_clark(), {});
  const std::vector<FaceId> left{FaceId(0), FaceId(1), FaceId(2), FaceId(3)};
  const std::vector<FaceId> right{FaceId(4), FaceId(5), FaceId(6), FaceId(7)};
  EXPECT_EQ(fine.groups[0].faces, left);
  EXPECT_EQ(fine.groups[1].faces.size(), 8U);
  EXPECT_EQ(fine.parts[0].faces, right);
  EXPECT_EQ(fine.tags.holes, right);
  ASSERT_EQ(fine.tags.creases.size(), 2U);
  for (const CreaseTag& t : fine.tags.creases) {
    EXPECT_EQ(t.sharpness, 1.5F);
    EXPECT_EQ(std::max(t.a, t.b), VertexId(7));  // edge 1-4 has child 7
  }
  EXPECT_EQ(fine.tags.corners, (std::vector<CornerTag>{{VertexId(0), 0.25F}}));
}

TEST(Refine, WithoutBoundaryDropsOpenFaces) {
  const Mesh fine =
      refine(shapes::grid(3, 3), catmull_clark(), {.levels = 1, .boundary = BoundaryRule::none});
  EXPECT_EQ(fine.topology.num_faces(), 4);
  EXPECT_EQ(fine.points.size(), 9);
  for (const Vec3& x : fine.points)
    EXPECT_TRUE(x.x() >= 1 && x.x() <= 2 && x.y() >= 1 && x.y() <= 2) << x.transpose();
}

TEST(Crease, ChaikinMixesWithTheOtherSemiSharpEdges) {
  const std::vector<float> edges{2.0F, 0.0F, 4.0F, 10.0F};
  // 3/4 of the own value, 1/4 of the mean of the others that are semi-sharp, less 1
  EXPECT_FLOAT_EQ(decayed_at_vertex(CreaseMethod::chaikin, 0, edges), 1.5F);
  EXPECT_FLOAT_EQ(decayed_at_vertex(CreaseMethod::chaikin, 2, edges), 2.5F);
  EXPECT_EQ(decayed_at_vertex(CreaseMethod::chaikin, 1, edges), 0.0F);
  EXPECT_EQ(decayed_at_vertex(CreaseMethod::chaikin, 3, edges), 10.0F);
  EXPECT_FLOAT_EQ(decayed_at_vertex(CreaseMethod::uniform, 0, edges), 1.0F);
}

}  // namespace
}  // namespace limes
