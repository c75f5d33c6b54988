#include "limes/limit/closest_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limit/nearest_by_sampling.h"
#include "limit/surface.h"
#include "limit/zoo.h"

// Closest points against exact ones, against sampling with a search that uses values only, and
// against the conditions for a minimum.

namespace limes::test {
namespace {

double size_of(const Surface& s) {
  Vec3 lower = s.model.points[0], upper = lower;
  for (const Vec3& x : s.model.points) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  return (upper - lower).norm();
}

/// Random points: around the surface, at it, far from it.
std::vector<Vec3> queries_for(const Surface& s, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto vector = [&]() -> Vec3 {
    return Vec3(unit(random), unit(random), unit(random)) * 2 - Vec3::Ones();
  };
  const double size = size_of(s);
  std::vector<Vec3> queries;
  for (int i = 0; i < count; ++i) {
    const FaceId f(
        static_cast<std::int64_t>(random() % static_cast<unsigned>(s.model.topology.num_faces())));
    const int corner = static_cast<int>(random() % static_cast<unsigned>(s.basis.num_quadrants(f)));
    const Vec3 x = s.limit.position(f, corner, {unit(random), unit(random)});
    const double away = std::array{1e-6, 1e-3, 0.1, 1.0, 30.0}[static_cast<std::size_t>(i % 5)];
    queries.push_back(x + away * size * vector());
  }
  return queries;
}

/// What any hit must fulfil by itself.
void expect_consistent(const Surface& s, const Vec3& q, const ClosestHit& hit, double size) {
  const Vec3 there = s.limit.position(hit.face, hit.corner, hit.uv);
  EXPECT_LE((there - hit.point).norm(), 1e-12 * size);
  EXPECT_NEAR((q - hit.point).norm(), hit.distance, 1e-15 * (size + 4 * hit.distance));
}

class ClosestOnEveryShape : public testing::TestWithParam<Shape> {};

TEST_P(ClosestOnEveryShape, NoSampledPointIsCloser) {
  const Surface s(GetParam().mesh, GetParam().boundary);
  const SurfaceTree tree(s.basis, s.model.points);
  const NearestBySampling sampled(s.limit);
  const double size = size_of(s);
  for (const Vec3& q : queries_for(s, 25, 3)) {
    const ClosestHit hit = closest_point(tree, q);
    expect_consistent(s, q, hit, size);
    const double other = sampled.distance(q);
    EXPECT_LE(hit.distance, other + 1e-12 * size + 1e-15 * other);
    EXPECT_NEAR(hit.distance, other, 1e-3 * size);  // the samples come close themselves
  }
}

INSTANTIATE_TEST_SUITE_P(, ClosestOnEveryShape, testing::ValuesIn(limit_shapes()),
                         [](const auto& test) { return test.param.name; });

/// At a minimum inside a face the way to q is normal to both tangents; at a side of a boundary face
/// only the component across may remain, and it points inwards.
TEST(ClosestPoint, FulfilsTheConditionsForAMinimum) {
  Mesh mesh = shapes::grid(6, 5);
  perturb(mesh, 0.2);
  const Surface s(mesh);
  const SurfaceTree tree(s.basis, s.model.points);
  int inside = 0, on_boundary = 0;
  for (const Vec3& q : queries_for(s, 500, 11)) {
    const ClosestHit hit = closest_point(tree, q);
    const SurfacePoint p = s.limit.evaluate(hit.face, hit.corner, hit.uv);
    const Vec3 r = p.x - q;
    const auto corners = mesh.topology.face(hit.face);
    const auto is_boundary_side = [&](std::size_t a, std::size_t b) {
      for (int f = 0; f < mesh.topology.num_faces(); ++f)
        for (std::size_t i = 0; i < 4; ++i) {
          const auto other = mesh.topology.face(FaceId(f));
          if (other[i] == corners[b] && other[(i + 1) % 4] == corners[a]) return false;
        }
      return true;
    };
    // direction: d/du or d/dv; the sides at its two ends
    const auto check = [&](double at, const Vec3& d, bool lower_is_boundary,
                           bool upper_is_boundary) {
      const double slope = r.dot(d) / ((r.norm() + d.norm()) * d.norm());
      if (at == 0 && lower_is_boundary) {
        ++on_boundary;
        EXPECT_GE(slope, -1e-12);
      } else if (at == 1 && upper_is_boundary) {
        ++on_boundary;
        EXPECT_LE(slope, 1e-12);
      } else {
        ++inside;
        EXPECT_NEAR(slope, 0, 1e-12);
      }
    };
    check(hit.uv.x(), p.first->xu, is_boundary_side(3, 0), is_boundary_side(1, 2));
    check(hit.uv.y(), p.first->xv, is_boundary_side(0, 1), is_boundary_side(2, 3));
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(on_boundary, 100);
}

/// A plane rectangle: its limit with corners is the rectangle, so that the answer is a clamp.
TEST(ClosestPoint, OnARectangleIsTheProjection) {
  const Mesh mesh = shapes::grid(7, 4);
  const Surface s(mesh, BoundaryRule::edges_and_corners);
  const SurfaceTree tree(s.basis, s.model.points);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-3, 10);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 q(unit(random), unit(random), unit(random) * std::pow(10.0, -i % 12));
    const Vec3 exact(std::clamp(q.x(), 0.0, 7.0), std::clamp(q.y(), 0.0, 4.0), 0);
    const ClosestHit hit = closest_point(tree, q);
    EXPECT_LE((hit.point - exact).norm(), 1e-13);
    EXPECT_NEAR(hit.distance, (q - exact).norm(), 1e-13);
    const VertexId first = mesh.topology.face(hit.face)[0];
    EXPECT_NEAR(hit.uv.x(), exact.x() - mesh.points[first].x(), 1e-13);
    EXPECT_NEAR(hit.uv.y(), exact.y() - mesh.points[first].y(), 1e-13);
  }
}

/// From far away the distance has fewer digits than the surface has; the point keeps them.
TEST(ClosestPoint, FarAwayIsASupportingPoint) {
  Mesh mesh = shapes::torus(8, 6);
  const Surface s(mesh);
  const SurfaceTree tree(s.basis, s.model.points);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 direction = Vec3(unit(random), unit(random), unit(random)).normalized();
    double previous = 0;
    for (const double far : {1e6, 1e12, 1e150, 1e300}) {
      const ClosestHit hit = closest_point(tree, far * direction);
      const SurfacePoint p = s.limit.evaluate(hit.face, hit.corner, hit.uv);
      EXPECT_LE((p.x - hit.point).norm(), 1e-13);
      EXPECT_NEAR((far * direction - hit.point).stableNorm() / hit.distance, 1, 1e-15);
      // normal to the way there, which is `direction` up to size / far
      const Vec3 away = (direction - hit.point / far).normalized();
      EXPECT_NEAR(p.normal->dot(away), 1, 1e-13);
      // the support function is the same from all distances
      const double support = hit.point.dot(direction);
      if (previous != 0) {
        EXPECT_NEAR(support, previous, 1e-6);
      }
      previous = support;
      for (const Vec3& x : s.model.points)
        EXPECT_LE(s.limit.position(hit.face, hit.corner, hit.uv).dot(direction) - support, 1e-13)
            << x;
    }
  }
}

TEST(ClosestPoint, OnVerticesTheDistanceIsZero) {
  for (const int n : {3, 5, 8, 20}) {
    Mesh mesh = shapes::disk(n, 2);
    perturb(mesh, 0.1);
    const Surface s(mesh);
    const SurfaceTree tree(s.basis, s.model.points);
    const auto limits = limit_positions(s.limit, s.model.points);
    for (int v = 0; v < limits.size(); ++v) {
      const ClosestHit hit = closest_point(tree, limits[VertexId(v)]);
      EXPECT_LE(hit.distance, 1e-14) << n << " " << v;
      // the lowest face of those around it
      FaceId lowest;
      for (int f = 0; f < mesh.topology.num_faces() && !lowest.valid(); ++f)
        for (const VertexId corner : mesh.topology.face(FaceId(f)))
          if (corner == VertexId(v)) lowest = FaceId(f);
      EXPECT_EQ(hit.face, lowest) << n << " " << v;
    }
  }
}

/// Above an extraordinary vertex of a convex cap, along its normal, the vertex is the closest point.
TEST(ClosestPoint, AboveAnExtraordinaryVertexIsTheVertex) {
  for (const int n : {3, 5, 7, 12}) {
    Mesh mesh = shapes::disk(n, 2);
    for (Vec3& x : mesh.points)
      x.z() = -0.3 * x.squaredNorm();
    const Surface s(mesh);
    const SurfaceTree tree(s.basis, s.model.points);
    const Vec3 top = s.limit.position(FaceId(0), 0, {0, 0});
    for (const double height : {1e-9, 1e-3, 0.5, 1e3}) {
      const ClosestHit hit = closest_point(tree, top + Vec3(0, 0, height));
      EXPECT_LE((hit.point - top).norm(), 1e-6) << n << " " << height;
      EXPECT_NEAR(hit.distance, height, 1e-13 * (1 + height));
    }
  }
}

/// The middle of a cube's limit is as far from all six faces: one of face 0.
TEST(ClosestPoint, OnTheMedialAxisTheLowestFaceWins) {
  const Surface s(shapes::cube());
  const SurfaceTree tree(s.basis, s.model.points);
  const ClosestHit middle = closest_point(tree, Vec3::Zero());
  EXPECT_EQ(middle.face, FaceId(0));
  // the closest are the cube's corners: (5/18 ... ) compare with sampling
  EXPECT_NEAR(middle.distance, NearestBySampling(s.limit).distance(Vec3::Zero()), 1e-9);
  expect_consistent(s, Vec3::Zero(), middle, 4);

  // On the axis of a torus whole circles are equally close, to the spline's deviation from them.
  const Surface torus(shapes::torus(24, 12));
  const SurfaceTree torus_tree(torus.basis, torus.model.points);
  const ClosestHit hit = closest_point(torus_tree, Vec3::Zero());
  EXPECT_NEAR(hit.distance, NearestBySampling(torus.limit).distance(Vec3::Zero()), 1e-9);
}

TEST(ClosestPoint, OfDegenerateSurfaces) {
  // flat, folded into a segment, into a point
  for (const int rank : {2, 1, 0}) {
    Mesh mesh = shapes::cube();
    for (Vec3& x : mesh.points)
      for (int d = rank; d < 3; ++d)
        x[d] = 0.25;
    const Surface s(mesh);
    const SurfaceTree tree(s.basis, s.model.points);
    const NearestBySampling sampled(s.limit);
    for (const Vec3& q :
         {Vec3(0.1, 0.2, 0.7), Vec3(2, 0.1, 0.2), Vec3(-3, 4, 1e9), Vec3(0.1, 0.25, 0.25)}) {
      const ClosestHit hit = closest_point(tree, q);
      EXPECT_LE(hit.distance, sampled.distance(q) * (1 + 1e-15) + 1e-12) << rank;
      expect_consistent(s, q, hit, 4);
    }
  }
  // faces with a collapsed side: a pole where all columns of a grid end
  Mesh mesh = shapes::grid(5, 5);
  for (int i = 0; i <= 5; ++i)
    mesh.points[VertexId(i)] = Vec3(2.5, 0, 1);
  const Surface s(mesh);
  const SurfaceTree tree(s.basis, s.model.points);
  const NearestBySampling sampled(s.limit);
  for (const Vec3& q : queries_for(s, 50, 2)) {
    const ClosestHit hit = closest_point(tree, q);
    EXPECT_LE(hit.distance, sampled.distance(q) + 1e-11);
  }
  EXPECT_NEAR(closest_point(tree, {2.5, -1, 1}).distance, 1, 1e-12);
}

TEST(ClosestPoint, WorksAtAnyScaleAndPlace) {
  Mesh mesh = shapes::disk(5, 2);
  perturb(mesh, 0.2);
  const Surface s(mesh);
  const SurfaceTree tree(s.basis, s.model.points);
  for (const double scale : {0x1p-600, 0x1p-40, 0x1p700}) {
    Mesh other = mesh;
    for (Vec3& x : other.points)
      x *= scale;
    const Surface o(other);
    const SurfaceTree other_tree(o.basis, o.model.points);
    for (const Vec3& q : queries_for(s, 20, 4)) {
      const ClosestHit a = closest_point(tree, q);
      const ClosestHit b = closest_point(other_tree, q * scale);
      EXPECT_EQ(a.face, b.face);
      EXPECT_EQ(a.uv, b.uv);
      EXPECT_EQ(a.point * scale, b.point);
      EXPECT_EQ(a.distance * scale, b.distance);
    }
  }
}

TEST(ClosestPoint, OnTriangleMeshesAndRefinedModels) {
  for (Mesh mesh : {shapes::icosahedron(),
                    refine(shapes::tetrahedron(), find_scheme("catmull-clark"), {.levels = 2})}) {
    perturb(mesh, 0.05);
    const Surface s(mesh);
    const SurfaceTree tree(s.basis, s.model.points);
    const NearestBySampling sampled(s.limit);
    for (const Vec3& q : queries_for(s, 100, 9)) {
      const ClosestHit hit = closest_point(tree, q);
      expect_consistent(s, q, hit, 4);
      EXPECT_LE(hit.distance, sampled.distance(q) + 1e-12);
    }
  }
}

/// The bilinear scheme's surfaces are the faces themselves.
TEST(ClosestPoint, OfBilinearFaces) {
  const Model model = make_model(shapes::cube());
  const LimitBasis basis(model.topology, model.features, find_scheme("linear"));
  const SurfaceTree tree(basis, model.points);
  const ClosestHit hit = closest_point(tree, {0.3, -0.2, 2});
  EXPECT_LE((hit.point - Vec3(0.3, -0.2, 1)).norm(), 1e-15);
  EXPECT_LE((closest_point(tree, {5, 5, 5}).point - Vec3(1, 1, 1)).norm(), 1e-15);
}

TEST(ClosestPoint, SearchesTheGivenFacesOnly) {
  const Surface s(shapes::cube());
  const std::vector<FaceId> faces{FaceId(2)};
  const SurfaceTree tree(s.basis, s.model.points, faces);
  for (const Vec3& q : queries_for(s, 10, 6))
    EXPECT_EQ(closest_point(tree, q).face, FaceId(2));
}

/// Many at once are bitwise the same as one by one, whatever the threads do.
TEST(ClosestPoint, InBulkIsBitwiseTheSame) {
  Mesh mesh = shapes::torus(12, 8);
  perturb(mesh, 0.1);
  const Surface s(mesh);
  const SurfaceTree tree(s.basis, s.model.points);
  const auto queries = queries_for(s, 5000, 12);
  const auto hits = closest_points(tree, queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const ClosestHit one = closest_point(tree, queries[i]);
    EXPECT_EQ(hits[i].face, one.face);
    EXPECT_EQ(hits[i].uv, one.uv);
    EXPECT_EQ(hits[i].point, one.point);
    EXPECT_EQ(hits[i].distance, one.distance);
  }
}

TEST(ClosestPoint, RefusesWhatIsNoPoint) {
  const Surface s(shapes::cube());
  const SurfaceTree tree(s.basis, s.model.points);
  const double nan = std::nan("");
  const std::vector<Vec3> queries{{0, 0, 0}, {0, 0, 0}, {0, nan, 0}};
  try {
    (void)closest_points(tree, queries);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()), "query 2: (0, nan, 0) is no point; finite numbers are right");
  }
  EXPECT_THROW((void)closest_point(tree, {INFINITY, 0, 0}), InputError);
  EXPECT_THROW(SurfaceTree(s.basis, s.model.points, std::vector<FaceId>()), InputError);
  auto points = s.model.points;
  points[3].y() = nan;
  EXPECT_THROW(SurfaceTree(s.basis, points), InputError);
}

}  // namespace
}  // namespace limes::test
