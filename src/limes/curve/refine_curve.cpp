#include "limes/curve/refine_curve.h"

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

/// The points of a polygon, whatever the index: closed polygons repeat, open ones are reflected in
/// their ends.
class EndlessPolyline {
 public:
  explicit EndlessPolyline(const Polyline& line)
      : line_(&line), size_(static_cast<std::int64_t>(line.points.size())) {}

  [[nodiscard]] Vec3 operator()(std::int64_t i) const {
    if (line_->closed) return at(((i % size_) + size_) % size_);
    if (i < 0) return 2 * at(0) - (*this)(-i);
    if (i >= size_) return 2 * at(size_ - 1) - (*this)(2 * (size_ - 1) - i);
    return at(i);
  }

 private:
  [[nodiscard]] const Vec3& at(std::int64_t i) const {
    return line_->points[static_cast<std::size_t>(i)];
  }
  const Polyline* line_;
  std::int64_t size_;
};

/// Half of j, rounded down.
std::int64_t half(std::int64_t j) {
  return (j - (j % 2 != 0 && j < 0 ? 1 : 0)) / 2;
}

Vec3 new_point(const EndlessPolyline& coarse, const CurveMask& mask, std::int64_t j) {
  // a_{j - 2 i} for all i where it is a coefficient.
  const auto count = static_cast<std::int64_t>(mask.weights.size());
  Vec3 sum = Vec3::Zero();
  for (std::int64_t i = half(j - mask.first); j - 2 * i - mask.first < count; --i) {
    const double weight = mask.weights[static_cast<std::size_t>(j - 2 * i - mask.first)];
    if (weight != 0) sum += weight * coarse(i);
  }
  return sum;
}

/// The new points there are: from, and how many.
struct NewPoints {
  std::int64_t first, count;
};
NewPoints new_points(std::int64_t n, bool closed, const CurveMask& mask) {
  if (closed) return {0, 2 * n};
  if (mask.is_primal()) return {0, 2 * n - 1};
  const auto length = static_cast<std::int64_t>(mask.weights.size());
  return {mask.first + length - 2, 2 * n - length + 2};
}

}  // namespace

Polyline refine(const Polyline& coarse, const CurveScheme& scheme) {
  const int fewest = coarse.closed ? scheme.fewest_closed : scheme.fewest_open;
  if (static_cast<std::int64_t>(coarse.points.size()) < fewest)
    throw InputError("{} polyline with {} points; {} needs {}",
                     coarse.closed ? "a closed" : "an open", coarse.points.size(), scheme.name,
                     fewest);
  const EndlessPolyline points(coarse);
  const NewPoints made =
      new_points(static_cast<std::int64_t>(coarse.points.size()), coarse.closed, scheme.mask);
  Polyline fine;
  fine.closed = coarse.closed;
  fine.points.resize(static_cast<std::size_t>(made.count));
  for_each_block(made.count, 4096, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
      fine.points[static_cast<std::size_t>(i)] = new_point(points, scheme.mask, made.first + i);
  });
  if (!coarse.closed &&
      scheme.mask.is_primal()) {  // the reflection makes them equal but for rounding
    fine.points.front() = coarse.points.front();
    fine.points.back() = coarse.points.back();
  }
  return fine;
}

double refined_size(std::size_t num_points, bool closed, const CurveScheme& scheme, int levels) {
  // Twice as many each time, but for a constant where the polygon is open.
  const double less = closed ? 0
                      : scheme.mask.is_primal()
                          ? 1
                          : static_cast<double>(scheme.mask.weights.size()) - 2;
  return (static_cast<double>(num_points) - less) * std::ldexp(1.0, std::min(levels, 1000)) + less;
}

}  // namespace limes
