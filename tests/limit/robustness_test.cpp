#include <gtest/gtest.h>

#include <cmath>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limit/surface.h"

// Far from the origin, at huge valence, on degenerate input.

namespace limes::test {
namespace {

/// A shift by 2^30 is exact for points that are multiples of 2^-20: derivatives must not see it.
TEST(Robustness, DerivativesDoNotSeeAFarOrigin) {
  Mesh mesh = shapes::disk(5, 2);
  perturb(mesh, 0.2);
  for (Vec3& x : mesh.points)
    x = (x * 0x1p20).array().round().matrix() * 0x1p-20;
  Mesh far = mesh;
  for (Vec3& x : far.points)
    x.array() += 0x1p30;
  const Surface a(mesh);
  const Surface b(far);
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    for (const Vec2& uv : {Vec2(0.4, 0.3), Vec2(1e-6, 2e-6), Vec2(1, 0.2)}) {
      const SurfacePoint p = a.limit.evaluate(FaceId(f), 0, uv);
      const SurfacePoint q = b.limit.evaluate(FaceId(f), 0, uv);
      EXPECT_LE((q.x - p.x - Vec3::Constant(0x1p30)).norm(), 1e-6);
      EXPECT_LE((q.first->xu - p.first->xu).norm(), 1e-14 * p.first->xu.norm());
      EXPECT_LE((q.first->xv - p.first->xv).norm(), 1e-14 * p.first->xv.norm());
      EXPECT_LE((q.second->xuu - p.second->xuu).norm(), 1e-13 * (1 + p.second->xuu.norm()));
      EXPECT_LE((*q.normal - *p.normal).norm(), 1e-13);
    }
}

/// All faces around a pole are of one kind, so that a high valence costs its square once, not for
/// every face; the kinds themselves stay few.
TEST(Robustness, AThousandFacesAroundAVertexAreOneKind) {
  const Surface s(shapes::disk(1000, 1));
  EXPECT_LE(s.basis.kinds().size(), 10);
  const SurfacePoint p = s.limit.evaluate(FaceId(123), 0, {0, 0});
  EXPECT_LE(p.x.norm(), 1e-14);  // the middle, by symmetry
  EXPECT_NEAR((*p.normal - Vec3(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR(s.limit.evaluate(FaceId(123), 0, {0.3, 0.2}).normal->z(), 1, 1e-12);
}

/// Down to 2^-200 of a face derivatives are finite; closer, a point is the vertex.
TEST(Robustness, EvaluatesAsCloseToAVertexAsNumbersGo) {
  const Surface s(shapes::disk(7, 1));
  const SurfacePoint at = s.limit.evaluate(FaceId(0), 0, {0, 0});
  EXPECT_FALSE(at.first);
  EXPECT_TRUE(at.normal);
  for (const double t : {1e-3, 1e-10, 1e-30, 1e-50}) {
    const SurfacePoint p = s.limit.evaluate(FaceId(0), 0, {t, 0.5 * t});
    ASSERT_TRUE(p.first);
    // |dx/du| grows or shrinks like 2^k lambda^k: bounded by powers, never zero or infinite.
    EXPECT_TRUE(std::isfinite(p.first->xu.norm()) && p.first->xu.norm() > 0);
    EXPECT_TRUE(std::isfinite(p.second->xuu.norm()));
    EXPECT_LE((*p.normal - Vec3(0, 0, 1)).norm(), 1e-12);
  }
  EXPECT_FALSE(s.limit.evaluate(FaceId(0), 0, {1e-80, 1e-90}).first);
}

/// A cube squeezed into a segment has limit points everywhere and normals nowhere.
TEST(Robustness, CollapsedSurfaceHasNoNormal) {
  Mesh mesh = shapes::cube();
  for (Vec3& x : mesh.points)
    x.y() = x.z() = 0;
  const Surface s(mesh);
  for (const Vec2& uv : {Vec2(0, 0), Vec2(0.4, 0.7)}) {
    const SurfacePoint p = s.limit.evaluate(FaceId(2), 0, uv);
    EXPECT_TRUE(std::isfinite(p.x.x()));
    EXPECT_FALSE(p.normal);
    EXPECT_FALSE(p.curvature);
  }
}

TEST(Robustness, RefusesWhatHasNoLimitToEvaluate) {
  Scheme scheme = find_scheme("linear");
  scheme.patch = LimitPatch::none;
  const Mesh mesh = shapes::cube();
  EXPECT_THROW(LimitBasis(mesh.topology, {}, scheme), InputError);
}

/// The limit of the bilinear scheme is the bilinear patch of each face.
TEST(Linear, LimitIsBilinear) {
  Mesh mesh = shapes::torus(4, 3);
  perturb(mesh, 0.1);
  const Model model = make_model(mesh);
  const LimitBasis basis(model.topology, model.features, find_scheme("linear"));
  const LimitSurface surface(basis, model.points);
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto c = mesh.topology.face(FaceId(f));
    const auto at = [&](std::size_t i) { return mesh.points[c[i]]; };
    const double u = 0.3, v = 0.8;
    const SurfacePoint p = surface.evaluate(FaceId(f), 0, {u, v});
    const Vec3 x =
        (1 - u) * (1 - v) * at(0) + u * (1 - v) * at(1) + u * v * at(2) + (1 - u) * v * at(3);
    const Vec3 xu = (1 - v) * (at(1) - at(0)) + v * (at(2) - at(3));
    EXPECT_LE((p.x - x).norm(), 1e-14);
    EXPECT_LE((p.first->xu - xu).norm(), 1e-14);
    EXPECT_LE((p.second->xuv - (at(0) - at(1) + at(2) - at(3))).norm(), 1e-13);
    EXPECT_LE(p.second->xuu.norm(), 1e-13);
  }
}

}  // namespace
}  // namespace limes::test
