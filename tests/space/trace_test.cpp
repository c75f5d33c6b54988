#include <gtest/gtest.h>

#include <random>

#include "convergence/cells.h"
#include "limes/space/boundary_trace.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

VectorX random_vector(Eigen::Index size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  VectorX out(size);
  for (double& x : out)
    x = value(random);
  return out;
}

double value_on_side(const SubdivisionSpace& space, const VectorX& u, HalfedgeId h, double s) {
  const LimitBasis& field = space.field();
  const FaceId f = field.adjacency().face(h);
  const SidePoint p = side_point(field, h, s);
  BasisAt basis;
  field.evaluate(f, p.corner, p.uv, 0, basis);
  const std::vector<int> dofs = space.face_dofs(f);
  double sum = 0;
  for (std::size_t a = 0; a < dofs.size(); ++a)
    if (dofs[a] >= 0) sum += basis.N(Eigen::Index(a)) * u(dofs[a]);
  return sum;
}

SubdivisionSpace space_of(const Mesh& mesh, int levels, bool ghosts,
                          const std::vector<int>& regions = {}) {
  const BoundaryRule boundary = *mesh.tags.boundary;
  const Scheme& scheme = find_scheme("catmull-clark");
  return {refine(mesh, scheme, {.levels = levels, .boundary = boundary}),
          scheme,
          boundary,
          regions,
          {.ghosts = ghosts, .quadrature = {}}};
}

struct Case {
  std::string name;
  Mesh mesh;
  double tolerance;  ///< of a field of size 1 on sides that are held
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

Mesh ring_without_faces(bool sharp) {
  Mesh mesh = testing::grid(4, 4, [](const Vec2& p) { return Vec2(p.x() + .1 * p.y(), p.y()); });
  std::vector<VertexId> corners;
  for (int f = 0; f < 16; ++f)
    if (f != 5 && f != 6 && f != 15)
      for (const VertexId v : mesh.topology.face(FaceId(f)))
        corners.push_back(v);
  mesh.topology = Topology(mesh.topology.num_vertices(), 4, std::move(corners));
  if (sharp) mesh.tags.corners.push_back({VertexId(18), infinite_sharpness});
  return mesh;
}

class HeldSides : public ::testing::TestWithParam<Case> {};

// A random field that fulfils the constraints of all boundary sides vanishes on them, also between
// the points where it was asked to.
TEST_P(HeldSides, CarryNoValues) {
  const Case& c = GetParam();
  for (const bool ghosts : {true, false}) {
    const SubdivisionSpace space = space_of(c.mesh, 1, ghosts);
    const Adjacency& adjacency = space.geometry().adjacency();
    std::vector<HalfedgeId> sides;
    std::vector<ConstraintRow> rows;
    for (int e = 0; e < adjacency.num_edges(); ++e) {
      if (!adjacency.is_boundary(EdgeId(e))) continue;
      sides.push_back(adjacency.halfedge(EdgeId(e)));
      for (const ConstraintRow& row : trace_of_side(space, sides.back()))
        rows.push_back(row);
    }
    const Elimination fix = eliminate(space.num_dofs(), rows);
    EXPECT_GT(fix.num_free(), 0);
    const VectorX u = fix.T * random_vector(fix.num_free());
    for (const HalfedgeId h : sides)
      for (const double s : {0.0, 0.003, 0.11, 0.37, 0.5, 0.77, 0.98, 1.0})
        EXPECT_NEAR(value_on_side(space, u, h, s), 0, c.tolerance * u.cwiseAbs().maxCoeff())
            << "ghosts " << ghosts << " face " << adjacency.face(h).value << " s " << s;
  }
}

Mesh rounded(Mesh mesh) {
  mesh.tags.boundary = BoundaryRule::edges;
  return mesh;
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, HeldSides,
    ::testing::Values(Case{"grid", testing::grid(3, 3, [](const Vec2& p) { return p; }), 1e-12},
                      Case{"rounded", rounded(testing::grid(3, 3, [](const Vec2& p) { return p; })),
                           1e-9},
                      Case{"hole_and_step", ring_without_faces(false), 1e-9},
                      Case{"sharp_step", ring_without_faces(true), 1e-9},
                      Case{"cell", testing::CircleCell(16, 2, false).mesh(), 1e-9}),
    [](const auto& i) { return i.param.name; });

// Fields of two regions have equal values on both sides of their border, and are not forced to more:
// the normal derivative may jump.
TEST(Regions, AreContinuousAndMayKink) {
  const Mesh mesh = testing::CircleCell(16, 4, true).mesh();
  std::vector<int> regions(std::size_t(mesh.topology.num_faces()), 0);
  for (const FaceId f : mesh.groups[0].faces)
    regions[std::size_t(f.value)] = 1;
  const SubdivisionSpace space = space_of(mesh, 0, true, regions);
  const Elimination fix = eliminate(space.num_dofs(), continuity(space));
  const VectorX u = fix.T * random_vector(fix.num_free());
  const Adjacency& adjacency = space.geometry().adjacency();
  int borders = 0;
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    const HalfedgeId twin = adjacency.twin(h);
    if (!twin.valid() || space.region(adjacency.face(h)) == space.region(adjacency.face(twin)))
      continue;
    ++borders;
    for (const double s : {0.0, 0.13, 0.5, 0.9})
      EXPECT_NEAR(value_on_side(space, u, h, s), value_on_side(space, u, twin, 1 - s), 1e-12);
  }
  EXPECT_EQ(borders, 16);
  const SubdivisionSpace smooth = space_of(mesh, 0, true);
  // Normal derivatives of value and slope may jump at each of the 16 border vertices; the value may
  // not.
  EXPECT_EQ(fix.num_free(), smooth.num_dofs() + 2 * 16);
}

// The field whose coefficients are positions is the geometry, in every region.
TEST(Regions, KeepTheGeometry) {
  const Mesh mesh = testing::CircleCell(16, 4, true).mesh();
  std::vector<int> regions(std::size_t(mesh.topology.num_faces()), 0);
  for (const FaceId f : mesh.groups[0].faces)
    regions[std::size_t(f.value)] = 1;
  const SubdivisionSpace space = space_of(mesh, 1, true, [&] {
    std::vector<int> fine;
    for (const int r : regions)
      fine.insert(fine.end(), 4, r);
    return fine;
  }());
  const auto x = space.position_coefficients();
  for (int e = 0; e < int(space.elements().size()); ++e) {
    const ElementTable& table = space.table(space.elements()[std::size_t(e)].shape);
    const auto dofs = space.dofs(e);
    Eigen::Matrix<double, Eigen::Dynamic, 3> c(Eigen::Index(dofs.size()), 3);
    for (std::size_t a = 0; a < dofs.size(); ++a)
      c.row(Eigen::Index(a)) = x.row(dofs[a]);
    EXPECT_LT((table.N * c - table.G * space.control_points(e)).cwiseAbs().maxCoeff(), 1e-13);
  }
}

}  // namespace
}  // namespace limes
