#include "limes/limit/surface_tree.h"

#include <cmath>
#include <numeric>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

/// Squares that are no patch are refined so often for their box.
constexpr int box_depth = 2;
/// Patches that are held: twice the faces' quadrants and these, which are 36 MB.
constexpr std::size_t more_patches = 65536;

std::vector<FaceId> all_faces(const Topology& topology) {
  std::vector<FaceId> faces;
  for (int f = 0; f < topology.num_faces(); ++f)
    faces.emplace_back(f);
  return faces;
}

/// Exponent of the largest coordinate among the points that faces depend on.
int largest_exponent(const LimitBasis& basis, std::span<const Vec3> points,
                     std::span<const FaceId> faces) {
  double largest = 0;
  for (const FaceId f : faces)
    for (const VertexId v : basis.controls(f)) {
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

/// Calls body(i) for [0, count) in parallel; can be interrupted.
template <class Body>
void for_each_square(std::size_t count, const Body& body) {
  for_each_block(static_cast<std::int64_t>(count), 64, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      body(i);
  });
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
    : quadrants_(quadrants(basis, faces)),
      exponent_(largest_exponent(basis, points, faces)),
      points_(scaled_points(points, -exponent_)),
      squares_(basis, points_) {
  add_roots();
  refine_rest();
  build_boxes();
}

std::vector<SurfaceTree::Quadrant> SurfaceTree::quadrants(const LimitBasis& basis,
                                                          std::span<const FaceId> faces) {
  if (faces.empty()) throw InputError("there is no face to search on; at least one is needed");
  std::vector<Quadrant> result;
  for (const FaceId f : faces)
    for (int corner = 0; corner < basis.num_quadrants(f); ++corner)
      result.push_back({f, corner});
  return result;
}

/// Moves those that are patches to patches_; returns the others.
std::vector<SurfaceSquare> SurfaceTree::sort_out(std::vector<SurfaceSquare> squares) {
  std::vector<std::size_t> slot(squares.size());
  std::size_t end = patches_.size();
  for (std::size_t i = 0; i < squares.size(); ++i)
    slot[i] = squares_.is_patch(squares[i]) ? end++ : 0;
  patches_.resize(end);
  for_each_square(squares.size(), [&](std::size_t i) {
    const SurfaceSquare& square = squares[i];
    if (squares_.is_patch(square))
      patches_[slot[i]] = {square.place, square.centre, squares_.patch(square)};
  });
  std::vector<SurfaceSquare> others;
  for (SurfaceSquare& square : squares)
    if (!squares_.is_patch(square)) others.push_back(std::move(square));
  return others;
}

void SurfaceTree::add_roots() {
  constexpr std::size_t piece = 1 << 14;  // of squares with their controls at a time
  std::vector<SurfaceSquare> squares;
  for (std::size_t begin = 0; begin < quadrants_.size(); begin += piece) {
    squares.resize(std::min(piece, quadrants_.size() - begin));
    for_each_square(squares.size(), [&](std::size_t i) {
      const Quadrant& q = quadrants_[begin + i];
      squares[i] = squares_.root(q.face, q.corner);
    });
    for (SurfaceSquare& square : sort_out(std::move(squares)))
      rest_.push_back(std::move(square));
    squares = {};
  }
}

/// Replaces the rest by its children, level by level, as long as the patches stay few; squares that
/// are tiny are left.
void SurfaceTree::refine_rest() {
  const std::size_t most = 2 * quadrants_.size() + more_patches;
  constexpr int max_depth = 12;
  for (int depth = 0; depth < max_depth; ++depth) {
    if (rest_.empty() || patches_.size() + 4 * rest_.size() > most) break;
    std::vector<SurfaceSquare> children(4 * rest_.size());
    for_each_square(rest_.size(), [&](std::size_t i) {
      for (std::size_t c = 0; c < 4; ++c)
        children[4 * i + c] = squares_.child(rest_[i], static_cast<int>(c));
    });
    rest_ = sort_out(std::move(children));
  }
}

void SurfaceTree::build_boxes() {
  std::vector<Bounds> boxes(patches_.size() + rest_.size());
  for_each_square(boxes.size(), [&](std::size_t i) {
    if (i >= patches_.size()) {
      boxes[i] = squares_.bounds(rest_[i - patches_.size()], box_depth);
      return;
    }
    const Patch& patch = patches_[i];
    boxes[i].lower = patch.centre + patch.bezier.colwise().minCoeff().transpose();
    boxes[i].upper = patch.centre + patch.bezier.colwise().maxCoeff().transpose();
  });
  Bounds all;
  for (const Bounds& box : boxes) {
    all.lower = all.lower.cwiseMin(box.lower);
    all.upper = all.upper.cwiseMax(box.upper);
  }
  centre_ = 0.5 * (all.lower + all.upper);
  size_ = (all.upper - all.lower).norm();
  boxes_ = BoxTree(boxes);
  for (SurfaceSquare& square : rest_)
    if (square.place.map.isIdentity(0.0)) square.controls.resize(0, 3);
}

}  // namespace limes
