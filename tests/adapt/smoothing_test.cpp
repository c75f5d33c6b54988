// Shapes of elements, against meshes that are known to be the best ones.

#include "limes/adapt/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "convergence/plane_meshes.h"
#include "limes/mesh/seams.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

using Directions = Eigen::Matrix<double, 3, Eigen::Dynamic>;

constexpr int n = 8;
const std::vector<double> equal(n* n, 1.0);  // areas

/// n x n quads, corner (i, j) at place(i, j).
template <class Place>
Mesh grid(const Place& place) {
  std::vector<Vec3> points;
  std::vector<int> quads;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      points.push_back(place(i, j));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      quads.insert(quads.end(), {v, v + 1, v + n + 2, v + n + 1});
    }
  return testing::make_mesh(std::move(points), std::move(quads));
}

IdArray<VertexId, VertexId> untied(const Mesh& mesh) {
  return tied_nodes(mesh.topology.num_vertices(), {});
}

double farthest(const Mesh& a, const Mesh& b) {
  double d = 0;
  for (int v = 0; v < a.points.size(); ++v)
    d = std::max(d, (a.points[VertexId(v)] - b.points[VertexId(v)]).norm());
  return d;
}

/// What a coordinate of a grid's vertex is not on: its border.
bool inside(int k) {
  return k % n != 0;
}

// Squares are the best there are: 1 at every corner.
TEST(Smoothing, PlaneGridBecomesSquares) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.4, 0.4);
  Mesh mesh = grid([&](int i, int j) {
    return Vec3(i + inside(i) * inside(j) * noise(random),
                j + inside(i) * inside(j) * noise(random), 0);
  });
  const Sliding sliding{
      [](VertexId v, const Vec3&) {
        const int i = v.value % (n + 1), j = v.value / (n + 1);
        return Directions(Mat3::Identity().leftCols(inside(i) && inside(j) ? 2 : 0));
      },
      [](VertexId, const Vec3& x) { return x; }};
  const SmoothingResult result = improve_shapes(mesh, equal, untied(mesh), sliding, 200);
  EXPECT_GT(result.worst_before, 2);
  EXPECT_LT(result.worst_after, 1 + 1e-3);
  EXPECT_LT(result.sweeps, 60);
  EXPECT_LT(farthest(mesh, grid([](int i, int j) { return Vec3(i, j, 0); })), 0.02);
}

// On a cylinder, whose borders are circles and straight lines along which the vertices slide.
TEST(Smoothing, VerticesSlideOnCylinderAndAlongItsBorders) {
  constexpr double angle = std::numbers::pi / 16;
  const double side = 2 * std::sin(angle / 2);  // of the chords, so that faces can be squares
  const auto on_cylinder = [&](double i, double j) {
    return Vec3(std::sin(i * angle), side * j, std::cos(i * angle));
  };
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(-0.3, 0.3);
  Mesh mesh = grid([&](int i, int j) {
    return on_cylinder(i + inside(i) * noise(random), j + inside(j) * noise(random));
  });
  const auto border = [](VertexId v) {
    return std::pair(!inside(v.value % (n + 1)), !inside(v.value / (n + 1)));
  };
  const Sliding sliding{[&](VertexId v, const Vec3& x) {
                          const auto [at_i, at_j] = border(v);
                          Directions T(3, (at_i ? 0 : 1) + (at_j ? 0 : 1));
                          if (!at_j) T.col(0) = Vec3::UnitY();
                          if (!at_i) T.rightCols(1) = Vec3(x.z(), 0, -x.x()).normalized();
                          return T;
                        },
                        [](VertexId, const Vec3& x) {
                          const double r = std::hypot(x.x(), x.z());
                          return Vec3(x.x() / r, x.y(), x.z() / r);
                        }};
  const SmoothingResult result = improve_shapes(mesh, equal, untied(mesh), sliding, 300);
  EXPECT_GT(result.worst_before, 1.5);
  EXPECT_LT(result.worst_after, 1 + 1e-3);
  for (const Vec3& x : mesh.points)
    EXPECT_NEAR(std::hypot(x.x(), x.z()), 1, 1e-15);
  EXPECT_LT(farthest(mesh, grid(on_cylinder)), 0.05 * side);
}

// Two grids side by side with vertices of their own on the common line: as one mesh would.
TEST(Smoothing, TiedVerticesStayTogether) {
  const Mesh one = grid([](int i, int j) { return Vec3(i + 0.3 * inside(i) * std::sin(j), j, 0); });
  std::vector<Vec3> points;
  std::vector<int> quads;
  std::vector<TiedEdge> tied;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      points.push_back(one.points[VertexId(j * (n + 1) + i)]);
  const auto left = [](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
    points.push_back(points[static_cast<std::size_t>(left(n / 2, j))]);
  const auto right = [&](int i, int j) { return i == n / 2 ? (n + 1) * (n + 1) + j : left(i, j); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int k, int l) { return i < n / 2 ? left(k, l) : right(k, l); };
      quads.insert(quads.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    tied.push_back({{VertexId(left(n / 2, j)), VertexId(left(n / 2, j + 1))},
                    {VertexId(right(n / 2, j)), VertexId(right(n / 2, j + 1))}});
  }
  Mesh parts = testing::make_mesh(std::move(points), std::move(quads)), whole = one;
  const Sliding sliding{
      [](VertexId v, const Vec3&) {
        const int i = v.value % (n + 1), j = v.value / (n + 1);
        return Directions(Mat3::Identity().leftCols(inside(i) && inside(j) ? 2 : 0));
      },
      [](VertexId, const Vec3& x) { return x; }};
  improve_shapes(whole, equal, untied(whole), sliding, 5);
  improve_shapes(parts, equal, tied_nodes(parts.topology.num_vertices(), tied), sliding, 5);
  for (int v = 0; v < whole.points.size(); ++v)
    EXPECT_EQ(parts.points[VertexId(v)], whole.points[VertexId(v)]) << v;
  for (int j = 0; j <= n; ++j)
    EXPECT_EQ(parts.points[VertexId(left(n / 2, j))], parts.points[VertexId(right(n / 2, j))]) << j;
}

// Faces as thin as blades: no corner turns over on the way, and none that was turned over is moved.
TEST(Smoothing, NoCornerTurnsOver) {
  const auto skew = [](int i, int j) {
    return Vec3(i + (inside(i) && inside(j) ? 0.98 * ((i + j) % 2 ? 1 : -1) * 0.5 : 0), j, 0);
  };
  Mesh mesh = grid(skew);
  const Sliding sliding{
      [](VertexId v, const Vec3&) {
        const int i = v.value % (n + 1), j = v.value / (n + 1);
        return Directions(Mat3::Identity().leftCols(inside(i) && inside(j) ? 2 : 0));
      },
      [](VertexId, const Vec3& x) { return x; }};
  double before = improve_shapes(mesh, equal, untied(mesh), sliding, 0).worst_after;
  ASSERT_TRUE(std::isfinite(before));
  for (int sweep = 0; sweep < 20; ++sweep)
    EXPECT_TRUE(std::isfinite(improve_shapes(mesh, equal, untied(mesh), sliding, 1).worst_after));
  EXPECT_LT(worst_distortion(mesh), 1.1);

  Mesh folded = grid([](int i, int j) { return Vec3(i == 3 && j == 3 ? 5.5 : i, j, 0); });
  const Vec3 x = folded.points[VertexId(3 * (n + 1) + 3)];
  improve_shapes(folded, equal, untied(folded), sliding, 3);
  EXPECT_EQ(folded.points[VertexId(3 * (n + 1) + 3)], x);
}

/// What is made less, over all corners.
double sum_of_corners(const Mesh& mesh, const std::vector<double>& areas) {
  double sum = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto corner = mesh.topology.face(FaceId(f));
    const auto at = [&](std::size_t k) { return mesh.points[corner[k % 4]]; };
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 a = at(i + 1) - at(i), b = at(i + 3) - at(i);
      const double size = (a.squaredNorm() + b.squaredNorm()) / areas[static_cast<std::size_t>(f)];
      sum += corner_distortion(a, b, Vec3::UnitZ()) * size * size;
    }
  }
  return sum;
}

// Vertices that hang are the middles of their sides, before and after, and no other place of the free ones near
// theirs has a smaller sum.
TEST(Smoothing, HangingVerticesFollowTheirSides) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-0.2, 0.2);
    Forest forest(grid([](int i, int j) { return Vec3(i, j, 0); }), find_scheme("linear"), {},
                  SplitUnit::faces);
    for (int time = 0; time < 3; ++time) {
      std::vector<FaceId> marked;
      for (const FaceId leaf : forest.leaves())
        if (random() % 5 == 0) marked.push_back(leaf);
      forest.refine(marked);
    }
    ForestMesh made = forest_mesh(forest, Closure::hanging);
    Mesh& mesh = made.mesh;
    ASSERT_GT(made.hanging.size(), 50U);
    IdArray<VertexId, char> hangs(static_cast<std::size_t>(mesh.points.size()), 0);
    for (const HangingVertex& h : made.hanging)
      hangs[h.vertex] = 1;
    const auto put_middles = [&](Mesh& m) {
      for (const HangingVertex& h : made.hanging)
        m.points[h.vertex] = (m.points[h.ends[0]] + m.points[h.ends[1]]) / 2;
    };
    std::vector<double> areas;
    for (const FaceId leaf : made.leaves)
      areas.push_back(std::ldexp(1.0, -2 * forest.ancestry(leaf).level));
    const auto inner = [](const Vec3& x) {
      return x.x() > 0 && x.x() < n && x.y() > 0 && x.y() < n;
    };
    IdArray<VertexId, char> free(static_cast<std::size_t>(mesh.points.size()), 0);
    for (int v = 0; v < mesh.points.size(); ++v)
      free[VertexId(v)] = inner(mesh.points[VertexId(v)]) && !hangs[VertexId(v)];
    const Mesh even = mesh;
    for (int v = 0; v < mesh.points.size(); ++v)
      if (free[VertexId(v)])
        mesh.points[VertexId(v)] += 0.15 * Vec3(noise(random), noise(random), 0);
    put_middles(mesh);
    const double before = sum_of_corners(mesh, areas);
    ASSERT_TRUE(std::isfinite(before));
    const Sliding sliding{[&](VertexId v, const Vec3&) {
                            return Directions(Mat3::Identity().leftCols(free[v] ? 2 : 0));
                          },
                          [](VertexId, const Vec3& x) { return x; }};
    for (int round = 0; round < 20; ++round)
      improve_shapes(mesh, areas, untied(mesh), sliding, 100, made.hanging);
    Mesh middles = mesh;
    put_middles(middles);
    EXPECT_EQ(middles.points.vector(), mesh.points.vector());
    const double after = sum_of_corners(mesh, areas);
    EXPECT_LT(after, before);
    EXPECT_LT(after, sum_of_corners(even, areas));
    for (int v = 0; v < mesh.points.size(); ++v)
      for (const Vec3& d : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
        if (!free[VertexId(v)]) continue;
        Mesh moved = mesh;
        moved.points[VertexId(v)] += 0.01 * d;
        put_middles(moved);
        EXPECT_GT(sum_of_corners(moved, areas), after) << v;
      }
  }
}

}  // namespace
}  // namespace limes
