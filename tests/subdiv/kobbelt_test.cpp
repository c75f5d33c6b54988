#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

// What [kobbelt_1996] says of the scheme, and what of it holds: docs/theory/kobbelt.md.

namespace limes {
namespace {

const Scheme& kobbelt() {
  return find_scheme("kobbelt");
}

RefineOptions smooth(int levels, double tension = 1.0) {
  RefineOptions options{.levels = levels};
  options.corners = CornerRule::none;
  options.tension = tension;
  return options;
}

Mesh randomized(Mesh mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (Vec3& x : mesh.points)
    x = Vec3(coordinate(random), coordinate(random), coordinate(random));
  return mesh;
}

double size_of(const Mesh& mesh) {
  double size = 0;
  for (const Vec3& x : mesh.points)
    size = std::max(size, x.norm());
  return size;
}

/// n-gonal trapezohedron: two poles of valence n, 2 n vertices of valence 3 around.
Mesh trapezohedron(int n) {
  Mesh mesh;
  mesh.points.resize(static_cast<std::size_t>(2 * n + 2), Vec3::Zero());
  std::vector<VertexId> corners;
  const auto rim = [&](int i) { return VertexId(2 + (i + 2 * n) % (2 * n)); };
  for (int i = 0; i < n; ++i) {
    for (const VertexId v : {VertexId(0), rim(2 * i), rim(2 * i + 1), rim(2 * i + 2)})
      corners.push_back(v);
    for (const VertexId v : {VertexId(1), rim(2 * i + 1), rim(2 * i), rim(2 * i - 1)})
      corners.push_back(v);
  }
  mesh.topology = Topology(mesh.points.size(), 4, std::move(corners));
  return mesh;
}

Mesh split_once(const Mesh& mesh) {
  return refine(mesh, find_scheme("linear"), {.levels = 1});
}

std::vector<Mesh> closed_nets() {
  std::vector<Mesh> nets{shapes::cube(), split_once(shapes::cube()), shapes::torus(6, 5),
                         split_once(shapes::tetrahedron()), split_once(shapes::icosahedron())};
  for (const int n : {3, 4, 5, 6, 8, 12})
    nets.push_back(trapezohedron(n));
  return nets;
}

/// Rule (3) along one direction of a face, written down from the paper: two edge points of the new
/// level on the sides h and opposite, and beyond each a point of the four-point rule in the next
/// face, continued around the corners of the face.
Vec3 face_point_along(const Adjacency& mesh, const Mesh& control, const Mesh& fine, HalfedgeId h,
                      double omega) {
  const QuadrisectionIds ids = quadrisection_ids(mesh);
  const auto at = [&](VertexId v) { return control.points[v]; };
  const auto outer = [&](HalfedgeId side) {
    // U - u and v - W are edges of the face beyond `side` = (u, v).
    const HalfedgeId beyond = mesh.twin(side);             // v -> u
    const HalfedgeId from_u = mesh.next(beyond);           // u -> U
    const HalfedgeId to_v = mesh.prev(beyond);             // W -> v
    const HalfedgeId at_u = mesh.next(mesh.twin(from_u));  // U -> u twin's face: u -> x
    const HalfedgeId at_v = mesh.twin(to_v);               // v -> W
    const VertexId y_u = mesh.to(mesh.next(at_u));         // x -> y
    const VertexId y_w = mesh.to(mesh.next(at_v));         // W -> y
    return Vec3((0.5 + omega) * (at(mesh.to(from_u)) + at(mesh.from(to_v))) -
                omega * (at(y_u) + at(y_w)));
  };
  const HalfedgeId opposite = mesh.next(mesh.next(h));
  return (0.5 + omega) * (fine.points[ids.of_edge(mesh.edge(h))] +
                          fine.points[ids.of_edge(mesh.edge(opposite))]) -
         omega * (outer(h) + outer(opposite));
}

TEST(Kobbelt, BothDirectionsOfTheFaceRuleAgreeOnClosedNets) {
  double largest = 0;
  for (const double tension : {0.48, 1.0, 2.0})
    for (const Mesh& net : closed_nets()) {
      const Mesh control = randomized(net, 7);
      const Adjacency mesh(control.topology);
      const Mesh fine = refine(control, kobbelt(), smooth(1, tension));
      const QuadrisectionIds ids = quadrisection_ids(mesh);
      for (int f = 0; f < control.topology.num_faces(); ++f)
        for (int i = 0; i < 4; ++i) {
          const Vec3 point = face_point_along(
              mesh, control, fine, control.topology.halfedge(FaceId(f), i), tension / 16.0);
          const double gap = (point - fine.points[ids.of_face(FaceId(f))]).norm();
          largest = std::max(largest, gap / size_of(control));
        }
    }
  EXPECT_LE(largest, 1e-14);
  RecordProperty("largest", std::to_string(largest));
}

TEST(Kobbelt, RefinesTheCubeToRationals) {
  const Mesh fine = refine(shapes::cube(), kobbelt(), smooth(1));
  int edges = 0, faces = 0;
  for (int v = 8; v < fine.points.size(); ++v) {
    Vec3 x = fine.points[VertexId(v)].cwiseAbs();
    std::sort(x.data(), x.data() + 3);
    const bool edge = v < 20;
    const Vec3 expected = edge ? Vec3(0, 59.0 / 54.0, 59.0 / 54.0) : Vec3(0, 0, 65.0 / 48.0);
    EXPECT_LE((x - expected).cwiseAbs().maxCoeff(), 1e-15);
    ++(edge ? edges : faces);
  }
  EXPECT_EQ(edges, 12);
  EXPECT_EQ(faces, 6);
}

TEST(Kobbelt, KeepsVerticesAndPlanes) {
  Mesh net = randomized(shapes::disk(5, 3), 3);
  for (Vec3& x : net.points)
    x.z() = 2.0 * x.x() - 0.5 * x.y() + 1.0;
  const Mesh fine = refine(net, kobbelt(), smooth(2));
  for (int v = 0; v < net.points.size(); ++v)
    EXPECT_EQ(fine.points[VertexId(v)], net.points[VertexId(v)]);
  for (const Vec3& x : fine.points)
    EXPECT_NEAR(x.z(), 2.0 * x.x() - 0.5 * x.y() + 1.0, 4e-14);
}

/// Largest error at the vertices of a refined grid that its boundary cannot reach.
double error_inside(double (*f)(double, double), double tension) {
  constexpr int n = 12;
  Mesh grid = shapes::grid(n, n);
  for (Vec3& x : grid.points) {
    x = (x - Vec3(n / 2.0, n / 2.0, 0)) / (n / 2.0);
    x.z() = f(x.x(), x.y());
  }
  const Mesh fine = refine(grid, kobbelt(), smooth(2, tension));
  double largest = 0;
  for (const Vec3& x : fine.points)
    if (x.head<2>().cwiseAbs().maxCoeff() <= 1.0 / 3.0)
      largest = std::max(largest, std::abs(x.z() - f(x.x(), x.y())));
  return largest;
}

TEST(Kobbelt, ReproducesBicubics) {
  const auto bicubic = [](double x, double y) {
    return (((x - 2) * x + 0.3) * x - 1) * (((-0.5 * y + 1) * y - 0.7) * y + 2);
  };
  EXPECT_LE(error_inside(bicubic, 1.0), 1e-12);
  EXPECT_GE(error_inside([](double x, double) { return x * x * x * x; }, 1.0), 1e-5);
  // With any other tension 1, x, y, xy only.
  for (const double tension : {0.48, 1.6, 2.0}) {
    EXPECT_LE(error_inside([](double x, double y) { return 1 + x - 2 * y + 3 * x * y; }, tension),
              1e-12);
    EXPECT_GE(error_inside([](double x, double) { return x * x; }, tension), 1e-4);
  }
}

/// Misfit of n points around their mean to the best affine image of the regular n-gon, relative.
double affine_misfit(const std::vector<Vec3>& ring) {
  const auto n = static_cast<Eigen::Index>(ring.size());
  MatrixX A(n, 3), b(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    A.row(i) << 1.0, std::cos(a), std::sin(a);
    b.row(i) = ring[static_cast<std::size_t>(i)].transpose();
  }
  const MatrixX x = A.colPivHouseholderQr().solve(b);
  const MatrixX centred = b.rowwise() - b.colwise().mean();
  return (A * x - b).norm() / centred.norm();
}

/// Edges around vertex 0, seen from it.
std::vector<Vec3> ring_of_vertex_0(const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  std::vector<Vec3> ring;
  const HalfedgeId start = adjacency.ring_start(VertexId(0));
  for (HalfedgeId h = start;;) {
    ring.push_back(mesh.points[adjacency.to(h)] - mesh.points[VertexId(0)]);
    h = adjacency.ring_next(h);
    if (h == start) return ring;
  }
}

/// The paper: "if n edges meet at a common vertex, the angles between them tend to 2 pi / n". They
/// do up to an affine map: the ring becomes an affine image of the regular polygon, and no more.
TEST(Kobbelt, AnglesTendToEqualOnesUpToAnAffineMap) {
  // By the ratio of the fourth to the second eigenvalue in every step.
  const std::map<int, double> rates{
      {5, .361925 / .537944}, {6, .426331 / .559685}, {7, .469721 / .573197}, {8, .5 / .582134}};
  for (const auto& [n, rate] : rates) {
    SCOPED_TRACE(n);
    Mesh net = shapes::disk(n, 4);
    std::mt19937 random(static_cast<unsigned>(n));
    std::uniform_real_distribution<double> shift(-0.06, 0.06);
    for (Vec3& x : net.points)
      x = Vec3(1.7 * x.x() + 0.5 * x.y() + shift(random), x.y() + shift(random), 0.0);
    const double before = affine_misfit(ring_of_vertex_0(refine(net, kobbelt(), smooth(1))));
    const auto ring = ring_of_vertex_0(refine(net, kobbelt(), smooth(5)));
    const double after = affine_misfit(ring);
    EXPECT_LE(after, 1.3 * std::pow(rate, 4) * before);
    double off = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3& a = ring[i];
      const Vec3& b = ring[(i + 1) % ring.size()];
      const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      off = std::max(off, std::abs(angle - 2.0 * std::numbers::pi / n) * 180.0 / std::numbers::pi);
    }
    EXPECT_GE(off, 5.0) << "degrees: the angles themselves stay apart";
  }
}

// Open nets.

TEST(Kobbelt, BoundaryCurveDependsOnTheBoundaryOnly) {
  const Mesh a = randomized(shapes::half_disk(3, 3), 1);
  Mesh b = a;
  const Adjacency adjacency(a.topology);
  for (int v = 0; v < b.points.size(); ++v)
    if (!adjacency.is_boundary(VertexId(v))) b.points[VertexId(v)] += Vec3(0.3, -0.1, 0.2);
  const Mesh fine_a = refine(a, kobbelt(), {.levels = 3});
  const Mesh fine_b = refine(b, kobbelt(), {.levels = 3});
  const Adjacency fine(fine_a.topology);
  int different = 0;
  for (int v = 0; v < fine_a.points.size(); ++v) {
    const bool same = fine_a.points[VertexId(v)] == fine_b.points[VertexId(v)];
    if (fine.is_boundary(VertexId(v)))
      EXPECT_TRUE(same) << v;
    else if (!same)
      ++different;
  }
  EXPECT_GT(different, 100);
}

/// On an open grid with broken corners linear functions are exact, and xy but for the face points of
/// the four corner faces: the third extrapolated point q* + s* - p of the paper gives them an error
/// of omega^2 times the mixed difference.
TEST(Kobbelt, IsBilinearOnOpenGridsButForTheCornerFaces) {
  Mesh grid = shapes::grid(5, 4);
  for (Vec3& x : grid.points)
    x.z() = x.x() * x.y();
  const Mesh fine = refine(grid, kobbelt(), {.levels = 1});
  int corner_faces = 0;
  for (const Vec3& x : fine.points) {
    const double error = std::abs(x.z() - x.x() * x.y());
    const bool in_corner = (x.x() == 0.5 || x.x() == 4.5) && (x.y() == 0.5 || x.y() == 3.5);
    EXPECT_NEAR(error, in_corner ? 1.0 / 256.0 : 0.0, 1e-14);
    corner_faces += in_corner ? 1 : 0;
  }
  EXPECT_EQ(corner_faces, 4);
}

}  // namespace
}  // namespace limes
