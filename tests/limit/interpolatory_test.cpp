#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "limes/limit/interpolatory_surface.h"
#include "limes/limit/star_masks.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

nlohmann::json read_golden(const std::string& name) {
  std::ifstream in(std::string(LIMES_TEST_DATA_DIR) + "/interpolatory/" + name + ".json");
  return nlohmann::json::parse(in);
}

const Scheme& kobbelt() {
  return find_scheme("kobbelt");
}

RuleOptions with_tension(double tension) {
  RuleOptions options;
  options.tension = tension;
  return options;
}

/// Moduli of the eigenvalues, largest first.
std::vector<double> spectrum(const MatrixX& A) {
  const Eigen::EigenSolver<MatrixX> solver(A, false);
  std::vector<double> moduli;
  for (const auto& value : solver.eigenvalues())
    moduli.push_back(std::abs(value));
  std::sort(moduli.rbegin(), moduli.rend());
  return moduli;
}

TEST(StarMatrix, HasThePublishedEigenvalues) {
  const nlohmann::json golden = read_golden("eigen");
  double largest = 0;
  for (const auto& [name, tension] :
       {std::pair("om=1/16 n=", 1.0), std::pair("om=1/8 (printed w=1) n=", 2.0)})
    for (int n = 3; n <= 12; ++n) {
      SCOPED_TRACE(n);
      const auto& expected = golden.at(name + std::to_string(n)).at("eig");
      const auto found = spectrum(star_matrix(kobbelt(), with_tension(tension), n));
      for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(found[i], expected[i][0].get<double>(), 1e-6) << i;
        largest = std::max(largest, std::abs(found[i] - expected[i][0].get<double>()));
      }
    }
  RecordProperty("largest", std::to_string(largest));
}

TEST(StarMatrix, HasThePublishedTangents) {
  const nlohmann::json golden = read_golden("limit");
  for (int n = 3; n <= 8; ++n) {
    SCOPED_TRACE(n);
    const auto& expected = golden.at("tangent n=" + std::to_string(n));
    const auto rows = star_tangents(kobbelt(), {}, n);
    ASSERT_TRUE(rows);
    const double scale = expected.at("t1")[1].get<double>() / (*rows)(0, 1);
    for (Eigen::Index i = 0; i < rows->cols(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_NEAR(scale * (*rows)(0, i), expected.at("t1")[k].get<double>(), 1e-9) << i;
      EXPECT_NEAR(scale * (*rows)(1, i), expected.at("t2")[k].get<double>(), 1e-9) << i;
    }
  }
}

/// The paper has C1 surfaces up to omega = (sqrt 5 - 1) / 8 = 0.1545; at valence 3 they end earlier.
TEST(StarMatrix, LosesTheTangentPlaneAtValence3Before9Tenths) {
  EXPECT_TRUE(star_tangents(kobbelt(), with_tension(16 * 0.1040), 3));
  EXPECT_FALSE(star_tangents(kobbelt(), with_tension(16 * 0.1042), 3));
  for (int n = 4; n <= 12; ++n)
    EXPECT_TRUE(star_tangents(kobbelt(), with_tension(2.47), n)) << n;
  EXPECT_FALSE(star_tangents(kobbelt(), with_tension(0), 4));  // bilinear patches
}

/// A net with its surface.
struct Surface {
  explicit Surface(const Mesh& m, double tension = 1.0)
      : mesh(m), adjacency(mesh.topology), options{.levels = 0} {
    options.tension = tension;
    features = control_features(adjacency, mesh, kobbelt(), options);
    surface.emplace(adjacency, features, kobbelt(), mesh.points.span());
  }
  [[nodiscard]] SurfacePoint at(int f, double u, double v) const {
    return surface->evaluate(FaceId(f), {u, v});
  }
  Mesh mesh;
  Adjacency adjacency;
  RefineOptions options;
  Features features;
  std::optional<InterpolatorySurface> surface;
};

Mesh noisy(Mesh mesh, double size) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-size, size);
  for (Vec3& x : mesh.points)
    x += Vec3(shift(random), shift(random), shift(random));
  return mesh;
}

/// The vertex (i, j) / 2^levels of a face after refinement, from the order of the children.
VertexId refined_vertex(const Mesh& fine, int f, int levels, int i, int j) {
  std::int64_t face = f;
  int size = 1 << levels;
  for (; size > 1; size /= 2) {
    const int half = size / 2;
    int c = 0, u = i, v = j;
    if (i <= half && j <= half) {
    } else if (j <= half) {
      c = 1, u = j, v = size - i;
    } else if (i <= half) {
      c = 3, u = size - j, v = i;
    } else {
      c = 2, u = size - i, v = size - j;
    }
    face = 4 * face + c;
    i = u, j = v;
  }
  const std::size_t corner = j == 0 ? (i == 0 ? 0 : 1) : (i == 0 ? 3 : 2);
  return fine.topology.face(FaceId(face))[corner];
}

TEST(InterpolatorySurface, PassesThroughTheVerticesOfRefinedNets) {
  for (const Mesh& mesh : {noisy(shapes::cube(), 0.2), noisy(shapes::disk(5, 2), 0.05),
                           noisy(shapes::disk(6, 2), 0.05), noisy(shapes::half_disk(3, 2), 0.05)}) {
    constexpr int levels = 4;
    const Surface s(mesh);
    const Mesh fine = refine(mesh, kobbelt(), {.levels = levels});
    double largest = 0;
    for (int f = 0; f < mesh.topology.num_faces(); f += 5)
      for (int i = 0; i <= 16; ++i)
        for (int j = 0; j <= 16; ++j) {
          const Vec3 x = s.at(f, i / 16.0, j / 16.0).x;
          largest =
              std::max(largest, (x - fine.points[refined_vertex(fine, f, levels, i, j)]).norm());
        }
    EXPECT_LE(largest, 4e-15);
  }
}

TEST(InterpolatorySurface, IsExactForBicubics) {
  const auto f = [](double x, double y) {
    return (((0.1 * x - 0.2) * x + 0.3) * x - 1) * (((-0.05 * y + 0.1) * y - 0.7) * y + 2);
  };
  Mesh grid = shapes::grid(9, 9);
  for (Vec3& x : grid.points)
    x.z() = f(x.x(), x.y());
  const Surface s(grid);
  for (const auto& [u, v] : {std::pair(1.0 / 3, 0.2), std::pair(0.7, 0.9), std::pair(0.0, 0.5)}) {
    const double x = 4 + u, y = 4 + v;
    const SurfacePoint p = s.at(4 * 9 + 4, u, v);
    EXPECT_NEAR(p.x.z(), f(x, y), 1e-12);
    ASSERT_TRUE(p.first);
    EXPECT_FALSE(p.second);
    const double fx = ((0.3 * x - 0.4) * x + 0.3) * (((-0.05 * y + 0.1) * y - 0.7) * y + 2);
    EXPECT_LE((p.first->xu - Vec3(1, 0, fx)).norm(), 1e-12);
  }
}

TEST(InterpolatorySurface, HasTheDerivativesOfItsPositions) {
  const Surface s(noisy(shapes::cube(), 0.2), 0.9);
  for (const auto& [u, v] : {std::pair(0.31, 0.62), std::pair(0.07, 0.05), std::pair(0.9, 0.1)}) {
    const SurfacePoint p = s.at(2, u, v);
    ASSERT_TRUE(p.first);
    const double h = 1e-5;
    EXPECT_LE(((s.at(2, u + h, v).x - s.at(2, u - h, v).x) / (2 * h) - p.first->xu).norm(), 2e-3);
    EXPECT_LE(((s.at(2, u, v + h).x - s.at(2, u, v - h).x) / (2 * h) - p.first->xv).norm(), 2e-3);
  }
}

/// A vertex of the next level of an open face is regular.
TEST(InterpolatorySurface, HasDerivativesInTheMiddleOfACornerFace) {
  const Surface s(noisy(shapes::grid(2, 2), 0.1));
  const SurfacePoint p = s.at(0, 0.5, 0.5);
  ASSERT_TRUE(p.first);
  const double h = 1e-5;
  EXPECT_LE(((s.at(0, 0.5 + h, 0.5).x - s.at(0, 0.5 - h, 0.5).x) / (2 * h) - p.first->xu).norm(),
            2e-3);
  EXPECT_FALSE(s.at(0, 0.5, 0).first);
}

/// At an extraordinary vertex there are no derivatives but a normal, to which those around tend.
TEST(InterpolatorySurface, HasTheNormalOfItsNeighbourhoodAtAnExtraordinaryVertex) {
  for (const int n : {3, 5, 6}) {
    SCOPED_TRACE(n);
    const Surface s(noisy(shapes::disk(n, 3), 0.08));
    const SurfacePoint p = s.at(0, 0, 0);
    EXPECT_EQ(p.x, s.mesh.points[VertexId(0)]);
    EXPECT_FALSE(p.first);
    ASSERT_TRUE(p.normal);
    double last = 2;
    for (const double t : {1e-2, 1e-4, 1e-6}) {
      const auto near = s.at(0, t, 0.7 * t).normal;
      ASSERT_TRUE(near);
      const double apart = (*near - *p.normal).norm();
      EXPECT_LE(apart, 0.7 * last);
      last = apart;
    }
    EXPECT_LE(last, 0.05);
  }
}

/// Points on the boundary that are no vertices: on the four-point curve through the boundary.
TEST(InterpolatorySurface, FollowsItsBoundaryCurve) {
  Mesh grid = shapes::grid(8, 3);
  for (Vec3& x : grid.points)
    x.z() = x.x() * x.x() * x.x() / 100;
  const Surface s(grid);
  for (const double u : {1.0 / 3, 0.1234}) {
    const double x = 4 + u;
    EXPECT_LE((s.at(4, u, 0).x - Vec3(x, 0, x * x * x / 100)).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace limes
