#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "limes/mesh/shapes.h"
#include "limit/surface.h"
#include "limit/zoo.h"

// Normals at extraordinary vertices: the tangent rows are dominant left eigenvectors of the ring's
// refinement, and the normal is the limit of the normals nearby.

namespace limes::test {
namespace {

/// Real parts of the eigenvalues, largest first.
std::vector<double> eigenvalues(const SparseMatrix& A) {
  const Eigen::EigenSolver<MatrixX> solver(MatrixX(A), false);
  std::vector<double> values;
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    values.push_back(solver.eigenvalues()(i).real());
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

/// Whether corner 0 is a sharp vertex, or a crease cuts the ring in two there.
bool is_corner_or_crease(const RingKind& kind) {
  const Adjacency ring(kind.ring.topology, Adjacency::Check::edges);
  for (const SharpVertex& v : kind.ring.features.vertices)
    if (v.vertex == VertexId(0)) return true;
  int count = ring.is_boundary(VertexId(0)) ? 1 : 0;
  for (const SharpEdge& e : kind.ring.features.edges)
    count += ring.from(e.halfedge) == VertexId(0) || ring.to(e.halfedge) == VertexId(0);
  return count > 1;
}

class TangentsOf : public testing::TestWithParam<Shape> {};

/// rows A = L rows with a 2 x 2 matrix L whose eigenvalues are the second and third of A: the plane
/// they span is what refinement shrinks least, which makes it the tangent plane. Where one or four
/// faces (Loop: six) lie beside a crease A has a Jordan block: that is left to the next test. At a
/// corner, or across a crease, other faces have eigenvalues of their own, so there only the first
/// part is asked for.
TEST_P(TangentsOf, AreDominantLeftEigenvectors) {
  const Surface s(GetParam());
  const RingKinds& kinds = s.basis.kinds();
  for (int k = 0; k < kinds.size(); ++k) {  // refining a kind adds its children
    const RingKind& kind = kinds[k];
    if (kind.patch) continue;
    const RefinedKind& refined = kinds.refined(k);
    if (!refined.self_similar || !refined.tangents || kind.ring.num_controls > 150) continue;
    const Adjacency ring(kind.ring.topology, Adjacency::Check::edges);
    const int num_faces = ring.num_ring_faces(VertexId(0));
    const bool jordan = s.basis.on_triangles() ? num_faces == 6 : num_faces == 1 || num_faces == 4;
    if (ring.is_boundary(VertexId(0)) && jordan) continue;
    const MatrixX A(refined.children[0].A);
    const MatrixX t = *refined.tangents;
    EXPECT_LE((t.rowwise().sum()).norm(), 1e-13) << "not a difference";
    const MatrixX gram = t * t.transpose();
    const Mat2 L = t * A * t.transpose() * gram.inverse();
    EXPECT_LE((t * A - L * t).norm(), 1e-12 * t.norm()) << "kind " << k;
    if (is_corner_or_crease(kind)) continue;
    const std::vector<double> all = eigenvalues(refined.children[0].A);
    const Eigen::EigenSolver<Mat2> own(L, false);
    const double low = own.eigenvalues().real().minCoeff();
    const double high = own.eigenvalues().real().maxCoeff();
    EXPECT_NEAR(all[0], 1, 1e-12);
    EXPECT_NEAR(high, all[1], 1e-7);
    EXPECT_NEAR(low, all[2], 1e-7);
    EXPECT_GT(all[2], all[3] + 1e-4) << "kind " << k << ": no tangent plane";
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, TangentsOf, testing::ValuesIn(limit_shapes()),
                         [](const auto& shape) { return shape.param.name; });
INSTANTIATE_TEST_SUITE_P(Loop, TangentsOf, testing::ValuesIn(loop_shapes()),
                         [](const auto& shape) { return shape.param.name; });

/// Normals of face f on a short arc around its corner 0; nothing if one is lost there.
std::optional<std::vector<Vec3>> find_normals(const Surface& s, FaceId f, double distance) {
  std::vector<Vec3> normals;
  for (const double t : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
    const auto normal = s.limit.evaluate(f, 0, {distance * (1 - t), distance * t}).normal;
    if (!normal) return {};
    normals.push_back(*normal);
  }
  return normals;
}
std::vector<Vec3> normals_nearby(const Surface& s, FaceId f, double distance) {
  return find_normals(s, f, distance).value();
}

double largest_distance(const std::vector<Vec3>& normals, const Vec3& from) {
  double worst = 0;
  for (const Vec3& n : normals)
    worst = std::max(worst, (n - from).norm());
  return worst;
}

/// The faces around vertex 0, cut at infinitely sharp edges: one list for each smooth piece.
std::vector<std::vector<FaceId>> sectors_of(const Surface& s) {
  const Adjacency& adjacency = s.basis.adjacency();
  const Sharpness sharpness(adjacency, s.basis.features());
  const auto starts_sector = [&](HalfedgeId h) {
    return sharpness.edge(adjacency.edge(h)) >= infinite_sharpness;
  };
  std::vector<HalfedgeId> ring;
  const HalfedgeId start = adjacency.ring_start(VertexId(0));
  for (HalfedgeId h = start; h.valid();) {
    ring.push_back(h);
    h = adjacency.ring_next(h);
    if (h == start) break;
  }
  const auto first = std::find_if(ring.begin(), ring.end(), starts_sector);
  if (first != ring.end()) std::rotate(ring.begin(), first, ring.end());
  std::vector<std::vector<FaceId>> sectors;
  for (const HalfedgeId h : ring) {
    if (sectors.empty() || starts_sector(h)) sectors.emplace_back();
    sectors.back().push_back(adjacency.face(h));
  }
  return sectors;
}

/// The smooth piece around vertex 0 that holds a face.
struct Piece {
  std::size_t num_faces;
  bool whole;   ///< no sharp edge
  bool corner;  ///< else: at a corner, not beside a crease
};
Piece piece_of(const Surface& s, FaceId f) {
  const auto sectors = sectors_of(s);
  const auto own = std::find_if(sectors.begin(), sectors.end(), [&](const auto& sector) {
    return std::find(sector.begin(), sector.end(), f) != sector.end();
  });
  return {own->size(), sectors.size() == 1 && !s.basis.adjacency().is_boundary(VertexId(0)),
          sectors.size() > 2 || !s.basis.features().vertices.empty()};
}

/// Whether the modes of the tangent plane belong to a Jordan block of the ring's refinement. Then
/// normals come near like 1/level only, and beyond level 40 rounding takes over.
bool has_jordan_block(const Surface& s, FaceId f) {
  const Piece own = piece_of(s, f);
  if (own.whole) return false;
  if (s.basis.on_triangles()) return own.num_faces == (own.corner ? 3U : 6U);
  return own.corner ? own.num_faces == 2 : own.num_faces == 1 || own.num_faces == 4;
}

/// How close to the vertex derivatives still tell the normal. Beside a crease with two triangles the
/// part across fades like (3/4)^level, into rounding.
double closest(const Surface& s, FaceId f) {
  const Piece own = piece_of(s, f);
  const bool fades = s.basis.on_triangles() && !own.whole && own.num_faces == 2;
  return std::ldexp(1, fades ? -60 : -150);
}

class NormalsOf : public testing::TestWithParam<Shape> {};

/// Valences up to 12; beyond, normals come near so slowly that 150 levels do not show it.
TEST_P(NormalsOf, AreLimitsOfNormalsNearby) {
  const Surface s(GetParam());
  if (s.basis.adjacency().valence(VertexId(0)) > 12) return;
  const auto starts_at_0 = [&](FaceId f) { return s.model.topology.face(f)[0] == VertexId(0); };
  for (const std::vector<FaceId>& sector : sectors_of(s)) {
    if (!std::all_of(sector.begin(), sector.end(), starts_at_0)) continue;
    std::vector<Vec3> all;
    bool exists = true;
    for (const FaceId f : sector) {
      SCOPED_TRACE(f.value);
      const SurfacePoint at = s.limit.evaluate(f, 0, {0, 0});
      exists = at.normal.has_value();
      // Where xu and xv become parallel at the vertex (smooth corners of one face, some mixtures of
      // sharpness), rounding loses the normal within 2^-40 of it; 2^-25 away it must be there.
      const auto nearest = find_normals(s, f, closest(s, f));
      const std::vector<Vec3> near = nearest ? *nearest : normals_nearby(s, f, std::ldexp(1, -25));
      all.insert(all.end(), near.begin(), near.end());
      if (!exists) continue;
      if (has_jordan_block(s, f)) {
        const double far = largest_distance(normals_nearby(s, f, std::ldexp(1, -10)), *at.normal);
        const double close = largest_distance(normals_nearby(s, f, std::ldexp(1, -30)), *at.normal);
        EXPECT_LE(close, std::max(0.6 * far, 0.005));
        EXPECT_LE(close, s.basis.on_triangles() ? 0.4 : 0.15);
      } else {
        EXPECT_LE(largest_distance(near, *at.normal), 1e-3);
      }
    }
    // No normal: then those nearby do not agree, at whatever distance.
    if (!exists) {
      EXPECT_GT(largest_distance(all, all[0]), 1e-2) << "a tangent plane after all";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, NormalsOf, testing::ValuesIn(limit_shapes()),
                         [](const auto& shape) { return shape.param.name; });
INSTANTIATE_TEST_SUITE_P(Loop, NormalsOf, testing::ValuesIn(loop_shapes()),
                         [](const auto& shape) { return shape.param.name; });

/// The subdominant eigenvalue of an interior vertex, in closed form [stam_1998].
TEST(Spectrum, SubdominantEigenvalueIsTheClosedForm) {
  for (int n = 3; n <= 40; ++n) {
    const Surface s(shapes::disk(n, 2));
    if (n == 4) continue;
    const RefinedKind& kind = s.basis.kinds().refined(s.basis.kind(FaceId(0)));
    ASSERT_TRUE(kind.self_similar);
    const double c = std::cos(2 * std::acos(-1.0) / n);
    const double expected = (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16;
    const std::vector<double> values = eigenvalues(kind.children[0].A);
    EXPECT_NEAR(values[0], 1, 1e-12);
    EXPECT_NEAR(values[1], expected, 1e-9) << n;
    EXPECT_NEAR(values[2], expected, 1e-9) << n;
    EXPECT_LT(values[3], expected - 1e-4) << n;
  }
}

}  // namespace
}  // namespace limes::test
