#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "limes/limit/forest_limits.h"
#include "limes/limit/limit_surface.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

/// Parameters of the corners of child i of a face whose corners have the parameters p.
std::vector<Vec2> child_parameters(const std::vector<Vec2>& p, std::size_t i) {
  const std::size_t n = p.size();
  const auto middle = [&](std::size_t k) -> Vec2 { return 0.5 * (p[k % n] + p[(k + 1) % n]); };
  if (n == 4) return {p[i], middle(i), 0.5 * (p[0] + p[2]), middle(i + 3)};
  if (i < 3) return {p[i], middle(i), middle(i + 2)};
  return {middle(0), middle(1), middle(2)};
}

/// Vertices of a forest lie where the limit surface of the control mesh is: at the corners of a leaf, whose
/// place in its control face follows from its path.
void expect_on_limit(const char* name, const Mesh& control, const std::vector<FaceAncestry>& marks,
                     const RefineOptions& options = {}) {
  const Scheme& scheme = find_scheme(name);
  Forest forest(control, scheme, options, SplitUnit::families, forest_limits(scheme));
  forest.refine(forest.leaves());
  for (const FaceAncestry& mark : marks) {
    const std::vector<FaceId> leaves = forest.leaves();
    const auto leaf = std::find_if(leaves.begin(), leaves.end(),
                                   [&](FaceId f) { return forest.ancestry(f) == mark; });
    ASSERT_NE(leaf, leaves.end());
    forest.refine(std::vector{*leaf});
  }
  (void)forest_mesh(forest, Closure::conforming);
  const Adjacency adjacency(control.topology);
  const LimitBasis basis(control.topology, control_features(adjacency, control, scheme, options),
                         scheme);
  const LimitSurface surface(basis, control.points.span());
  for (const FaceId f : forest.leaves()) {
    const FaceAncestry a = forest.ancestry(f);
    std::vector<Vec2> uv(square_corners.begin(), square_corners.end());
    if (basis.on_triangles()) uv.assign(triangle_corners.begin(), triangle_corners.end());
    for (int level = a.level - 1; level >= 0; --level)
      uv = child_parameters(uv, static_cast<std::size_t>((a.path >> (2 * level)) & 3));
    for (std::size_t i = 0; i < uv.size(); ++i)
      EXPECT_LE((forest.nodes().position(forest.corners(f)[i]) - surface.position(a.root, 0, uv[i]))
                    .norm(),
                1e-13)
          << "root " << a.root.value << " level " << a.level << " path " << a.path;
  }
}

TEST(ForestLimits, LieOnTheLimitSurface) {
  expect_on_limit("catmull-clark", shapes::cube(), {{FaceId(0), 1, 0}, {FaceId(0), 2, 0}});
  expect_on_limit("catmull-clark", shapes::grid(3, 2),
                  {{FaceId(0), 1, 0}, {FaceId(0), 2, 1}, {FaceId(4), 1, 2}});
  const std::vector<FaceAncestry> beside_valence_5{{FaceId(1), 1, 0}, {FaceId(1), 2, 0}};
  expect_on_limit("catmull-clark", shapes::disk(5, 1), beside_valence_5);
  expect_on_limit("catmull-clark", shapes::disk(5, 1), beside_valence_5,
                  {.weights = ExtraordinaryWeights::quarters});
}

TEST(ForestLimits, LieOnTheLimitSurfaceOfLoop) {
  const std::vector<FaceAncestry> to_a_corner{
      {FaceId(0), 1, 0}, {FaceId(0), 2, 0}, {FaceId(0), 3, 3}};
  expect_on_limit("loop", shapes::icosahedron(), to_a_corner);
  expect_on_limit("loop", shapes::tetrahedron(), to_a_corner);
  expect_on_limit("loop", shapes::triangle_star(7, 2), to_a_corner);
  expect_on_limit("loop", shapes::triangle_star(4, 1), {{FaceId(1), 1, 3}, {FaceId(1), 2, 13}},
                  {.boundary = BoundaryRule::edges_and_corners});
  expect_on_limit("loop", shapes::icosahedron(), to_a_corner,
                  {.weights = ExtraordinaryWeights::warren});
}

/// Two faces to be split whose surroundings meet in a vertex only: the rim of the patch touches itself.
TEST(ForestLimits, ArePlacedWhereARimTouchesItself) {
  const Mesh control = shapes::grid(12, 12);
  Forest forest(control, find_scheme("catmull-clark"), {}, SplitUnit::faces,
                forest_limits(find_scheme("catmull-clark")));
  forest.refine(forest.leaves());
  const auto leaf = [&](int root) { return forest.child(FaceId(root), 0); };
  // Of the 24 x 24 faces of level 1, (10, 10) and (13, 13) at (5, 5) and (6.5, 6.5): 3 apart.
  forest.refine(std::array{leaf(5 * 12 + 5), forest.child(FaceId(6 * 12 + 6), 2)});
  const Vec3 middle = forest.nodes().position(forest.corners(forest.child(leaf(5 * 12 + 5), 0))[2]);
  // Plane B-spline surfaces with uniform control points are linear.
  EXPECT_LE((middle - Vec3(5.25, 5.25, 0)).norm(), 1e-14);
}

/// Sharp and semi-sharp edges, a dart, a corner.
TEST(ForestLimits, KnowCreasesOfLoop) {
  Mesh control = shapes::icosahedron();
  const auto v = control.topology.face(FaceId(0));
  const auto w = control.topology.face(FaceId(12));
  control.tags.creases = {
      {v[0], v[1], infinite_sharpness}, {v[1], v[2], 1.5F}, {w[0], w[1], 2.25F}};
  control.tags.corners = {{w[2], infinite_sharpness}};
  for (const int face : {0, 12})
    expect_on_limit("loop", control,
                    {{FaceId(face), 1, 1}, {FaceId(face), 2, 5}, {FaceId(face), 3, 20}});
}

}  // namespace
}  // namespace limes
