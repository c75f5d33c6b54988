#include <gtest/gtest.h>

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/quasi_four_eight.h"
#include "subdiv/golden48.h"
#include "subdiv/meshes48.h"
#include "subdiv/sectors.h"
#include "subdiv/zoo.h"

// Smoothing of quasi 4-8: weights, spectrum, boundaries, tags.

namespace limes {
namespace {

std::vector<Vec3> smoothed(const Topology& parent, const Bisection& step,
                           const std::vector<Vec3>& coarse) {
  std::vector<Vec3> fine(static_cast<std::size_t>(step.child.num_vertices()));
  quasi_smoothing(Adjacency(parent), step, {}, {}, coarse, fine);
  return fine;
}

std::vector<Vec3> two_steps(const Sectors& pattern, const std::vector<Vec3>& coarse) {
  return smoothed(pattern.first().child, pattern.second(),
                  smoothed(pattern.coarse(), pattern.first(), coarse));
}

/// Reference 2.4: subdominant eigenvalues of two steps around a vertex with n sectors.
TEST(QuasiSmoothing, SubdominantEigenvaluesOfTheStationaryPattern) {
  const std::vector<std::pair<int, double>> expected{
      {3, 0.405113181}, {4, 0.5},         {5, 0.554871875},  {6, 0.588072039},  {7, 0.609333667},
      {8, 0.623654849}, {9, 0.633716807}, {10, 0.641037632}, {11, 0.646521347}, {12, 0.650730725}};
  for (const auto& [n, lambda] : expected) {
    SCOPED_TRACE(n);
    const Sectors pattern(n, 5);
    const auto values = eigenvalues(
        pattern.matrix(3, [&](const std::vector<Vec3>& x) { return two_steps(pattern, x); }));
    EXPECT_NEAR(values[0], 1, 1e-12);
    EXPECT_NEAR(values[1], lambda, 1e-8);
    EXPECT_NEAR(values[2], lambda, 1e-8);
    EXPECT_LT(values[3], lambda - 0.05);
  }
}

/// Reference 2.3: 1, 1/2 twice, 1/4 three times, 1/8 four times, then 0.1122440544.
TEST(QuasiSmoothing, RegularSpectrumReproducesCubics) {
  const Sectors pattern(4, 5);
  const auto values = eigenvalues(
      pattern.matrix(3, [&](const std::vector<Vec3>& x) { return two_steps(pattern, x); }));
  const std::vector<double> expected{1,     0.5,   0.5,   0.25,  0.25,        0.25,
                                     0.125, 0.125, 0.125, 0.125, 0.1122440544};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(values[i], expected[i], i < 6 ? 1e-8 : 1e-6) << i;
}

/// Figure 4: a new vertex 4 x 1/4; an old one 5/8, 1/16 and 1/32 for its nearest and diagonal
/// neighbours.
TEST(QuasiSmoothing, WeightsInARegularRegion) {
  const Sectors pattern(4, 3);
  const auto weights_of = [&](int row) {
    std::vector<double> weights;
    for (int v = 0; v < pattern.coarse().num_vertices(); ++v) {
      std::vector<Vec3> impulse(static_cast<std::size_t>(pattern.coarse().num_vertices()),
                                Vec3::Zero());
      impulse[static_cast<std::size_t>(v)].x() = 1;
      const double w =
          smoothed(pattern.coarse(), pattern.first(), impulse)[static_cast<std::size_t>(row)].x();
      if (w != 0) weights.push_back(w);
    }
    std::sort(weights.begin(), weights.end());
    return weights;
  };
  const std::vector<double> old{1. / 32, 1. / 32, 1. / 32, 1. / 32, 1. / 16,
                                1. / 16, 1. / 16, 1. / 16, 5. / 8};
  EXPECT_EQ(weights_of(0), old);  // valence 8
  const Adjacency mesh(pattern.coarse());
  const HalfedgeId out = mesh.ring_start(VertexId(0));
  const int neighbour =
      (mesh.valence(mesh.to(out)) == 4 ? mesh.to(out) : mesh.to(mesh.ring_next(out))).value;
  ASSERT_EQ(mesh.valence(VertexId(neighbour)), 4);
  EXPECT_EQ(weights_of(neighbour), old);
  for (const EdgeId e : edges_between_valence_8(mesh))
    if (mesh.from(mesh.halfedge(e)) == VertexId(0)) {
      EXPECT_EQ(weights_of(pattern.first().middle[e].value), std::vector<double>(4, 0.25));
    }
}

Mesh random_bumps(Mesh mesh, double size) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-size, size);
  for (Vec3& x : mesh.points)
    x += Vec3(shift(random), shift(random), shift(random));
  return mesh;
}

TEST(QuasiSmoothing, CommutesWithSimilarities) {
  const Mat3 R(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix());
  for (const Mesh& mesh : {random_bumps(shapes::icosahedron(), 0.1),
                           random_bumps(triangulated(shapes::grid_with_hole(5)), 0.1)}) {
    const auto map = [&](const Vec3& x) -> Vec3 { return 3.7 * R * x + Vec3(4, -2, 9); };
    Mesh moved = mesh;
    for (Vec3& x : moved.points)
      x = map(x);
    const Mesh fine = refine_quasi_four_eight(mesh, {.levels = 4}).mesh;
    const Mesh fine_moved = refine_quasi_four_eight(moved, {.levels = 4}).mesh;
    ASSERT_EQ(fine.topology, fine_moved.topology);
    for (int v = 0; v < fine.points.size(); ++v)
      EXPECT_LE((map(fine.points[VertexId(v)]) - fine_moved.points[VertexId(v)]).norm(), 1e-12);
  }
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto face = mesh.topology.face(FaceId(f));
    sum += mesh.points[face[0]].dot(mesh.points[face[1]].cross(mesh.points[face[2]])) / 6;
  }
  return sum;
}

TEST(QuasiSmoothing, VolumeOfTheOctahedron) {
  const auto files = golden48::read("quasi48_octahedron");
  ASSERT_EQ(files.size(), 1U);
  const Mesh& mesh = files[0].input.mesh;
  const QuasiRefinement result = refine_quasi_four_eight(mesh, {.levels = 10});
  EXPECT_NEAR(volume(result.mesh) / volume(mesh), 0.024882, 5e-7);
  EXPECT_FALSE(result.collapsed);
}

TEST(QuasiSmoothing, TheTetrahedronCollapsesAndIsSaidTo) {
  for (int levels = 1; levels <= 6; ++levels) {
    const QuasiRefinement result =
        refine_quasi_four_eight(shapes::tetrahedron(), {.levels = levels});
    EXPECT_TRUE(result.collapsed);
    EXPECT_NEAR(volume(result.mesh), 0, 1e-14);
    for (const Vec3& x : result.mesh.points)
      EXPECT_TRUE(x.allFinite());
  }
}

TEST(QuasiSmoothing, StaysInTheConvexHull) {
  const Mesh mesh = random_bumps(shapes::icosahedron(), 0.2);
  const Mesh fine = refine_quasi_four_eight(mesh, {.levels = 6}).mesh;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Vec3 direction(normal(random), normal(random), normal(random));
    double outer = -1e300, inner = -1e300;
    for (const Vec3& x : mesh.points)
      outer = std::max(outer, direction.dot(x));
    for (const Vec3& x : fine.points)
      inner = std::max(inner, direction.dot(x));
    EXPECT_LE(inner, outer + 1e-12);
  }
}

/// The largest turn of the boundary at some of its vertices, in degrees.
std::vector<double> boundary_turns(const Mesh& mesh, const std::vector<int>& vertices) {
  const Adjacency adjacency(mesh.topology);
  std::vector<double> turns;
  for (const int v : vertices) {
    HalfedgeId last = adjacency.ring_start(VertexId(v));
    while (adjacency.ring_next(last).valid())
      last = adjacency.ring_next(last);
    const Vec3 x = mesh.points[VertexId(v)];
    const Vec3 in = x - mesh.points[adjacency.from(adjacency.prev(last))];
    const Vec3 out = mesh.points[adjacency.to(adjacency.ring_start(VertexId(v)))] - x;
    turns.push_back(std::atan2(in.cross(out).norm(), in.dot(out)) * 180 / std::numbers::pi);
  }
  return turns;
}

Mesh tube(const char* tags) {
  return golden48::read(std::string("quasi48_box_tube_") + tags).at(0).input.mesh;
}

/// Reference 2.5, Figure 11(c): boundary smooth but for the vertex of the tagged edge.
TEST(QuasiSmoothing, BoundaryOfTheTubeOfFigure11) {
  struct Row {
    QuasiBoundary boundary;
    std::vector<double> turns;  // after 2, 4, ... steps
    double tolerance;
  };
  const std::vector<Row> rows{{QuasiBoundary::curve_normal, {53, 28, 14.8, 8.3, 5.6}, 0.5},
                              {QuasiBoundary::curve, {53.13, 28.07, 14.25, 7.15, 3.58}, 0.005},
                              {QuasiBoundary::fixed, {90, 90, 90, 90, 90}, 1e-9}};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.turns.size(); ++i) {
      const Mesh fine =
          refine_quasi_four_eight(tube("edge_tagged"), {.levels = 2 * static_cast<int>(i + 1),
                                                        .rules = {.boundary = row.boundary}})
              .mesh;
      const auto turns = boundary_turns(fine, {1, 2, 3, 5, 6, 7});
      EXPECT_NEAR(*std::max_element(turns.begin(), turns.end()), row.turns[i],
                  i < 2 ? row.tolerance : std::min(row.tolerance, 0.05));
      for (const double turn : boundary_turns(fine, {0, 4}))
        EXPECT_NEAR(turn, 90, 1e-9);
    }
}

TEST(QuasiSmoothing, TaggedVerticesKeepTheirBits) {
  for (const char* tags : {"boundary_tagged", "edge_tagged"}) {
    const Mesh mesh = tube(tags);
    const Mesh fine = refine_quasi_four_eight(mesh, {.levels = 7}).mesh;
    for (const CreaseTag& t : mesh.tags.creases)
      for (const VertexId v : {t.a, t.b})
        EXPECT_EQ(fine.points[v], mesh.points[v]);
    // Tagged edges stay straight: their halves are exact middles of middles.
    for (const CreaseTag& t : fine.tags.creases) {
      const Vec3 a = fine.points[t.a], b = fine.points[t.b];
      EXPECT_EQ((a - b).cwiseAbs().maxCoeff(), (a - b).norm());  // along an axis
    }
  }
}

TEST(QuasiSmoothing, TheBoundaryOfAFlatSurfaceStays) {
  Mesh mesh = triangulated(shapes::grid_with_hole(5));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  for (Vec3& x : mesh.points)
    x += Vec3(shift(random), shift(random), 0);
  const Mesh fine = refine_quasi_four_eight(mesh, {.levels = 4}).mesh;
  const Adjacency adjacency(mesh.topology);
  for (int v = 0; v < mesh.points.size(); ++v)
    if (adjacency.is_boundary(VertexId(v))) {
      EXPECT_EQ(fine.points[VertexId(v)], mesh.points[VertexId(v)]);
    }
}

/// One split of a polyline as cubic B-splines do it: (1 6 1) / 8 and middles.
std::vector<Vec3> refined_curve(const std::vector<Vec3>& curve, bool closed) {
  std::vector<Vec3> fine;
  const std::size_t n = curve.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool end = !closed && (i == 0 || i + 1 == n);
    const Vec3& x = curve[i];
    fine.push_back(end ? x
                       : Vec3(0.75 * x + 0.125 * (curve[(i + n - 1) % n] + curve[(i + 1) % n])));
    if (closed || i + 1 < n) fine.push_back(0.5 * (x + curve[(i + 1) % n]));
  }
  return fine;
}

/// The vertices from a to b along tagged edges.
std::vector<Vec3> tagged_curve(const Mesh& mesh, VertexId a, VertexId b) {
  std::vector<Vec3> curve{mesh.points[a]};
  VertexId before, at = a;
  while (at != b) {
    VertexId next;
    for (const CreaseTag& t : mesh.tags.creases) {
      if (t.a == at && t.b != before) next = t.b;
      if (t.b == at && t.a != before) next = t.a;
    }
    if (!next.valid()) break;
    before = at;
    at = next;
    curve.push_back(mesh.points[at]);
  }
  return curve;
}

/// Tags as curves: a crease through a regular 4-8 grid, split every second step, is the cubic
/// B-spline of its vertices.
TEST(QuasiSmoothing, CreasesAreCubicBSplines) {
  Mesh mesh = centre_triangles(shapes::grid(4, 4));
  mesh.points[VertexId(7)].z() = 0.1;
  mesh.points[VertexId(12)].z() = -0.2;
  mesh.points[VertexId(17)].z() = 0.3;
  for (int i = 0; i < 4; ++i)
    mesh.tags.creases.push_back({VertexId(2 + 5 * i), VertexId(7 + 5 * i), infinite_sharpness});
  const QuasiOptions options{.levels = 4, .rules = {.tags = QuasiTags::curves}};
  const Mesh fine = refine_quasi_four_eight(mesh, options).mesh;
  std::vector<Vec3> expected = tagged_curve(mesh, VertexId(2), VertexId(22));
  ASSERT_EQ(expected.size(), 5U);
  expected = refined_curve(refined_curve(expected, false), false);
  const std::vector<Vec3> made = tagged_curve(fine, VertexId(2), VertexId(22));
  ASSERT_EQ(made.size(), expected.size());
  for (std::size_t i = 0; i < made.size(); ++i)
    EXPECT_LE((made[i] - expected[i]).norm(), 1e-14);
}

TEST(QuasiSmoothing, DartsAreSmoothAndCornersStay) {
  const Mesh start = random_bumps(shapes::icosahedron(), 0.05);
  const Adjacency adjacency(start.topology);
  const HalfedgeId h = adjacency.halfedge(longest_edges(adjacency, start.points.span()).at(0));
  const VertexId foot = adjacency.from(h), tip = adjacency.to(h);
  const QuasiOptions curves{.levels = 1, .rules = {.tags = QuasiTags::curves}};
  const Mesh smooth = refine_quasi_four_eight(start, curves).mesh;

  // One tagged edge makes both ends darts: they move as before, pulled by a middle that lies on the
  // edge now.
  Mesh dart = start;
  dart.tags.creases = {{foot, tip, infinite_sharpness}};
  const Mesh made = refine_quasi_four_eight(dart, curves).mesh;
  ASSERT_EQ(made.topology, smooth.topology);
  const VertexId middle = made.tags.creases.at(0).b;
  EXPECT_EQ(made.points[middle], 0.5 * (start.points[foot] + start.points[tip]));
  const Adjacency fine(made.topology);
  for (const VertexId v : {foot, tip}) {
    int k = 0;  // new vertices around v
    for (int w = start.points.size(); w < made.points.size(); ++w)
      k += find_edge(fine, v, VertexId(w)).valid() ? 1 : 0;
    const Vec3 pull = (made.points[middle] - smooth.points[middle]) / (2.0 * k);
    EXPECT_GT(pull.norm(), 1e-3);
    EXPECT_LE((made.points[v] - smooth.points[v] - pull).norm(), 1e-15);
  }

  Mesh corner = start;
  corner.tags.corners = {{foot, infinite_sharpness}};
  EXPECT_EQ(refine_quasi_four_eight(corner, curves).mesh.points[foot], start.points[foot]);
  Mesh three = start;  // three tagged edges
  HalfedgeId out = h;
  for (int i = 0; i < 3; ++i, out = adjacency.ring_next(out))
    three.tags.creases.push_back({foot, adjacency.to(out), infinite_sharpness});
  EXPECT_EQ(refine_quasi_four_eight(three, curves).mesh.points[foot], start.points[foot]);
}

TEST(QuasiSmoothing, SemiSharpTagsEnd) {
  Mesh mesh = centre_triangles(shapes::grid(4, 4));
  mesh.points[VertexId(12)].z() = 0.2;
  const auto with_crease = [&](float sharpness, int levels) {
    Mesh tagged = mesh;
    for (int i = 0; i < 4; ++i)
      tagged.tags.creases.push_back({VertexId(2 + 5 * i), VertexId(7 + 5 * i), sharpness});
    return refine_quasi_four_eight(tagged, {.levels = levels, .rules = {.tags = QuasiTags::curves}})
        .mesh;
  };
  EXPECT_EQ(with_crease(10, 1).tags.creases.size(), 8U);  // the first step splits it
  EXPECT_EQ(with_crease(1, 1).tags.creases.size(), 0U);
  EXPECT_EQ(with_crease(1, 1).points, with_crease(10, 1).points);
  EXPECT_NE(with_crease(1, 2).points, with_crease(10, 2).points);

  mesh.tags.corners = {{VertexId(12), 1.0F}};  // for two steps
  for (int levels = 1; levels <= 3; ++levels) {
    const Mesh fine = refine_quasi_four_eight(mesh, {.levels = levels}).mesh;
    EXPECT_EQ(fine.points[VertexId(12)] == mesh.points[VertexId(12)], levels <= 2);
    EXPECT_EQ(fine.tags.corners.size(), levels < 2 ? 1U : 0U);
  }
}

#ifdef LIMES_WITH_TBB
TEST(QuasiSmoothing, TheBitsDoNotDependOnThreads) {
  const Mesh mesh = random_bumps(triangulated(shapes::grid_with_hole(9)), 0.2);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return refine_quasi_four_eight(mesh, {.levels = 8}).mesh;
  };
  const Mesh one = run(1), two = run(2);
  EXPECT_EQ(one.topology, two.topology);
  EXPECT_EQ(one.points, two.points);
}
#endif

}  // namespace
}  // namespace limes
