#pragma once

#include <array>
#include <span>
#include <vector>

#include "limes/limit/bezier_patch.h"
#include "limes/limit/limit_basis.h"
#include "limes/mesh/measure.h"

namespace limes {

/// A square of a face's parameters and where its own parameters lie: (u, v) = origin + map (s, t).
struct SquarePlace {
  FaceId face;
  int corner = 0;
  Vec2 origin = Vec2::Zero();
  Mat2 map = Mat2::Identity();

  [[nodiscard]] Vec2 uv(const Vec2& st) const { return origin + map * st; }
};

/// A square with the control points of its ring.
struct SurfaceSquare {
  SquarePlace place;
  int kind = 0;
  Vec3 centre = Vec3::Zero();
  /// (num_controls of the kind, 3), relative to centre. If the kind is self-similar, centre is the
  /// limit of its corner (0, 0): differences keep their precision however small the square is.
  Eigen::Matrix<double, Eigen::Dynamic, 3> controls;
};

/// A limit surface as a forest of squares: the roots are the faces' quadrants; a square is either
/// one bicubic patch or has four children (see RefinedKind).
class SurfaceSquares {
 public:
  /// Keeps references.
  /// @param points  one per vertex of the basis
  SurfaceSquares(const LimitBasis& basis, std::span<const Vec3> points);

  [[nodiscard]] const LimitBasis& basis() const { return *basis_; }
  [[nodiscard]] SurfaceSquare root(FaceId face, int corner) const;

  [[nodiscard]] bool is_patch(const SurfaceSquare& square) const {
    return bernstein_[static_cast<std::size_t>(square.kind)].cols() > 0;
  }
  [[nodiscard]] bool is_self_similar(const SurfaceSquare& square) const {
    return !is_patch(square) && basis_->kinds().refined(square.kind).self_similar;
  }
  /// Coefficients relative to the square's centre. Precondition: is_patch(square)
  [[nodiscard]] BezierPatch patch(const SurfaceSquare& square) const;
  /// The child at corner i of the square. Precondition: not is_patch(square)
  [[nodiscard]] SurfaceSquare child(const SurfaceSquare& square, int i) const;

  /// Bounds of a linear function over the surface of a square, from its values at the controls.
  ///
  /// Where the scheme's weights are not negative they are the least and the largest value: the
  /// surface lies in the convex hull of the controls. Chaikin creases have negative weights in a
  /// sharpness's last step; then the bounds are widened by what those can add.
  template <class Values>
  [[nodiscard]] std::array<double, 2> range(const SurfaceSquare& square,
                                            const Values& values) const {
    const double lower = values.minCoeff(), upper = values.maxCoeff();
    const double more = overshoot_[static_cast<std::size_t>(square.kind)] * (upper - lower);
    return {lower - more, upper + more};
  }
  /// The same for x, y and z: a box relative to the square's centre.
  [[nodiscard]] Bounds hull_box(const SurfaceSquare& square) const;

  /// A box around the surface over a square; squares that are no patch are refined `depth` times
  /// to make it tighter.
  [[nodiscard]] Bounds bounds(const SurfaceSquare& square, int depth) const;

 private:
  [[nodiscard]] std::vector<int> gather_kinds() const;
  void find_overshoot(const std::vector<int>& kinds);
  void move_to_limit(SurfaceSquare& square) const;

  const LimitBasis* basis_;
  std::span<const Vec3> points_;
  /// By kind: Bernstein coefficients as combinations of the controls; no columns if no patch.
  std::vector<Eigen::Matrix<double, 16, Eigen::Dynamic>> bernstein_;
  /// By kind: how far the surface can leave the range of the controls, in parts of the range.
  std::vector<double> overshoot_;
};

}  // namespace limes
