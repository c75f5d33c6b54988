#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "limes/limit/limit_surface.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "limit/surface.h"
#include "limit/zoo.h"

// Derivatives by finite differences, continuity across borders, exactness on planes and known
// curvatures.

namespace limes::test {
namespace {

/// The size of the dyadic tile around a point whose border is at least a quarter of it away, and
/// that is far enough from corner 0 to lie in one patch: between 2^-(k+1) and 2^-k from it.
struct Tile {
  Vec2 middle;
  double width;
};

/// Middle of tile 1, 2 or 3 of ring k around corner 0 (see RingKind): [1/2, 1] x [0, 1/2] and so on
/// times 2^(1-k). In a triangle tile 3 is the one in the middle, upside down.
Tile ring_tile(int k, int child, bool triangle) {
  const double w = std::ldexp(1.0, -k);
  if (triangle) {
    const std::array<Vec2, 3> middle{Vec2(4, 1), Vec2(1, 4), Vec2(2, 2)};
    return {w / 3 * middle[static_cast<std::size_t>(child - 1)], w / 2};
  }
  const std::array<Vec2, 3> origin{Vec2(w, 0), Vec2(w, w), Vec2(0, w)};
  return {origin[static_cast<std::size_t>(child - 1)] + Vec2(0.5 * w, 0.5 * w), w};
}

/// First and second derivatives of a polynomial of degree <= 4 from five points, exactly.
struct Differences {
  Vec3 first, second;
};
template <class F>
Differences differences(const F& f, double h) {
  const Vec3 a = f(-2 * h), b = f(-h), c = f(0), d = f(h), e = f(2 * h);
  return {(8 * (d - b) - (e - a)) / (12 * h), (16 * (d + b) - (e + a) - 30 * c) / (12 * h * h)};
}

class DerivativesOf : public testing::TestWithParam<Shape> {};

/// In the tiles of rings 3, 6 and 10 around corner 0 the surface of a face is one polynomial of degree
/// 3 or 4, so that five-point differences are exact but for rounding, which grows like 1/width.
TEST_P(DerivativesOf, EqualDifferencesInsideTiles) {
  const Surface s(GetParam());
  for (int f = 0; f < std::min(4, s.model.topology.num_faces()); ++f) {
    for (const int ring : {3, 6, 10}) {
      for (int child = 1; child <= 3; ++child) {
        const Tile tile = ring_tile(ring, child, s.basis.on_triangles());
        const FaceId face(f);
        const auto at = [&](double du, double dv) {
          return s.limit.position(face, 0, tile.middle + Vec2(du, dv));
        };
        const double h = tile.width / 8;
        const Differences u = differences([&](double t) { return at(t, 0); }, h);
        const Differences v = differences([&](double t) { return at(0, t); }, h);
        const Vec3 uv =
            differences(
                [&](double t) { return differences([&](double r) { return at(r, t); }, h).first; },
                h)
                .first;
        const SurfacePoint p = s.limit.evaluate(face, 0, tile.middle);
        ASSERT_TRUE(p.first && p.second);
        EXPECT_EQ(p.x, at(0, 0));
        const double first = 1e-14 / h;
        const double second = 1e-13 / (h * h);
        SCOPED_TRACE(testing::Message() << "face " << f << " ring " << ring << " child " << child);
        EXPECT_LE((p.first->xu - u.first).norm(), first);
        EXPECT_LE((p.first->xv - v.first).norm(), first);
        EXPECT_LE((p.second->xuu - u.second).norm(), second);
        EXPECT_LE((p.second->xvv - v.second).norm(), second);
        EXPECT_LE((p.second->xuv - uv).norm(), second);
      }
    }
  }
}

/// Shapes whose sharpness is gone, or infinite, from ring 3 on.
std::vector<Shape> settled(std::vector<Shape> shapes) {
  std::erase_if(shapes, [](const Shape& s) {
    const auto lingers = [](float x) { return x > 2 && x < infinite_sharpness; };
    for (const CreaseTag& t : s.mesh.tags.creases)
      if (lingers(t.sharpness)) return true;
    for (const CornerTag& t : s.mesh.tags.corners)
      if (lingers(t.sharpness)) return true;
    return false;
  });
  return shapes;
}

INSTANTIATE_TEST_SUITE_P(Zoo, DerivativesOf, testing::ValuesIn(settled(limit_shapes())),
                         [](const auto& shape) { return shape.param.name; });
INSTANTIATE_TEST_SUITE_P(Loop, DerivativesOf, testing::ValuesIn(settled(loop_shapes())),
                         [](const auto& shape) { return shape.param.name; });

/// Value, first and second derivatives on both sides of a point on a tile border.
void expect_c2(const LimitSurface& surface, FaceId f, const Vec2& a, const Vec2& b,
               double tolerance) {
  const SurfacePoint p = surface.evaluate(f, 0, a);
  const SurfacePoint q = surface.evaluate(f, 0, b);
  ASSERT_TRUE(p.second && q.second);
  EXPECT_LE((p.x - q.x).norm(), tolerance);
  EXPECT_LE((p.first->xu - q.first->xu).norm(), tolerance);
  EXPECT_LE((p.first->xv - q.first->xv).norm(), tolerance);
  EXPECT_LE((p.second->xuu - q.second->xuu).norm(), tolerance);
  EXPECT_LE((p.second->xuv - q.second->xuv).norm(), tolerance);
  EXPECT_LE((p.second->xvv - q.second->xvv).norm(), tolerance);
}

TEST(Continuity, IsC2AcrossTileBordersInsideAFace) {
  for (const int n : {3, 5, 6, 9}) {
    Mesh mesh = shapes::disk(n, 2);
    perturb(mesh, 0.1);
    const Surface s(mesh);
    const double step = 1e-13;  // a step across the border; third derivatives are below 100
    for (const double border : {0.5, 0.25, 0.125})
      for (const double along : {0.1, 0.3, 0.45, 0.8}) {
        if (along < border) {
          expect_c2(s.limit, FaceId(0), {border - step, along}, {border + step, along}, 1e-10);
          expect_c2(s.limit, FaceId(0), {along, border - step}, {along, border + step}, 1e-10);
        }
        // the border that continues to the far side of the ring's tiles
        expect_c2(s.limit, FaceId(0), {0.5 - step, along}, {0.5 + step, along}, 1e-10);
      }
  }
}

/// How the parameters of the face across a side depend on those of this face: the other face's
/// corner a lies at our (0, 0), its corner b at our (1, 0).
TEST(Continuity, IsC2AcrossFacesAwayFromExtraordinaryVertices) {
  Mesh mesh = shapes::torus(6, 5);
  perturb(mesh, 0.1);
  const Surface s(mesh);
  const Adjacency adjacency(mesh.topology);
  int compared = 0;
  for (int i = 0; i < mesh.topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    const HalfedgeId twin = adjacency.twin(h);
    const int c = adjacency.corner_index(h);
    const int d = adjacency.corner_index(twin);
    // On side c, t along it: point and the directions along and into the face.
    struct Side {
      Vec2 origin, along, inward;
    };
    const std::array<Side, 4> sides{Side{{0, 0}, {1, 0}, {0, 1}}, Side{{1, 0}, {0, 1}, {-1, 0}},
                                    Side{{1, 1}, {-1, 0}, {0, -1}}, Side{{0, 1}, {0, -1}, {1, 0}}};
    const Side& a = sides[static_cast<std::size_t>(c)];
    const Side& b = sides[static_cast<std::size_t>(d)];
    const double t = 0.3;
    const SurfacePoint p = s.limit.evaluate(adjacency.face(h), 0, a.origin + t * a.along);
    const SurfacePoint q = s.limit.evaluate(adjacency.face(twin), 0, b.origin + (1 - t) * b.along);
    // Derivatives along direction w: first, and second as a quadratic form.
    const auto first = [](const SurfacePoint& x, const Vec2& w) {
      return Vec3(w.x() * x.first->xu + w.y() * x.first->xv);
    };
    const auto second = [](const SurfacePoint& x, const Vec2& w, const Vec2& z) {
      return Vec3(w.x() * z.x() * x.second->xuu + w.y() * z.y() * x.second->xvv +
                  (w.x() * z.y() + w.y() * z.x()) * x.second->xuv);
    };
    EXPECT_LE((p.x - q.x).norm(), 1e-14);
    EXPECT_LE((first(p, a.along) + first(q, b.along)).norm(), 1e-13);
    EXPECT_LE((first(p, a.inward) + first(q, b.inward)).norm(), 1e-13);
    EXPECT_LE((second(p, a.along, a.along) - second(q, b.along, b.along)).norm(), 1e-12);
    EXPECT_LE((second(p, a.along, a.inward) - second(q, b.along, b.inward)).norm(), 1e-12);
    EXPECT_LE((second(p, a.inward, a.inward) - second(q, b.inward, b.inward)).norm(), 1e-12);
    ++compared;
  }
  EXPECT_EQ(compared, 120);
}

/// A plane grid with corners is its own limit, phantoms and corner formula included.
TEST(Planes, GridReproducesCoordinates) {
  const Surface s(shapes::grid(4, 3), BoundaryRule::edges_and_corners);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i)
      for (const Vec2& uv : {Vec2(0, 0), Vec2(1, 0), Vec2(0.3, 0.8), Vec2(1, 1), Vec2(0.01, 0.5)}) {
        const SurfacePoint p = s.limit.evaluate(FaceId(4 * j + i), 0, uv);
        EXPECT_LE((p.x - Vec3(i + uv.x(), j + uv.y(), 0)).norm(), 1e-14);
        EXPECT_LE((p.first->xu - Vec3(1, 0, 0)).norm(), 1e-14);
        EXPECT_LE((p.first->xv - Vec3(0, 1, 0)).norm(), 1e-14);
        EXPECT_LE(p.second->xuu.norm() + p.second->xuv.norm() + p.second->xvv.norm(), 1e-13);
        EXPECT_LE((*p.normal - Vec3(0, 0, 1)).norm(), 1e-14);
        EXPECT_LE(std::abs(p.curvature->mean) + std::abs(p.curvature->gauss), 1e-13);
      }
}

/// The same for quadratics: a uniform cubic B-spline of x_i^2 at the integers is x^2 + 1/3.
TEST(Planes, ParaboloidHasItsCurvature) {
  Mesh mesh = shapes::grid(6, 6);
  for (Vec3& x : mesh.points) {
    const double a = x.x() - 3;
    const double b = x.y() - 3;
    x.z() = -(a * a + 2 * b * b) / 2;
  }
  const Surface s(mesh);
  const SurfacePoint p = s.limit.evaluate(FaceId(6 * 3 + 3), 0, {0, 0});  // the vertex (3, 3)
  EXPECT_NEAR(p.x.z(), -(1.0 / 3 + 2.0 / 3) / 2, 1e-14);
  // z = -(x^2 + 2 y^2)/2 at the origin: k = 1 and 2, positive as on a sphere with outward normal.
  EXPECT_NEAR(p.curvature->mean, 1.5, 1e-13);
  EXPECT_NEAR(p.curvature->gauss, 2.0, 1e-13);
  EXPECT_NEAR((*p.normal - Vec3(0, 0, 1)).norm(), 0, 1e-14);
}

/// A cylinder of many columns: mean curvature 1/(2 r), Gauss curvature 0, outward normal.
TEST(Curvature, OfACylinder) {
  const int columns = 64;
  const Surface s(shapes::cylinder(columns, 5));
  const SurfacePoint p = s.limit.evaluate(FaceId(2 * columns + 5), 0, {0.3, 0.6});
  const double radius = p.x.head<2>().norm();
  EXPECT_NEAR(p.curvature->mean, 1 / (2 * radius), 2e-3);
  EXPECT_NEAR(p.curvature->gauss, 0, 1e-12);
  EXPECT_NEAR(p.normal->dot(Vec3(p.x.x(), p.x.y(), 0).normalized()), 1, 1e-5);
}

/// A cube's limit is nearly a sphere: all curvatures are positive, normals point outwards.
TEST(Curvature, OfARoundCubeIsPositive) {
  const Surface s(shapes::cube());
  for (int f = 0; f < 6; ++f)
    for (const Vec2& uv : {Vec2(0.5, 0.5), Vec2(0.2, 0.4), Vec2(0.9, 0.1)}) {
      const SurfacePoint p = s.limit.evaluate(FaceId(f), 0, uv);
      EXPECT_GT(p.curvature->mean, 0.3);
      EXPECT_GT(p.curvature->gauss, 0.1);
      EXPECT_GT(p.normal->dot(p.x.normalized()), 0.95);
    }
}

}  // namespace
}  // namespace limes::test
