#include "limes/limit/surface_squares.h"

#include <algorithm>
#include <array>

#include "limes/core/error.h"

namespace limes {
namespace {

/// Child c of a square in the square's parameters: where its corner 0 is, and its map.
SquarePlace child_place(const SquarePlace& parent, int c) {
  static const std::array<Vec2, 4> corners{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
  static const std::array<Mat2, 4> turns = [] {
    std::array<Mat2, 4> m;
    m[0] << 1, 0, 0, 1;
    m[1] << 0, -1, 1, 0;
    m[2] << -1, 0, 0, -1;
    m[3] << 0, 1, -1, 0;
    return m;
  }();
  const auto i = static_cast<std::size_t>(c);
  return {parent.face, parent.corner, parent.uv(corners[i]), parent.map * (0.5 * turns[i])};
}

/// Largest sum of a row's negative weights, without sign.
template <class Matrix>
double negative_part(const Matrix& rows) {
  double largest = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    double sum = 0;
    for (typename Matrix::InnerIterator it(rows, i); it; ++it)
      sum -= std::min(0.0, it.value());
    largest = std::max(largest, sum);
  }
  return largest;
}
double negative_part(const Eigen::Matrix<double, 16, Eigen::Dynamic>& rows) {
  return -rows.cwiseMin(0.0).rowwise().sum().minCoeff();
}

using Controls = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// out = A x, row by row; three columns at a time.
void multiply(const SparseMatrix& A, const Controls& x, Controls& out) {
  out.resize(A.rows(), 3);
  const int* const starts = A.outerIndexPtr();
  const int* const columns = A.innerIndexPtr();
  const double* const weights = A.valuePtr();
  const double* const x0 = x.col(0).data();
  const double* const x1 = x.col(1).data();
  const double* const x2 = x.col(2).data();
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    double sum0 = 0, sum1 = 0, sum2 = 0;
    for (int k = starts[i]; k < starts[i + 1]; ++k) {
      const double w = weights[k];
      const int j = columns[k];
      sum0 += w * x0[j];
      sum1 += w * x1[j];
      sum2 += w * x2[j];
    }
    out(i, 0) = sum0;
    out(i, 1) = sum1;
    out(i, 2) = sum2;
  }
}

}  // namespace

SurfaceSquares::SurfaceSquares(const LimitBasis& basis, std::span<const Vec3> points)
    : basis_(&basis), points_(points) {
  LIMES_ASSERT(static_cast<int>(points.size()) == basis.topology().num_vertices());
  require_squares(basis.scheme(), "closest points and rays");
  const std::vector<int> kinds = gather_kinds();
  const auto size = static_cast<std::size_t>(kinds.back()) + 1;
  bernstein_.resize(size);
  overshoot_.resize(size, 0.0);
  for (const int k : kinds)
    if (basis.kinds()[k].patch)
      bernstein_[static_cast<std::size_t>(k)] = bernstein_rows(*basis.kinds()[k].patch);
  find_overshoot(kinds);
}

/// The kinds of all squares below the faces, ascending; refined, so that searches only read.
std::vector<int> SurfaceSquares::gather_kinds() const {
  std::vector<int> kinds;
  std::vector<bool> known;
  const auto add = [&](int kind) {
    const auto k = static_cast<std::size_t>(kind);
    if (k >= known.size()) known.resize(k + 1, false);
    if (!known[k]) kinds.push_back(kind);
    known[k] = true;
  };
  for (int f = 0; f < basis_->topology().num_faces(); ++f)
    add(basis_->kind(FaceId(f)));
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (!basis_->kinds()[kinds[i]].patch)
      for (const RefinedKind::Child& child : basis_->kinds().refined(kinds[i]).children)
        add(child.kind);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

/// A value of a row with negative part n leaves a range of width 1 by at most n: the controls of a
/// child have a range of width 1 + 2 n, of which its surface leaves its own part.
void SurfaceSquares::find_overshoot(const std::vector<int>& kinds) {
  struct Step {
    std::size_t parent, child;
    double negative;
  };
  std::vector<Step> steps;
  for (const int kind : kinds) {
    const auto k = static_cast<std::size_t>(kind);
    if (basis_->kinds()[kind].patch) {
      const double n = negative_part(bernstein_[k]);
      overshoot_[k] = n > 1e-12 ? n : 0.0;  // rounding is none
      continue;
    }
    for (const RefinedKind::Child& child : basis_->kinds().refined(kind).children)
      steps.push_back({k, static_cast<std::size_t>(child.kind), negative_part(child.A)});
  }
  // Sharpness ends after a few steps, and with it the negative weights.
  constexpr int most_rounds = 100;
  bool changed = true;
  for (int round = 0; changed; ++round) {
    LIMES_ASSERT(round < most_rounds);
    changed = false;
    for (const Step& s : steps) {
      const double o = s.negative + (1.0 + 2.0 * s.negative) * overshoot_[s.child];
      if (o <= overshoot_[s.parent]) continue;
      overshoot_[s.parent] = o;
      changed = true;
    }
  }
}

SurfaceSquare SurfaceSquares::root(FaceId face, int corner) const {
  SurfaceSquare square;
  square.place = {face, 0, Vec2::Zero(), Mat2::Identity()};
  square.kind = basis_->kind(face);
  const auto ids = basis_->controls(face);
  const auto point = [&](VertexId v) { return points_[static_cast<std::size_t>(v.value)]; };
  square.centre = point(ids[0]);
  square.controls.resize(static_cast<Eigen::Index>(ids.size()), 3);
  Eigen::Index row = 0;
  for (const VertexId v : ids)
    square.controls.row(row++) = (point(v) - square.centre).transpose();
  if (basis_->topology().face_size(face) == 4) {
    if (is_self_similar(square)) move_to_limit(square);
    return square;
  }
  square = child(square, corner);  // a quadrant of a face that is no quad
  square.place = {face, corner, Vec2::Zero(), Mat2::Identity()};
  return square;
}

BezierPatch SurfaceSquares::patch(const SurfaceSquare& square) const {
  const auto& rows = bernstein_[static_cast<std::size_t>(square.kind)];
  BezierPatch sum = BezierPatch::Zero();
  for (Eigen::Index k = 0; k < rows.cols(); ++k)
    for (int d = 0; d < 3; ++d)
      sum.col(d) += square.controls(k, d) * rows.col(k);
  return sum;
}

SurfaceSquare SurfaceSquares::child(const SurfaceSquare& square, int i) const {
  const RefinedKind& kind = basis_->kinds().refined(square.kind);
  const RefinedKind::Child& step = kind.children[static_cast<std::size_t>(i)];
  SurfaceSquare child;
  child.place = child_place(square.place, i % 4);
  child.kind = step.kind;
  child.centre = square.centre;
  multiply(step.A, square.controls, child.controls);
  if (is_self_similar(child) && child.kind != square.kind) move_to_limit(child);
  return child;
}

void SurfaceSquares::move_to_limit(SurfaceSquare& square) const {
  const Eigen::RowVector3d limit =
      basis_->kinds().refined(square.kind).limit.transpose() * square.controls;
  square.controls.rowwise() -= limit;
  square.centre += limit.transpose();
}

Bounds SurfaceSquares::hull_box(const SurfaceSquare& square) const {
  Bounds box;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto [lower, upper] = range(square, square.controls.col(axis));
    box.lower[axis] = lower;
    box.upper[axis] = upper;
  }
  return box;
}

Bounds SurfaceSquares::bounds(const SurfaceSquare& square, int depth) const {
  Bounds box;
  if (is_patch(square) || depth == 0) {
    if (is_patch(square)) {
      const BezierPatch points = patch(square);
      box.lower = points.colwise().minCoeff().transpose();
      box.upper = points.colwise().maxCoeff().transpose();
    } else {
      box = hull_box(square);
    }
    box.lower += square.centre;
    box.upper += square.centre;
    return box;
  }
  for (int i = 0; i < 4; ++i) {
    const Bounds part = bounds(child(square, i), depth - 1);
    box.lower = box.lower.cwiseMin(part.lower);
    box.upper = box.upper.cwiseMax(part.upper);
  }
  return box;
}

}  // namespace limes
