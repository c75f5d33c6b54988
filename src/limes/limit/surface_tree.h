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
/// Holds a box for every quadrant of a face, some 110 bytes; patches and what lies around
/// extraordinary vertices are worked out when a search comes there.
class SurfaceTree {
 public:
  struct Item {
    FaceId face;
    int corner;
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
  [[nodiscard]] const BoxTree& boxes() const { return boxes_; }
  [[nodiscard]] const Item& item(int i) const { return items_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] int exponent() const { return exponent_; }
  /// Of all boxes: middle and length of the diagonal, scaled.
  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] double size() const { return size_; }

 private:
  std::vector<Item> items_;
  int exponent_;
  std::vector<Vec3> points_;
  SurfaceSquares squares_;
  BoxTree boxes_;
  Vec3 centre_ = Vec3::Zero();
  double size_ = 0;
};

/// x * 2^exponent, exact but for overflow and underflow.
[[nodiscard]] Vec3 scaled(const Vec3& x, int exponent);

}  // namespace limes
