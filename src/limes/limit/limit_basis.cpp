#include "limes/limit/limit_basis.h"

#include <array>
#include <string>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/limit/sub_face.h"
#include "limes/math/box_spline.h"
#include "limes/math/spline.h"
#include "limes/subdiv/refinement_step.h"

namespace limes {
namespace {

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
  const Split split = kinds.scheme().split;
  if (face_size != regular_face_size(kinds.scheme())) {  // an n-gon's children are its quadrants
    d.path.push_back(static_cast<char>(corner));
    d.kind = kinds.refined(kind).children[static_cast<std::size_t>(corner)].kind;
  }
  for (int depth = 0; !kinds[d.kind].patch; ++depth) {
    const RefinedKind& at = kinds.refined(d.kind);
    if (at.self_similar && (d.local.uv.isZero(0.0) || depth > LimitBasis::max_depth)) {
      d.extraordinary = true;
      return d;
    }
    const int c = child_at(split, d.local.uv);
    d.path.push_back(static_cast<char>(c));
    d.local = into_child(split, d.local, c);
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

/// Weights of the control points of a patch at a point: 16 or 12 rows. Columns: value, d/ds, d/dt,
/// d2/ds2, d2/dsdt, d2/dt2.
using PatchWeights = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, 16, 6>;

PatchWeights bicubic_weights(const Vec2& st, int order) {
  const CubicBSpline s = cubic_bspline(st.x());
  const CubicBSpline t = cubic_bspline(st.y());
  PatchWeights w(16, 6);
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto k = static_cast<Eigen::Index>(4 * j + i);
      w(k, 0) = s.value[i] * t.value[j];
      if (order < 1) continue;
      w(k, 1) = s.first[i] * t.value[j];
      w(k, 2) = s.value[i] * t.first[j];
      if (order < 2) continue;
      w(k, 3) = s.second[i] * t.value[j];
      w(k, 4) = s.first[i] * t.first[j];
      w(k, 5) = s.value[i] * t.second[j];
    }
  }
  return w;
}

PatchWeights patch_weights(LimitPatch patch, const Vec2& st, int order) {
  if (patch == LimitPatch::box_spline) return box_spline_coefficients() * quartic_bernstein(st);
  return bicubic_weights(st, order);
}

/// Derivatives in (u, v) from those in (s, t): the map is affine with Jacobian J.
void write_basis(const PatchWeights& w, const Tile& tile, const Mat2& J, int order, BasisAt& out) {
  const auto write = [&](auto&& to, const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 16>& row) {
    to.noalias() = tile.D.transpose() * row;
  };
  out.N.resize(tile.D.cols());
  write(out.N, w.col(0));
  out.N += tile.limit;
  out.dN.resize(order >= 1 ? tile.D.cols() : 0, 2);
  out.ddN.resize(order >= 2 ? tile.D.cols() : 0, 3);
  if (order >= 1)
    for (int a = 0; a < 2; ++a)
      write(out.dN.col(a), J(0, a) * w.col(1) + J(1, a) * w.col(2));
  if (order >= 2) {
    const auto second = [&](int to, int a, int b) {
      write(out.ddN.col(to), J(0, a) * J(0, b) * w.col(3) +
                                 (J(0, a) * J(1, b) + J(1, a) * J(0, b)) * w.col(4) +
                                 J(1, a) * J(1, b) * w.col(5));
    };
    second(0, 0, 0);
    second(1, 0, 1);
    second(2, 1, 1);
  }
}

}  // namespace

LimitBasis::LimitBasis(Topology topology, Features features, const Scheme& scheme,
                       Adjacency::Check check)
    : topology_(std::move(topology)),
      adjacency_(topology_, check),
      features_(std::move(features)),
      kinds_(scheme) {
  LIMES_ASSERT(check == Adjacency::Check::surface || scheme.reach == 0);
  if (!has_exact_limit(scheme))
    throw InputError("the limit surface of {} cannot be evaluated exactly", scheme.name);
  require_faces(topology_, scheme);
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

LimitBasis::FaceCorner LimitBasis::corner(FaceId f, int c) const {
  if (num_quadrants(f) > 1) return {c, Vec2(0, 0)};
  const auto i = static_cast<std::size_t>(c);
  return {0, on_triangles() ? triangle_corners[i] : square_corners[i]};
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
  write_basis(patch_weights(scheme().patch, d.local.uv, order), kinds_.tile(kind, d.path),
              d.local.J, order, out);
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

void require_squares(const Scheme& scheme, std::string_view what) {
  if (scheme.split == Split::triangles)
    throw InputError(
        "{} cannot be had with the triangles of {}; with catmull-clark and linear they can", what,
        scheme.name);
}

}  // namespace limes
