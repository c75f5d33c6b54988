#include "limes/limit/surface_tree.h"

#include <cmath>
#include <numeric>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

/// Squares that are no patch are refined so often for their box.
constexpr int box_depth = 3;

std::vector<FaceId> all_faces(const Topology& topology) {
  std::vector<FaceId> faces;
  for (int f = 0; f < topology.num_faces(); ++f)
    faces.emplace_back(f);
  return faces;
}

std::vector<SurfaceTree::Item> quadrants(const LimitBasis& basis, std::span<const FaceId> faces) {
  if (faces.empty()) throw InputError("there is no face to search on; at least one is needed");
  std::vector<SurfaceTree::Item> items;
  for (const FaceId f : faces)
    for (int corner = 0; corner < basis.num_quadrants(f); ++corner)
      items.push_back({f, corner});
  return items;
}

/// Exponent of the largest coordinate among the points the items depend on.
int largest_exponent(const LimitBasis& basis, std::span<const Vec3> points,
                     std::span<const SurfaceTree::Item> items) {
  double largest = 0;
  for (const SurfaceTree::Item& item : items)
    for (const VertexId v : basis.controls(item.face)) {
      const Vec3& x = points[static_cast<std::size_t>(v.value)];
      if (!x.allFinite())
        throw InputError("vertex {}: ({}, {}, {}) is no point; finite numbers are right", v.value,
                         x[0], x[1], x[2]);
      largest = std::max(largest, x.cwiseAbs().maxCoeff());
    }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

std::vector<Vec3> scaled_points(std::span<const Vec3> points, int exponent) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& x : points)
    result.push_back(scaled(x, exponent));
  return result;
}

}  // namespace

Vec3 scaled(const Vec3& x, int exponent) {
  return {std::ldexp(x[0], exponent), std::ldexp(x[1], exponent), std::ldexp(x[2], exponent)};
}

SurfaceTree::SurfaceTree(const LimitBasis& basis, std::span<const Vec3> points)
    : SurfaceTree(basis, points, all_faces(basis.topology())) {}

SurfaceTree::SurfaceTree(const LimitBasis& basis, std::span<const Vec3> points,
                         std::span<const FaceId> faces)
    : items_(quadrants(basis, faces)),
      exponent_(largest_exponent(basis, points, items_)),
      points_(scaled_points(points, -exponent_)),
      squares_(basis, points_) {
  std::vector<Bounds> boxes(items_.size());
  for_each_block(
      static_cast<std::int64_t>(boxes.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        check_interrupt();
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          boxes[i] = squares_.bounds(squares_.root(items_[i].face, items_[i].corner), box_depth);
      });
  Bounds all;
  for (const Bounds& box : boxes) {
    all.lower = all.lower.cwiseMin(box.lower);
    all.upper = all.upper.cwiseMax(box.upper);
  }
  centre_ = 0.5 * (all.lower + all.upper);
  size_ = (all.upper - all.lower).norm();
  boxes_ = BoxTree(boxes);
}

}  // namespace limes
