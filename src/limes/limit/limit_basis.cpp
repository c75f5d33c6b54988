#include "limes/limit/limit_basis.h"

#include <array>
#include <string>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/math/spline.h"

namespace limes {
namespace {

/// The parameters of a point in a sub-face, and how they depend on those of the face.
struct LocalPoint {
  Vec2 uv;
  Mat2 J = Mat2::Identity();  ///< d(local)/d(face)
};

/// Turns the frame so that corner c becomes the origin, u towards corner c + 1.
LocalPoint turned_to(const LocalPoint& p, int c) {
  const double u = p.uv.x();
  const double v = p.uv.y();
  const Eigen::RowVector2d du = p.J.row(0);
  const Eigen::RowVector2d dv = p.J.row(1);
  LocalPoint q;
  switch (c) {
    case 0:
      return p;
    case 1:
      q.uv = {v, 1.0 - u};
      q.J << dv, -du;
      return q;
    case 2:
      q.uv = {1.0 - u, 1.0 - v};
      q.J << -du, -dv;
      return q;
    default:
      q.uv = {1.0 - v, u};
      q.J << -dv, du;
      return q;
  }
}

/// Quadrant of the unit square that holds a point; borders belong to the higher corner index side
/// that is farther from corner 0, so that only corner 0 itself stays with child 0 forever.
int quadrant_of(const Vec2& uv) {
  const bool right = uv.x() > 0.5;
  const bool top = uv.y() > 0.5;
  if (right) return top ? 2 : 1;
  return top ? 3 : 0;
}

LocalPoint into_child(const LocalPoint& p, int c) {
  LocalPoint q = turned_to(p, c);
  q.uv *= 2.0;
  q.J *= 2.0;
  return q;
}

/// Where the descent from a face to a patch ended.
struct Descent {
  std::string path;
  LocalPoint local;
  int kind = 0;
  bool extraordinary = false;  ///< at corner 0 of a self-similar kind
};

Descent descend(const RingKinds& kinds, int kind, int face_size, int corner, const Vec2& uv) {
  Descent d;
  d.kind = kind;
  d.local.uv = uv;
  if (face_size != 4) {  // the first children of an n-gon are its quadrants
    d.path.push_back(static_cast<char>(corner));
    d.kind = kinds.refined(kind).children[static_cast<std::size_t>(corner)].kind;
  }
  for (int depth = 0; !kinds[d.kind].patch; ++depth) {
    const RefinedKind& at = kinds.refined(d.kind);
    if (at.self_similar && (d.local.uv.isZero(0.0) || depth > LimitBasis::max_depth)) {
      d.extraordinary = true;
      return d;
    }
    const int c = quadrant_of(d.local.uv);
    d.path.push_back(static_cast<char>(c));
    d.local = into_child(d.local, c);
    d.kind = at.children[static_cast<std::size_t>(c)].kind;
  }
  return d;
}

/// A row of weights on the controls of the kind at the end of a path, pulled back to its start.
VectorX pull_back(const RingKinds& kinds, int kind, const std::string& path, const VectorX& row) {
  std::vector<const SparseMatrix*> steps;
  for (const char c : path) {
    const RefinedKind::Child& child = kinds.refined(kind).children[static_cast<std::size_t>(c)];
    steps.push_back(&child.A);
    kind = child.kind;
  }
  VectorX result = row;
  for (auto it = steps.rbegin(); it != steps.rend(); ++it)
    result = (*it)->transpose() * result;
  return result;
}

/// Bicubic weights of the 16 patch points at (s, t), and their derivatives in s and t.
struct PatchWeights {
  Eigen::Matrix<double, 1, 16> N, Ns, Nt, Nss, Nst, Ntt;
};

PatchWeights patch_weights(const Vec2& st, int order) {
  const CubicBSpline s = cubic_bspline(st.x());
  const CubicBSpline t = cubic_bspline(st.y());
  PatchWeights w;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto k = static_cast<Eigen::Index>(4 * j + i);
      w.N(k) = s.value[i] * t.value[j];
      if (order < 1) continue;
      w.Ns(k) = s.first[i] * t.value[j];
      w.Nt(k) = s.value[i] * t.first[j];
      if (order < 2) continue;
      w.Nss(k) = s.second[i] * t.value[j];
      w.Nst(k) = s.first[i] * t.first[j];
      w.Ntt(k) = s.value[i] * t.second[j];
    }
  }
  return w;
}

/// Derivatives in (u, v) from those in (s, t): the map is affine with Jacobian J.
void write_basis(const PatchWeights& w, const Tile& tile, const Mat2& J, int order, BasisAt& out) {
  out.N = (w.N * tile.D).transpose();
  out.N += tile.limit;
  out.dN.resize(order >= 1 ? tile.D.cols() : 0, 2);
  out.ddN.resize(order >= 2 ? tile.D.cols() : 0, 3);
  if (order >= 1) {
    const auto combine = [&](double a, double b) {
      return Eigen::Matrix<double, 1, 16>(a * w.Ns + b * w.Nt);
    };
    out.dN.col(0) = (combine(J(0, 0), J(1, 0)) * tile.D).transpose();
    out.dN.col(1) = (combine(J(0, 1), J(1, 1)) * tile.D).transpose();
  }
  if (order >= 2) {
    const auto combine = [&](int a, int b) {
      return Eigen::Matrix<double, 1, 16>(J(0, a) * J(0, b) * w.Nss +
                                          (J(0, a) * J(1, b) + J(1, a) * J(0, b)) * w.Nst +
                                          J(1, a) * J(1, b) * w.Ntt);
    };
    out.ddN.col(0) = (combine(0, 0) * tile.D).transpose();
    out.ddN.col(1) = (combine(0, 1) * tile.D).transpose();
    out.ddN.col(2) = (combine(1, 1) * tile.D).transpose();
  }
}

}  // namespace

LimitBasis::LimitBasis(Topology topology, Features features, const Scheme& scheme)
    : topology_(std::move(topology)),
      adjacency_(topology_),
      features_(std::move(features)),
      kinds_(scheme) {
  if (!has_exact_limit(scheme))
    throw InputError("the limit surface of {} cannot be evaluated exactly", scheme.name);
  gather_kinds();
}

LimitBasis::~LimitBasis() = default;

/// Most faces of most meshes have the same plain ring, whose controls are found directly and in
/// parallel; the others are gathered and looked up one by one.
void LimitBasis::gather_kinds() {
  const Sharpness sharpness(adjacency_, features_);
  const Scheme& scheme = kinds_.scheme();
  const bool travels = features_.crease_method == CreaseMethod::chaikin && !features_.edges.empty();
  const bool may_be_plain = scheme.reach == 1 && !travels;
  const auto num_faces = static_cast<std::size_t>(topology_.num_faces());
  std::vector<std::array<VertexId, 16>> plain(may_be_plain ? num_faces : 0);
  if (may_be_plain)
    for_each_index(topology_.num_faces(), [&](std::int64_t f) {
      const auto ring = plain_ring(adjacency_, sharpness, FaceId(f));
      if (ring) plain[static_cast<std::size_t>(f)] = *ring;
    });

  kind_.resize(num_faces);
  first_control_.reserve(num_faces + 1);
  controls_.reserve(16 * num_faces);
  first_control_.push_back(0);
  int plain_kind = -1;
  for (std::size_t i = 0; i < num_faces; ++i) {
    if (i % 256 == 0) check_interrupt();
    const FaceId f(static_cast<std::int64_t>(i));
    const bool is_plain = may_be_plain && plain[i][0].valid();
    if (is_plain && plain_kind >= 0) {
      controls_.insert(controls_.end(), plain[i].begin(), plain[i].end());
      kind_[f] = plain_kind;
    } else {
      Ring ring = gather_ring(adjacency_, features_, sharpness, scheme, f);
      controls_.insert(controls_.end(), ring.vertices.begin(),
                       ring.vertices.begin() + ring.num_controls);
      ring.vertices.resize(static_cast<std::size_t>(ring.num_controls));
      kind_[f] = kinds_.kind_of(std::move(ring));
      if (is_plain) plain_kind = kind_[f];
    }
    first_control_.push_back(static_cast<std::int64_t>(controls_.size()));
  }
}

std::span<const VertexId> LimitBasis::controls(FaceId f) const {
  const auto i = static_cast<std::size_t>(f.value);
  return std::span(controls_).subspan(
      static_cast<std::size_t>(first_control_[i]),
      static_cast<std::size_t>(first_control_[i + 1] - first_control_[i]));
}

LimitBasis::Point LimitBasis::evaluate_kind(int kind, int face_size, int corner, const Vec2& uv,
                                            int order, BasisAt& out) const {
  const Descent d = descend(kinds_, kind, face_size, corner, uv);
  if (d.extraordinary) {
    out.N = pull_back(kinds_, kind, d.path, kinds_.refined(d.kind).limit);
    out.dN.resize(0, 2);
    out.ddN.resize(0, 3);
    return Point::extraordinary;
  }
  write_basis(patch_weights(d.local.uv, order), kinds_.tile(kind, d.path), d.local.J, order, out);
  return Point::ordinary;
}

std::optional<Eigen::Matrix<double, 2, Eigen::Dynamic>> LimitBasis::tangent_rows(
    FaceId f, int corner, const Vec2& uv) const {
  const Descent d = descend(kinds_, kind_[f], topology_.face_size(f), corner, uv);
  LIMES_ASSERT(d.extraordinary);
  const auto& tangents = kinds_.refined(d.kind).tangents;
  if (!tangents) return {};
  Eigen::Matrix<double, 2, Eigen::Dynamic> rows(2, static_cast<Eigen::Index>(controls(f).size()));
  for (int k = 0; k < 2; ++k)
    rows.row(k) = pull_back(kinds_, kind_[f], d.path, tangents->row(k).transpose()).transpose();
  return rows;
}

}  // namespace limes
