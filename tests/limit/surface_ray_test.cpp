#include "limes/limit/surface_ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "limes/core/error.h"
#include "limes/limit/closest_point.h"
#include "limes/mesh/shapes.h"
#include "limit/surface.h"
#include "limit/zoo.h"

// Rays against a fine triangulation that is cut with plain arithmetic, against planes, and at the
// places where rays slip through or touch.

namespace limes::test {
namespace {

/// The surface as triangles between samples; cuts rays one triangle at a time.
class Triangles {
 public:
  explicit Triangles(const LimitSurface& surface, int n = 16) {
    const LimitBasis& basis = surface.basis();
    for (int f = 0; f < basis.topology().num_faces(); ++f)
      for (int corner = 0; corner < basis.num_quadrants(FaceId(f)); ++corner)
        add(surface, FaceId(f), corner, n);
  }

  /// Smallest t >= 0 where a ray meets a triangle.
  [[nodiscard]] std::optional<double> first(const Vec3& origin, const Vec3& direction) const {
    std::optional<double> smallest;
    for (const auto& [a, b, c] : triangles_) {
      Mat3 M;
      M << b - a, c - a, -direction;
      const double determinant = M.determinant();
      if (determinant == 0) continue;
      const Vec3 x = M.inverse() * (origin - a);
      if (x[0] < 0 || x[1] < 0 || x[0] + x[1] > 1 || x[2] < 0) continue;
      if (!smallest || x[2] < *smallest) smallest = x[2];
    }
    return smallest;
  }

 private:
  void add(const LimitSurface& surface, FaceId f, int corner, int n) {
    std::vector<Vec3> grid;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        grid.push_back(surface.position(f, corner, Vec2(i, j) / n));
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const auto at = [&](int k, int l) {
          return grid[static_cast<std::size_t>((n + 1) * l + k)];
        };
        triangles_.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles_.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  std::vector<std::array<Vec3, 3>> triangles_;
};

void expect_consistent(const Surface& s, const Ray& ray, const RayHit& hit, double size) {
  EXPECT_LE((ray.origin + hit.t * ray.direction - hit.point).norm(), 1e-12 * size);
  EXPECT_LE((s.limit.position(hit.face, hit.corner, hit.uv) - hit.point).norm(), 1e-12 * size);
  EXPECT_GE(hit.t, ray.t_min);
  EXPECT_LE(hit.t, ray.t_max);
}

class RaysOnEveryShape : public testing::TestWithParam<Shape> {};

TEST_P(RaysOnEveryShape, HitWhereTheTrianglesAreHit) {
  const Surface s(GetParam().mesh, GetParam().boundary);
  const SurfaceTree tree(s.basis, s.model.points);
  const Triangles triangles(s.limit, GetParam().mesh.topology.num_faces() > 100 ? 4 : 12);
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&]() -> Vec3 { return {unit(random), unit(random), unit(random)}; };
  const double size = std::ldexp(tree.size(), tree.exponent());
  int differ = 0, hits = 0;
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    Ray ray;
    ray.origin = 3.0 * size * vector();
    ray.direction = 0.3 * size * vector() - ray.origin;
    const auto hit = first_hit(tree, ray);
    const auto expected = triangles.first(ray.origin, ray.direction);
    if (hit) expect_consistent(s, ray, *hit, size);
    if (hit) ++hits;
    // Triangles cut corners: near silhouettes and boundaries they may miss or be missed.
    const bool agree = hit.has_value() == expected.has_value() &&
                       (!hit || std::abs(hit->t - *expected) * ray.direction.norm() < 0.03 * size);
    if (!agree) ++differ;
    if (hit) {
      const SurfacePoint p = s.limit.evaluate(hit->face, hit->corner, hit->uv);
      if (p.normal && hit->side != RayHit::Side::edge_on) {
        EXPECT_EQ(p.normal->dot(ray.direction) < 0, hit->side == RayHit::Side::front);
      }
    }
  }
  EXPECT_LE(differ, 3);
  EXPECT_GE(hits, 3);
}

INSTANTIATE_TEST_SUITE_P(, RaysOnEveryShape, testing::ValuesIn(limit_shapes()),
                         [](const auto& test) { return test.param.name; });

/// Where the cubes of a regular pattern of rays meet z = 0, exactly; also through every vertex and
/// along every edge of the faces, where rays could slip through.
TEST(SurfaceRay, SlipsThroughNowhere) {
  const Surface s(shapes::grid(4, 3), BoundaryRule::edges_and_corners);
  const SurfaceTree tree(s.basis, s.model.points);
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 12; ++j) {
      const Vec3 target(i / 4.0, j / 4.0, 0);
      for (const Vec3& d :
           {Vec3(0, 0, -1), Vec3(0.3, 0.1, -2), Vec3(1e-3, 7, -1e-3), Vec3(3, 0, 5)}) {
        const auto hit = first_hit(tree, {target - 2 * d, d});
        ASSERT_TRUE(hit) << target.transpose();
        EXPECT_NEAR(hit->t, 2, 1e-12);
        EXPECT_LE((hit->point - target).norm(), 2e-13);
        EXPECT_EQ(hit->side, d.z() < 0 ? RayHit::Side::front : RayHit::Side::back);
      }
    }
  EXPECT_FALSE(first_hit(tree, {{4.001, 1, 1}, {0, 0, -1}}));
  EXPECT_FALSE(first_hit(tree, {{2, 1, 1}, {1, 0, 0}}));
}

/// Rays at the vertices of closed surfaces from within: none gets out.
TEST(SurfaceRay, VerticesAndEdgesAreHit) {
  for (Mesh mesh : {shapes::cube(), shapes::icosahedron(), shapes::tetrahedron()}) {
    perturb(mesh, 0.02);
    const Surface s(mesh);
    const SurfaceTree tree(s.basis, s.model.points);
    for (int f = 0; f < mesh.topology.num_faces(); ++f)
      for (int corner = 0; corner < s.basis.num_quadrants(FaceId(f)); ++corner)
        for (const Vec2& uv : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1), Vec2(0.3, 0),
                               Vec2(1, 0.7), Vec2(0.2, 1), Vec2(0, 0.5), Vec2(0.5, 0.5)}) {
          const Vec3 x = s.limit.position(FaceId(f), corner, uv);
          const Ray ray{Vec3(0.01, 0.02, 0), x - Vec3(0.01, 0.02, 0)};
          const auto hit = first_hit(tree, ray);
          ASSERT_TRUE(hit) << f << " " << corner << " " << uv.transpose();
          EXPECT_NEAR(hit->t, 1, 1e-12);
          EXPECT_LE((hit->point - x).norm(), 1e-12);
          EXPECT_EQ(hit->side, RayHit::Side::back);
          expect_consistent(s, ray, *hit, 2);
        }
  }
}

/// A cubic ridge z = -y^2 (in the limit of parabola-shaped controls): rays that touch its crest.
TEST(SurfaceRay, TouchesWithinTheTolerance) {
  Mesh mesh = shapes::grid(6, 6);
  for (Vec3& x : mesh.points)
    x.z() = -(x.y() - 3) * (x.y() - 3);
  const Surface s(mesh);
  const SurfaceTree tree(s.basis, s.model.points);
  const double top = s.limit.position(FaceId(14), 0, {0.5, 1}).z();  // of y = 3
  const auto ray_at = [&](double z) { return Ray{Vec3(2.7, -5, z), Vec3(0, 1, 0)}; };
  const auto touch = first_hit(tree, ray_at(top));
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->point.y(), 3, 1e-5);
  const auto below = first_hit(tree, ray_at(top - 1e-6));
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->point.y(), 3 - 1e-3, 1e-8);
  EXPECT_FALSE(first_hit(tree, ray_at(top + 1e-11)));
  // along the flat surface: the first point is where the plate begins
  const Surface plate(shapes::grid(5, 4), BoundaryRule::edges_and_corners);
  const SurfaceTree plate_tree(plate.basis, plate.model.points);
  const auto along = first_hit(plate_tree, {{-3, 1.3, 0}, {2, 0, 0}});
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->t, 1.5, 1e-12);
  EXPECT_EQ(along->side, RayHit::Side::edge_on);
}

TEST(SurfaceRay, KeepsToItsRange) {
  const Surface s(shapes::torus(8, 6));
  const SurfaceTree tree(s.basis, s.model.points);
  Ray ray{Vec3(-10, 0.1, 0.05), Vec3(2, 0, 0)};
  std::vector<double> all;  // four walls, one after the other
  for (auto hit = first_hit(tree, ray); hit; hit = first_hit(tree, ray)) {
    all.push_back(hit->t);
    EXPECT_EQ(hit->side, all.size() % 2 == 1 ? RayHit::Side::front : RayHit::Side::back);
    ray.t_min = hit->t + 1e-9;
  }
  ASSERT_EQ(all.size(), 4U);
  ray = {Vec3(-10, 0.1, 0.05), Vec3(2, 0, 0), 0, 0.5 * all[0]};
  EXPECT_FALSE(first_hit(tree, ray));
  ray.t_max = all[0];
  EXPECT_TRUE(first_hit(tree, ray));
  // lines: t may be negative
  ray = {Vec3(10, 0.1, 0.05), Vec3(2, 0, 0), -std::numeric_limits<double>::infinity()};
  ASSERT_TRUE(first_hit(tree, ray));
  EXPECT_NEAR(first_hit(tree, ray)->t, all[0] - 10, 1e-12);
}

TEST(SurfaceRay, FromFarAway) {
  const Surface s(shapes::torus(8, 6));
  const SurfaceTree tree(s.basis, s.model.points);
  const Vec3 x = s.limit.position(FaceId(3), 0, {0.3, 0.6});
  const auto near = first_hit(tree, {x + Vec3(0, 0, 5), Vec3(0, 0, -1)});
  ASSERT_TRUE(near);
  const auto far = first_hit(tree, {Vec3(x.x(), x.y(), 0x1p40), Vec3(0, 0, -0x1p-500)});
  ASSERT_TRUE(far);
  EXPECT_LE((near->point - far->point).norm(), 1e-13);
}

TEST(SurfaceRay, InBulkIsBitwiseTheSame) {
  Mesh mesh = shapes::cube();
  perturb(mesh, 0.1);
  const Surface s(mesh);
  const SurfaceTree tree(s.basis, s.model.points);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Ray> rays;
  for (int i = 0; i < 2000; ++i)
    rays.push_back({Vec3(unit(random), unit(random), 3), Vec3(unit(random), unit(random), -3)});
  const auto hits = first_hits(tree, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto one = first_hit(tree, rays[i]);
    ASSERT_EQ(one.has_value(), hits[i].has_value());
    if (!one) continue;
    EXPECT_EQ(one->t, hits[i]->t);
    EXPECT_EQ(one->face, hits[i]->face);
    EXPECT_EQ(one->uv, hits[i]->uv);
    EXPECT_EQ(one->point, hits[i]->point);
  }
}

TEST(SurfaceRay, RefusesWhatIsNoRay) {
  const Surface s(shapes::cube());
  const SurfaceTree tree(s.basis, s.model.points);
  const Vec3 o = Vec3::Zero(), d(1, 0, 0);
  EXPECT_THROW((void)first_hit(tree, {o, o}), InputError);
  EXPECT_THROW((void)first_hit(tree, {Vec3(NAN, 0, 0), d}), InputError);
  EXPECT_THROW((void)first_hit(tree, {o, Vec3(INFINITY, 0, 0)}), InputError);
  EXPECT_THROW((void)first_hit(tree, {o, d, 2, 1}), InputError);
  EXPECT_THROW((void)first_hit(tree, {o, d, NAN, 1}), InputError);
  const std::vector<Ray> rays{{o, d}, {o, o}};
  try {
    (void)first_hits(tree, rays);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()), "ray 1: the direction is 0");
  }
}

}  // namespace
}  // namespace limes::test
