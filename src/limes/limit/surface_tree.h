#pragma once

#include <memory>
#include <span>
#include <vector>

#include "limes/limit/box_tree.h"
#include "limes/limit/surface_squares.h"

namespace limes {

/// A limit surface made ready for searches: closest points (closest_point.h) and rays
/// (surface_ray.h). Built once, then only read, from any number of threads.
///
/// Holds patches, 550 bytes each with their boxes: one for every quadrant of a face that is one, and
/// around extraordinary vertices and features as many as twice the quadrants and 65,536 allow. What
/// is left there is worked out when a search comes to it.
class SurfaceTree {
 public:
  /// A bicubic patch; its coefficients are relative to centre.
  struct Patch {
    SquarePlace place;
    Vec3 centre;
    BezierPatch bezier;
  };

  /// Of all faces. Keeps a reference to the basis and a copy of the points.
  /// @param points  one per vertex of the basis
  /// @throws InputError if there is no face, or a face depends on a point that is not finite
  SurfaceTree(const LimitBasis& basis, std::span<const Vec3> points);
  /// Of some faces: without holes, say.
  SurfaceTree(const LimitBasis& basis, std::span<const Vec3> points, std::span<const FaceId> faces);

  // What searches need. They work in units of a power of two that makes the largest coordinate
  // about 1, so that squares neither overflow nor vanish: point = 2^exponent() times theirs.

  [[nodiscard]] const SurfaceSquares& squares() const { return squares_; }
  [[nodiscard]] int exponent() const { return exponent_; }
  /// Of all boxes: middle and length of the diagonal, scaled.
  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] double size() const { return size_; }

  /// Visits pieces of the surface in the order of their boxes (see BoxTree::traverse).
  /// @param on_patch   called with a const Patch&
  /// @param on_square  called with a SurfaceSquare that is no patch
  template <class BoundsOf, class Limit, class OnPatch, class OnSquare>
  void traverse(const BoundsOf& bounds, const Limit& limit, const OnPatch& on_patch,
                const OnSquare& on_square) const {
    boxes_.traverse(bounds, limit, [&](std::int32_t item) {
      const auto i = static_cast<std::size_t>(item);
      if (i < patches_.size()) return on_patch(patches_[i]);
      const SurfaceSquare& square = rest_[i - patches_.size()];
      if (square.controls.rows() > 0) return on_square(square);
      on_square(squares_.root(square.place.face, square.place.corner));
    });
  }

 private:
  struct Quadrant {
    FaceId face;
    int corner;
  };
  static std::vector<Quadrant> quadrants(const LimitBasis& basis, std::span<const FaceId> faces);
  [[nodiscard]] std::vector<SurfaceSquare> sort_out(std::vector<SurfaceSquare> squares);
  void add_roots();
  void refine_rest();
  void build_boxes();

  std::vector<Quadrant> quadrants_;
  int exponent_;
  std::vector<Vec3> points_;
  SurfaceSquares squares_;
  std::vector<Patch> patches_;
  std::vector<SurfaceSquare> rest_;  // a root without controls is gathered when it is visited
  BoxTree boxes_;
  Vec3 centre_ = Vec3::Zero();
  double size_ = 0;
};

/// x * 2^exponent, exact but for overflow and underflow.
[[nodiscard]] Vec3 scaled(const Vec3& x, int exponent);

}  // namespace limes
