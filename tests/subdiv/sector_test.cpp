#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"

// Boundary stencils by sector [biermann_2000]: where the standard surface folds, these do not.

namespace limes {
namespace {

/// A plane sector of `num_faces` unit rhombs around vertex 0, which is a corner of the given angle.
Mesh sector(int num_faces, double angle) {
  Mesh mesh;
  std::vector<VertexId> corners;
  const auto at = [&](int i) {
    const double phi = angle * i / num_faces;
    return Vec3(std::cos(phi), std::sin(phi), 0);
  };
  mesh.points.push_back(Vec3::Zero());
  for (int i = 0; i <= num_faces; ++i)
    mesh.points.push_back(at(i));
  for (int i = 0; i < num_faces; ++i) {
    mesh.points.push_back(at(i) + at(i + 1));
    for (const int v : {0, 1 + i, 2 + num_faces + i, 2 + i})
      corners.emplace_back(v);
  }
  mesh.topology = Topology(2 * num_faces + 2, 4, std::move(corners));
  mesh.tags.corners = {{VertexId(0), infinite_sharpness}};
  return mesh;
}

/// Faces whose area in the plane is not positive.
int num_folded(const Mesh& mesh) {
  int count = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    double area = 0;
    const auto v = mesh.topology.face(FaceId(f));
    for (std::size_t i = 0; i < v.size(); ++i)
      area += mesh.points[v[i]].cross(mesh.points[v[(i + 1) % v.size()]]).z();
    if (area <= 0) ++count;
  }
  return count;
}

Mesh refined(const Mesh& mesh, bool sector_stencils) {
  return refine(mesh, find_scheme("catmull-clark"),
                {.levels = 5,
                 .boundary = BoundaryRule::edges_and_corners,
                 .sector_stencils = sector_stencils});
}

TEST(SectorStencils, AConcaveCornerFoldsWithoutThem) {
  struct Case {
    int num_faces;
    double degrees;
    double shift;  // of all but the boundary's two spokes, away from the surface
  };
  for (const Case& c : {Case{2, 270, 0.0}, Case{2, 270, 0.4}, Case{2, 315, 0.3}, Case{3, 270, 0.6},
                        Case{3, 315, 0.5}, Case{4, 315, 0.6}}) {
    SCOPED_TRACE(testing::Message() << c.num_faces << " faces, " << c.degrees << " degrees");
    const double angle = c.degrees * std::numbers::pi / 180;
    Mesh mesh = sector(c.num_faces, angle);
    for (int v = 2; v < mesh.points.size(); ++v)
      if (v != c.num_faces + 1)
        mesh.points[VertexId(v)] -= c.shift * Vec3(std::cos(angle / 2), std::sin(angle / 2), 0);
    EXPECT_EQ(num_folded(mesh), 0);
    EXPECT_GT(num_folded(refined(mesh, false)), 0);
    EXPECT_EQ(num_folded(refined(mesh, true)), 0);
  }
}

/// The rules of a regular boundary and of a right-angled corner with one face are the standard ones.
TEST(SectorStencils, AgreeWithTheStandardRulesWhereThoseAreRegular) {
  const Mesh mesh = shapes::grid(4, 3);
  const Mesh plain = refined(mesh, false);
  const Mesh sectors = refined(mesh, true);
  EXPECT_EQ(plain.topology, sectors.topology);
  for (int v = 0; v < plain.points.size(); ++v)
    EXPECT_LE((plain.points[VertexId(v)] - sectors.points[VertexId(v)]).norm(), 1e-14);
}

/// Eigenvalues of the ring of a concave corner: 1, twice 1/2 with a plane sector as eigenvectors,
/// nothing else above 1/4, as section 4 of the paper asks.
TEST(SectorStencils, HalfIsTheSubdominantEigenvalueOfAConcaveCorner) {
  for (const int k : {2, 3, 5, 8}) {
    SCOPED_TRACE(k);
    const Mesh mesh = sector(k, 1.4 * std::numbers::pi);
    const Adjacency adjacency(mesh.topology);
    Features features = resolve_tags(adjacency, mesh.tags, BoundaryRule::edges_and_corners);
    measure_corners(adjacency, mesh.points.span(), features);
    EXPECT_NEAR(features.vertices.front().angle, 1.4 * std::numbers::pi, 1e-14);
    const RefinementStep step(adjacency, features, find_scheme("catmull-clark"));
    const Eigen::MatrixXd S = step.matrix();
    // The ring again: its vertex, the new vertices of the edges there, those of the faces.
    const int n = 2 * k + 2;
    Eigen::MatrixXd A(n, n);
    A.row(0) = S.row(0);
    for (int i = 0; i <= k; ++i) {
      const HalfedgeId h =
          i < k ? mesh.topology.halfedge(FaceId(i), 0) : mesh.topology.halfedge(FaceId(k - 1), 3);
      A.row(1 + i) = S.row(n + adjacency.edge(h).value);
    }
    for (int i = 0; i < k; ++i)
      A.row(2 + k + i) = S.row(n + adjacency.num_edges() + i);
    VectorX x(n), y(n);
    for (int v = 0; v < n; ++v) {
      x(v) = mesh.points[VertexId(v)].x();
      y(v) = mesh.points[VertexId(v)].y();
    }
    EXPECT_LE((A * x - 0.5 * x).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LE((A * y - 0.5 * y).cwiseAbs().maxCoeff(), 1e-14);
    VectorX values = Eigen::EigenSolver<Eigen::MatrixXd>(A).eigenvalues().cwiseAbs();
    std::sort(values.begin(), values.end(), std::greater<>());
    EXPECT_NEAR(values(0), 1, 1e-12);
    EXPECT_NEAR(values(1), 0.5, 1e-7);
    EXPECT_NEAR(values(2), 0.5, 1e-7);
    EXPECT_LE(values(3), 0.25 + 1e-7);
  }
}

TEST(SectorStencils, MatrixAgreesWithApply) {
  const Mesh mesh = sector(4, 1.5 * std::numbers::pi);
  const Adjacency adjacency(mesh.topology);
  Features features = resolve_tags(adjacency, mesh.tags, BoundaryRule::edges_and_corners);
  measure_corners(adjacency, mesh.points.span(), features);
  const RefinementStep step(adjacency, features, find_scheme("catmull-clark"));
  std::vector<Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
  step.apply(mesh.points.span(), fine);
  const SparseMatrix S = step.matrix();
  VectorX x(S.cols());
  for (int v = 0; v < mesh.points.size(); ++v)
    x(v) = mesh.points[VertexId(v)].x();
  const VectorX y = S * x;
  for (Eigen::Index i = 0; i < y.size(); ++i)
    EXPECT_NEAR(y(i), fine[static_cast<std::size_t>(i)].x(), 2e-15);
}

}  // namespace
}  // namespace limes
