#include "limes/limit/corner_tangents.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "limes/subdiv/crease.h"

namespace limes {
namespace {

using TangentRows = Eigen::Matrix<double, 2, Eigen::Dynamic>;

/// The one-ring of corner 0 in counter-clockwise order: ends of the edges, far corners of the faces
/// (face i between edges i and i + 1; triangles have none), sharpness of the edges. It starts at the
/// face of interest for an interior ring, at the boundary otherwise.
struct OneRing {
  std::vector<VertexId> edge_ends, face_ends;
  std::vector<float> edge_sharpness;
  int num_faces = 0;
  bool boundary = false;
  int home = 0;  ///< index of the ring's own face
};

OneRing one_ring(const Ring& ring) {
  const Adjacency adjacency(ring.topology, Adjacency::Check::edges);
  const Sharpness sharpness(adjacency, ring.features);
  OneRing out;
  out.boundary = adjacency.is_boundary(VertexId(0));
  const HalfedgeId own = ring.topology.halfedge(FaceId(0), 0);
  const HalfedgeId start = out.boundary ? adjacency.ring_start(VertexId(0)) : own;
  for (HalfedgeId h = start; h.valid();) {
    if (h == own) out.home = out.num_faces;
    ++out.num_faces;
    out.edge_ends.push_back(adjacency.to(h));
    out.edge_sharpness.push_back(sharpness.edge(adjacency.edge(h)));
    const HalfedgeId in = adjacency.prev(h);
    if (ring.topology.face_size(adjacency.face(h)) == 4)
      out.face_ends.push_back(adjacency.to(adjacency.next(h)));
    if (!adjacency.twin(in).valid()) {
      out.edge_ends.push_back(adjacency.from(in));
      out.edge_sharpness.push_back(sharpness.edge(adjacency.edge(in)));
    }
    h = adjacency.ring_next(h);
    if (h == start) break;
  }
  return out;
}

/// The slowest mode of the smooth rules around a vertex that turns by the angle theta from edge to
/// edge: as a left eigenvector edge i has the weight 4 cos(i theta), face i the weight
/// `face` (cos(i theta) + cos((i + 1) theta)).
struct Mode {
  double eigenvalue;
  double face;
  double beside;  ///< what an edge of a crease gets of the mode's first edge, over sin(theta)
};

/// Catmull-Clark: [stam_1998]. Loop: [loop_1987], one-rings have no face points.
Mode mode(LimitPatch patch, double theta) {
  const double c = std::cos(theta);
  if (patch == LimitPatch::box_spline) return {3.0 / 8.0 + c / 4.0, 0.0, 0.5};
  const double eigenvalue = (c + 5.0 + std::sqrt((c + 9.0) * (c + 1.0))) / 16.0;
  const double face = 1.0 / (4.0 * eigenvalue - 1.0);
  return {eigenvalue, face, (1.0 + face) / 4.0};
}

/// Smooth interior vertex of valence n: left eigenvectors of the double subdominant eigenvalue,
/// [halstead_1993]. For n = 2 the two are the differences of the edge ends and of the face ends.
TangentRows smooth_tangents(const OneRing& one, LimitPatch patch, int num_controls) {
  TangentRows t = TangentRows::Zero(2, num_controls);
  if (one.num_faces == 2) {
    t(0, one.edge_ends[0].value) += 1.0;
    t(0, one.edge_ends[1].value) -= 1.0;
    t(1, one.face_ends[0].value) += 1.0;
    t(1, one.face_ends[1].value) -= 1.0;
    return t;
  }
  const double theta = 2.0 * std::numbers::pi / one.num_faces;
  const double face = mode(patch, theta).face;
  for (std::size_t i = 0; i < one.edge_ends.size(); ++i) {
    const double a = theta * static_cast<double>(i);
    t(0, one.edge_ends[i].value) += 4.0 * std::cos(a);
    t(1, one.edge_ends[i].value) += 4.0 * std::sin(a);
  }
  for (std::size_t i = 0; i < one.face_ends.size(); ++i) {
    const double a = theta * static_cast<double>(i);
    t(0, one.face_ends[i].value) += face * (std::cos(a) + std::cos(a + theta));
    t(1, one.face_ends[i].value) += face * (std::sin(a) + std::sin(a + theta));
  }
  return t;
}

/// The faces of the sector that holds the ring's own face, between two sharp edges.
struct Sector {
  std::vector<VertexId> edge_ends, face_ends;
  [[nodiscard]] int num_faces() const { return static_cast<int>(edge_ends.size()) - 1; }
};

Sector own_sector(const OneRing& one) {
  const int num_faces = one.num_faces;
  const int num_edges = static_cast<int>(one.edge_ends.size());
  const auto sharp = [&](int i) {
    return is_sharp(one.edge_sharpness[static_cast<std::size_t>(i % num_edges)]);
  };
  int first = one.home;
  while (!sharp(first))
    first = (first + num_faces - 1) % num_faces;
  Sector sector;
  int i = first;
  do {
    sector.edge_ends.push_back(one.edge_ends[static_cast<std::size_t>(i % num_edges)]);
    if (!one.face_ends.empty())
      sector.face_ends.push_back(one.face_ends[static_cast<std::size_t>(i % num_faces)]);
    ++i;
  } while (!sharp(i));
  sector.edge_ends.push_back(one.edge_ends[static_cast<std::size_t>(i % num_edges)]);
  return sector;
}

/// Whether a mode fades at least as fast as the edges of a crease, whose eigenvalue is 1/2. If it is
/// 1/2 too, the two share a Jordan block in which the edges feed the mode: it lies in their plane.
bool fades(const Mode& m) {
  return m.eigenvalue <= 0.5 + 1e-12;
}

/// Crease or boundary vertex with k faces on this side: along the crease, with eigenvalue 1/2, and
/// across it, with the eigenvalue of the angle pi / k (docs/theory/limit.md derives the weights; the
/// masks of [biermann_2000] hold for their changed rules, where that eigenvalue is 1/2 too).
///
/// For k = 1 the direction into the face is that of the two crease edges' mean. From some k on (5 for
/// Catmull-Clark, 7 for Loop) the angle 2 pi / k has an eigenvalue above 1/2: normals tend to one
/// limit along the crease and to another from within, so there is none.
std::optional<TangentRows> crease_tangents(const Sector& s, LimitPatch patch, int num_controls) {
  TangentRows t = TangentRows::Zero(2, num_controls);
  const int k = s.num_faces();
  if (k > 2 && !fades(mode(patch, 2.0 * std::numbers::pi / k))) return {};
  t(0, s.edge_ends.front().value) += 0.5;
  t(0, s.edge_ends.back().value) -= 0.5;
  if (k == 1) {
    t(1, 0) -= 2.0;
    t(1, s.edge_ends.front().value) += 1.0;
    t(1, s.edge_ends.back().value) += 1.0;
    return t;
  }
  const double theta = std::numbers::pi / k;
  const Mode m = mode(patch, theta);
  const double sum = (4.0 + 2.0 * m.face) / std::tan(theta / 2.0);  // of the weights inside
  const double crease = (m.beside * std::sin(theta) - sum / 8.0) / (m.eigenvalue - 0.25);
  t(1, 0) -= 2.0 * crease + sum;
  t(1, s.edge_ends.front().value) += crease;
  t(1, s.edge_ends.back().value) += crease;
  for (std::size_t i = 1; i + 1 < s.edge_ends.size(); ++i)
    t(1, s.edge_ends[i].value) += 4.0 * std::sin(theta * static_cast<double>(i));
  for (std::size_t i = 0; i < s.face_ends.size(); ++i) {
    const double a = theta * static_cast<double>(i);
    t(1, s.face_ends[i].value) += m.face * (std::sin(a) + std::sin(a + theta));
  }
  return t;
}

/// Dart: no symmetry to use. The left eigenvectors of the two largest eigenvalues below 1 of the
/// one-ring's own matrix, oriented like the smooth ones.
std::optional<TangentRows> dart_tangents(const OneRing& one, LimitPatch patch,
                                         const SparseMatrix& A) {
  std::vector<VertexId> ids{VertexId(0)};
  ids.insert(ids.end(), one.edge_ends.begin(), one.edge_ends.end());
  ids.insert(ids.end(), one.face_ends.begin(), one.face_ends.end());
  const auto n = static_cast<Eigen::Index>(ids.size());
  MatrixX M(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      M(i, j) =
          A.coeff(ids[static_cast<std::size_t>(i)].value, ids[static_cast<std::size_t>(j)].value);
  const Eigen::EigenSolver<MatrixX> solver(M.transpose());
  const Eigen::MatrixXcd vectors = solver.eigenvectors();
  std::vector<Eigen::Index> order(ids.size());
  for (Eigen::Index i = 0; i < n; ++i)
    order[static_cast<std::size_t>(i)] = i;
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return solver.eigenvalues()(a).real() > solver.eigenvalues()(b).real();
  });
  TangentRows t = TangentRows::Zero(2, A.cols());
  for (int k = 0; k < 2; ++k) {
    const Eigen::VectorXcd v = vectors.col(order[static_cast<std::size_t>(k) + 1]);
    if (v.imag().norm() > 1e-9 * v.norm()) return {};
    for (Eigen::Index i = 0; i < n; ++i)
      t(k, ids[static_cast<std::size_t>(i)].value) += v(i).real();
  }
  // Orientation: on the plane regular polygon the smooth tangents are counter-clockwise.
  const TangentRows smooth = smooth_tangents(one, patch, static_cast<int>(A.cols()));
  Eigen::Matrix<double, Eigen::Dynamic, 2> polygon =
      Eigen::Matrix<double, Eigen::Dynamic, 2>::Zero(A.cols(), 2);
  const double theta = 2.0 * std::numbers::pi / one.num_faces;
  for (std::size_t i = 0; i < one.edge_ends.size(); ++i) {
    const double a = theta * static_cast<double>(i);
    polygon.row(one.edge_ends[i].value) << std::cos(a), std::sin(a);
  }
  for (std::size_t i = 0; i < one.face_ends.size(); ++i) {
    const double a = theta * static_cast<double>(i);
    polygon.row(one.face_ends[i].value) << std::cos(a) + std::cos(a + theta),
        std::sin(a) + std::sin(a + theta);
  }
  const Mat2 image = t * polygon;
  const Mat2 expected = smooth * polygon;
  if (image.determinant() * expected.determinant() < 0) t.row(1) = -t.row(1);
  return t;
}

}  // namespace

std::optional<TangentRows> corner_tangents(const Ring& ring, LimitPatch patch,
                                           const SparseMatrix& A) {
  const OneRing one = one_ring(ring);
  const int num_controls = ring.num_controls;
  const bool sharp_vertex =
      std::any_of(ring.features.vertices.begin(), ring.features.vertices.end(),
                  [](const SharpVertex& v) { return v.vertex == VertexId(0); });
  const float vertex_sharpness = sharp_vertex ? infinite_sharpness : 0.0F;
  switch (vertex_rule(vertex_sharpness, one.edge_sharpness)) {
    case VertexRule::smooth:
      return smooth_tangents(one, patch, num_controls);
    case VertexRule::dart:
      return dart_tangents(one, patch, A);
    case VertexRule::crease:
      return crease_tangents(own_sector(one), patch, num_controls);
    case VertexRule::corner:
      break;
  }
  const bool has_sector =
      std::count_if(one.edge_sharpness.begin(), one.edge_sharpness.end(), is_sharp) >= 2;
  if (!has_sector) return {};
  const Sector sector = own_sector(one);
  // Above two faces (Catmull-Clark) or three (Loop) the edges inside outlast those at the sides, and
  // no plane remains.
  if (!fades(mode(patch, std::numbers::pi / sector.num_faces()))) return {};
  TangentRows t = TangentRows::Zero(2, num_controls);
  t(0, 0) -= 1.0;
  t(0, sector.edge_ends.front().value) += 1.0;
  t(1, 0) -= 1.0;
  t(1, sector.edge_ends.back().value) += 1.0;
  return t;
}

}  // namespace limes
