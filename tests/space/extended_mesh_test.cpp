#include <gtest/gtest.h>

#include <random>

#include "convergence/plane_meshes.h"
#include "limes/limit/limit_surface.h"
#include "limes/space/extended_mesh.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

struct Case {
  std::string name;
  Mesh mesh;
  int standard;  ///< vertices that keep the standard functions
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

Vec2 bent(const Vec2& p) {
  return {p.x() + .2 * p.y() * p.y(), p.y() + .1 * std::sin(3 * p.x())};
}

/// A grid of m x n quads without some of them; unused vertices stay.
Mesh grid_without(int m, int n, const std::vector<int>& drop, bool bend) {
  Mesh full = testing::grid(m, n, [&](const Vec2& p) { return bend ? bent(p) : p; });
  std::vector<VertexId> corners;
  for (int f = 0; f < full.topology.num_faces(); ++f)
    if (std::find(drop.begin(), drop.end(), f) == drop.end())
      for (const VertexId v : full.topology.face(FaceId(f)))
        corners.push_back(v);
  full.topology = Topology(full.topology.num_vertices(), 4, std::move(corners));
  return full;
}

Mesh l_shape(bool bend, bool sharp) {
  Mesh mesh = grid_without(4, 4, {10, 11, 14, 15}, bend);
  if (sharp) mesh.tags.corners.push_back({VertexId(12), infinite_sharpness});
  return mesh;
}

Mesh rounded(Mesh mesh) {
  mesh.tags.boundary = BoundaryRule::edges;
  return mesh;
}

Mesh kinked_side() {
  Mesh mesh = testing::grid(3, 3, bent);
  mesh.tags.corners.push_back({VertexId(1), infinite_sharpness});
  return mesh;
}

Mesh creased(float sharpness) {
  Mesh mesh = testing::grid(4, 3, bent);
  for (int j = 0; j < 3; ++j)
    mesh.tags.creases.push_back({VertexId(5 * j + 2), VertexId(5 * j + 7), sharpness});
  return mesh;
}

/// Half a fan: k faces around a boundary vertex.
Mesh half_fan(int k) {
  std::vector<Vec3> x{Vec3(0, 0, 0)};
  std::vector<int> quads;
  for (int i = 0; i <= 2 * k; ++i) {
    const double a = std::numbers::pi * i / (2 * k);
    const double r = i % 2 == 0 ? 1 : 1.4;
    x.emplace_back(r * std::cos(a), r * std::sin(a), .1 * i * i);
  }
  for (int i = 0; i < k; ++i)
    quads.insert(quads.end(), {0, 2 * i + 1, 2 * i + 2, 2 * i + 3});
  return testing::make_mesh(std::move(x), std::move(quads));
}

class GhostsKeepTheGeometry : public ::testing::TestWithParam<Case> {};

// The geometry continued by 2 b - c must be one of the field's functions: else affine displacements
// would not be, and the method would fail the patch test.
TEST_P(GhostsKeepTheGeometry, AfterEveryRefinement) {
  const Scheme& scheme = find_scheme("catmull-clark");
  const Case& c = GetParam();
  const BoundaryRule boundary = *c.mesh.tags.boundary;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int level = 0; level <= 2; ++level) {
    const Mesh mesh = refine(c.mesh, scheme, {.levels = level, .boundary = boundary});
    const Adjacency adjacency(mesh.topology);
    const Features features = resolve_tags(adjacency, mesh.tags, boundary);
    const ExtendedMesh extended = with_ghosts(adjacency, features, mesh.points.span());
    if (level == 2) {
      EXPECT_EQ(int(extended.standard_vertices.size()), c.standard);
    }
    const LimitBasis standard(mesh.topology, features, scheme);
    const LimitBasis field(extended.topology, extended.features, scheme);
    const std::vector<Vec3> points = extended.continued(mesh.points.span());
    const LimitSurface a(standard, mesh.points.span());
    const LimitSurface b(field, points);
    for (int f = 0; f < mesh.topology.num_faces(); ++f)
      for (int k = 0; k < 8; ++k) {
        const int corner = k % standard.num_quadrants(FaceId(f));
        const Vec2 uv(unit(random), unit(random));
        EXPECT_LT((a.position(FaceId(f), corner, uv) - b.position(FaceId(f), corner, uv)).norm(),
                  1e-13)
            << "level " << level << " face " << f << " uv " << uv.transpose();
      }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, GhostsKeepTheGeometry,
    ::testing::Values(
        Case{"grid", testing::grid(3, 2, bent), 0}, Case{"one_quad", testing::grid(1, 1, bent), 0},
        Case{"rounded_grid", rounded(testing::grid(3, 2, bent)), 4},
        Case{"rounded_quad", rounded(testing::grid(1, 1, bent)), 4},
        Case{"l_shape_sharp", l_shape(false, true), 0},
        Case{"l_shape_smooth", l_shape(false, false), 1},
        Case{"l_shape_sharp_bent", l_shape(true, true), 1},
        Case{"hole", grid_without(3, 3, {4}, true), 4},
        Case{"two_holes", grid_without(5, 3, {6, 8}, true), 8},
        Case{"kinked_side", kinked_side(), 1}, Case{"crease", creased(infinite_sharpness), 0},
        Case{"semi_sharp", creased(2.5F), 2}, Case{"fan_1", half_fan(1), 0},
        Case{"fan_2", half_fan(2), 0}, Case{"fan_4", half_fan(4), 1}, Case{"fan_7", half_fan(7), 1},
        Case{"pentagon", testing::regular_polygon(5), 0}),
    [](const auto& i) { return i.param.name; });

}  // namespace
}  // namespace limes
