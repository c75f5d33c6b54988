#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "limes/core/error.h"
#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/surface_tree.h"
#include "limes/math/box_spline.h"
#include "limes/mesh/shapes.h"
#include "limit/surface.h"
#include "limit/zoo.h"

// What is known of Loop's limits: box splines, masks at vertices, properties of all basis functions.

namespace limes::test {
namespace {

/// Values and derivatives of the twelve box splines, one a row, in the order of box_spline_index.
Eigen::Matrix<double, 12, 6> box_splines(const Vec2& uv) {
  return box_spline_coefficients() * quartic_bernstein(uv);
}

/// Of control values p(i, j) at the points of the triangulation.
template <class Function>
Eigen::Matrix<double, 1, 6> combined(const Function& p, const Vec2& uv) {
  const Eigen::Matrix<double, 12, 6> N = box_splines(uv);
  Eigen::Matrix<double, 1, 6> sum = Eigen::Matrix<double, 1, 6>::Zero();
  for (int j = -1; j <= 2; ++j)
    for (int i = j < 0 ? 0 : -1; i <= 2 - std::max(j, 0); ++i)
      sum += p(double(i), double(j)) * N.row(box_spline_index(i, j));
  return sum;
}

const std::array<Vec2, 5> inside{Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.6, 0.1), Vec2(0.3, 0.7),
                                 Vec2(0.01, 0.02)};

/// The box spline is the density of a sum of six independent uniform steps, two along each of the
/// edges (1, 0), (0, 1), (1, -1): its covariance is [[2, -1], [-1, 2]] / 6, odd moments are 0. So
/// what it makes of cubics is known.
TEST(BoxSpline, ReproducesPolynomialsByItsMoments) {
  using Row = Eigen::Matrix<double, 1, 6>;
  for (const Vec2& uv : inside) {
    const double u = uv.x();
    const double v = uv.y();
    const auto expect = [&](const auto& p, const std::array<double, 6>& wanted) {
      const Row difference = combined(p, uv) - Row(wanted.data());
      EXPECT_LE(difference.cwiseAbs().maxCoeff(), 1e-13) << uv.transpose();
    };
    expect([](double, double) { return 1.0; }, {1, 0, 0, 0, 0, 0});
    expect([](double i, double) { return i; }, {u, 1, 0, 0, 0, 0});
    expect([](double, double j) { return j; }, {v, 0, 1, 0, 0, 0});
    expect([](double i, double) { return i * i; }, {u * u + 1.0 / 3, 2 * u, 0, 2, 0, 0});
    expect([](double i, double j) { return i * j; }, {u * v - 1.0 / 6, v, u, 0, 1, 0});
    expect([](double i, double) { return i * i * i; },
           {u * u * u + u, 3 * u * u + 1, 0, 6 * u, 0, 0});
    expect([](double i, double j) { return i * i * j; },
           {u * u * v + v / 3 - u / 3, 2 * u * v - 1.0 / 3, u * u + 1.0 / 3, 2 * v, 2 * u, 0});
  }
}

/// The value 1/2 at its own point and 1/12 at the six around.
TEST(BoxSpline, HasItsValuesAtControlPoints) {
  const auto N = box_splines({0, 0});
  EXPECT_NEAR(N(box_spline_index(0, 0), 0), 0.5, 1e-15);
  for (const auto& [i, j] :
       std::array<std::array<int, 2>, 6>{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}})
    EXPECT_NEAR(N(box_spline_index(i, j), 0), 1.0 / 12, 1e-15);
}

/// Weight of each neighbour in the limit of a vertex, [loop_1987]: 1 / (n + 3 / (8 w)).
TEST(LoopMasks, LimitOfAVertex) {
  for (const Shape& shape : loop_shapes()) {
    if (!shape.name.starts_with("interior")) continue;
    const Surface s(shape);
    const int n = s.basis.adjacency().num_ring_faces(VertexId(0));
    const double c = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
    const double w = (0.625 - c * c) / n;
    const double omega = 1 / (n + 3 / (8 * w));
    BasisAt at;
    s.basis.evaluate(FaceId(0), 0, {0, 0}, 2, at);
    const auto controls = s.basis.controls(FaceId(0));
    for (std::size_t k = 0; k < controls.size(); ++k) {
      const double expected = controls[k].value == 0   ? 1 - n * omega
                              : controls[k].value <= n ? omega
                                                       : 0.0;
      EXPECT_NEAR(at.N(static_cast<Eigen::Index>(k)), expected, 1e-14) << n;
    }
    EXPECT_EQ(at.dN.rows() > 0, n == 6);
  }
}

/// On a boundary that of the cubic B-spline: 1/6, 2/3, 1/6, whatever the valence.
TEST(LoopMasks, LimitOfABoundaryVertex) {
  for (const Shape& shape : loop_shapes()) {
    if (!shape.name.starts_with("boundary") || shape.name.find("corner") != std::string::npos)
      continue;
    const Surface s(shape);
    const int k = s.basis.adjacency().num_ring_faces(VertexId(0));
    const auto& x = s.model.points;
    const auto last = static_cast<std::size_t>(k) + 1;
    const Vec3 expected = x[0] * 2 / 3 + (x[1] + x[last]) / 6;
    EXPECT_LE((s.limit.position(FaceId(0), 0, {0, 0}) - expected).norm(), 1e-15) << shape.name;
  }
}

TEST(LoopMasks, AreUsedForLimitPositions) {
  const Surface s(shapes::tetrahedron(), BoundaryRule::edges, "loop");
  const auto limits = limit_positions(s.limit, s.model.points);
  for (int v = 0; v < 4; ++v)  // w = 3/16, so 1 / (3 + 2) for each neighbour; their sum is -V
    EXPECT_LE((limits[VertexId(v)] - s.model.points[static_cast<std::size_t>(v)] / 5).norm(),
              1e-15);
}

TEST(LoopBasis, SumsToOneAndItsDerivativesToZero) {
  for (const Shape& shape : loop_shapes()) {
    const Surface s(shape);
    for (int f = 0; f < std::min(6, s.model.topology.num_faces()); ++f)
      for (const Vec2& uv : inside) {
        BasisAt at;
        s.basis.evaluate(FaceId(f), 0, uv, 2, at);
        EXPECT_NEAR(at.N.sum(), 1.0, 1e-14) << shape.name;
        if (at.dN.rows() == 0) continue;
        EXPECT_LE(at.dN.colwise().sum().cwiseAbs().maxCoeff(), 1e-12) << shape.name;
        EXPECT_LE(at.ddN.colwise().sum().cwiseAbs().maxCoeff(), 1e-10) << shape.name;
      }
  }
}

/// A plane grid with sharp corners is its own limit: phantoms, corners with one face and with two.
TEST(LoopPlanes, GridReproducesCoordinates) {
  for (const Shape& shape : loop_shapes()) {
    if (shape.name != "grid") continue;
    const Surface s(shape);
    for (int f = 0; f < s.model.topology.num_faces(); ++f) {
      const auto v = s.model.topology.face(FaceId(f));
      const auto x = [&](std::size_t i) {
        return s.model.points[static_cast<std::size_t>(v[i].value)];
      };
      for (const Vec2& uv : inside) {
        const SurfacePoint p = s.limit.evaluate(FaceId(f), 0, uv);
        EXPECT_LE((p.x - x(0) - uv.x() * (x(1) - x(0)) - uv.y() * (x(2) - x(0))).norm(), 1e-14);
        if (!p.first) continue;
        EXPECT_LE((p.first->xu - (x(1) - x(0))).norm(), 1e-13);
        EXPECT_LE((p.first->xv - (x(2) - x(0))).norm(), 1e-13);
        EXPECT_LE(p.second->xuu.norm() + p.second->xuv.norm() + p.second->xvv.norm(), 1e-12);
      }
    }
  }
}

/// Away from features the surface is one polynomial a face, and C2 across sides.
TEST(LoopContinuity, IsC2AcrossARegularSide) {
  for (const Shape& shape : loop_shapes()) {
    if (shape.name != "interior6") continue;
    const Surface s(shape);
    // Faces 0 and 1 share the side from vertex 0; its point at t has v = 0 in face 1, u = 0 in face 0.
    const SurfacePoint p = s.limit.evaluate(FaceId(0), 0, {0, 0.3});
    const SurfacePoint q = s.limit.evaluate(FaceId(1), 0, {0.3, 0});
    EXPECT_LE((p.x - q.x).norm(), 1e-14);
    // With e the side and a, b the other sides at vertex 0 of faces 0, 1: b = e - a.
    EXPECT_LE((q.first->xu - p.first->xv).norm(), 1e-13);
    EXPECT_LE((q.first->xv - (p.first->xv - p.first->xu)).norm(), 1e-13);
    EXPECT_LE((q.second->xuu - p.second->xvv).norm(), 1e-12);
    EXPECT_LE((q.second->xuv - (p.second->xvv - p.second->xuv)).norm(), 1e-12);
    EXPECT_LE((q.second->xvv - (p.second->xvv - 2 * p.second->xuv + p.second->xuu)).norm(), 1e-12);
  }
}

/// Subdominant eigenvalue of an interior vertex, [loop_1987]: 3/8 + cos(2 pi / n) / 4, twice.
TEST(LoopSpectrum, RingsShrinkByTheSubdominantEigenvalue) {
  for (const Shape& shape : loop_shapes()) {
    if (!shape.name.starts_with("interior")) continue;
    const Surface s(shape);
    const int n = s.basis.adjacency().num_ring_faces(VertexId(0));
    if (n == 6 || n > 16) continue;  // faces with a border too
    const RefinedKind& kind = s.basis.kinds().refined(s.basis.kind(FaceId(0)));
    ASSERT_TRUE(kind.self_similar && kind.tangents);
    const double lambda = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
    const MatrixX t = *kind.tangents;
    EXPECT_LE((t * kind.children[0].A - lambda * t).norm(), 1e-13 * t.norm()) << n;
  }
}

TEST(LoopRefusals, NameWhatNeedsSquares) {
  const Surface s(shapes::icosahedron(), BoundaryRule::edges, "loop");
  EXPECT_THROW(BulkEvaluator(s.basis, s.model.points), InputError);
  EXPECT_THROW(SurfaceTree(s.basis, s.model.points), InputError);
  EXPECT_THROW(Surface(shapes::cube(), BoundaryRule::edges, "loop"), InputError) << "quads";
}

}  // namespace
}  // namespace limes::test
