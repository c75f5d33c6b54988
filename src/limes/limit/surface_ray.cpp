#include "limes/limit/surface_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/limit/patch_ray.h"

namespace limes {
namespace {

/// A ray in the tree's units and the frame (a, b, t) in which it is a = b = 0: unit direction, and
/// t counted from the point of the ray that is nearest to the surface's middle.
struct RayFrame {
  Vec3 origin;
  Mat3 axes;    ///< columns a, b, t; right-handed
  double unit;  ///< t of the user is `start` + t here times `unit`
  double start;

  RayFrame(const Ray& ray, const SurfaceTree& tree) {
    const double length = ray.direction.stableNorm();
    const Vec3 d = ray.direction / length;
    const Vec3 o = scaled(ray.origin, -tree.exponent()) - tree.centre();
    const double along = -o.dot(d);
    origin = tree.centre() + (o + along * d);
    Vec3 a = Vec3::Zero();  // across the smallest component
    int smallest = 0;
    d.cwiseAbs().minCoeff(&smallest);
    a[smallest] = 1.0;
    a = (a - d[smallest] * d).normalized();
    axes << a, d.cross(a), d;
    unit = std::ldexp(1.0 / length, tree.exponent());
    start = along * unit;
  }

  [[nodiscard]] double to_frame(double t) const { return (t - start) / unit; }
  [[nodiscard]] double from_frame(double t) const { return start + unit * t; }
};

/// The search for one ray.
class Search {
 public:
  Search(const SurfaceTree& tree, const RayFrame& frame, double t_min, double t_max)
      : squares_(tree.squares()), frame_(frame), first_(t_min, t_max, 0.5e-13 * tree.size()) {
    tree.traverse([&](const BoxTree::Boxes4& boxes) { return entries(boxes); },
                  [&] { return first_.largest(); },
                  [&](const SurfaceTree::Patch& patch) {
                    visit_patch(patch.bezier, patch.centre, patch.place);
                  },
                  [&](const SurfaceSquare& square) { visit(square); });
  }

  [[nodiscard]] const FirstSoFar& first() const { return first_; }

 private:
  /// Where the ray enters four boxes; NaN for those that it misses.
  [[nodiscard]] std::array<double, 4> entries(const BoxTree::Boxes4& boxes) const {
    std::array<double, 4> enter, leave;
    enter.fill(first_.smallest());
    leave.fill(first_.largest());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const double d = frame_.axes(i, 2);
      const double inverse = 1.0 / std::copysign(std::max(std::abs(d), 1e-300), d);
      for (std::size_t k = 0; k < 4; ++k) {
        const double s = (boxes.lower[axis][k] - first_.tolerance() - frame_.origin[i]) * inverse;
        const double t = (boxes.upper[axis][k] + first_.tolerance() - frame_.origin[i]) * inverse;
        enter[k] = std::max(enter[k], std::min(s, t));
        leave[k] = std::min(leave[k], std::max(s, t));
      }
    }
    // a part in 1e15 for the rounding of the products
    for (std::size_t k = 0; k < 4; ++k)
      if (enter[k] - 1e-15 * std::abs(enter[k]) > leave[k] + 1e-15 * std::abs(leave[k]))
        enter[k] = std::numeric_limits<double>::quiet_NaN();
    return enter;
  }

  void visit_patch(const BezierPatch& bezier, const Vec3& centre, const SquarePlace& place) {
    BezierPatch patch = bezier * frame_.axes;
    patch.rowwise() += (frame_.axes.transpose() * (centre - frame_.origin)).transpose();
    search_patch(patch, place, first_);
  }

  void visit(const SurfaceSquare& square) {
    if (squares_.is_patch(square))
      return visit_patch(squares_.patch(square), square.centre, square.place);
    const Vec3 centre = frame_.axes.transpose() * (square.centre - frame_.origin);
    const Bounds box = box_in_frame(square, centre);
    if (misses(box, square.place, first_)) return;
    if (squares_.is_self_similar(square) && (box.upper - box.lower).norm() <= first_.tolerance())
      return first_.offer(centre.z(), square.place, square.place.origin, centre,
                          side_at_corner(square));
    visit_children(square);
  }

  [[nodiscard]] Bounds box_in_frame(const SurfaceSquare& square, const Vec3& centre) const {
    Bounds box;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const auto [lower, upper] = squares_.range(square, square.controls * frame_.axes.col(axis));
      box.lower[axis] = centre[axis] + lower;
      box.upper[axis] = centre[axis] + upper;
    }
    return box;
  }

  void visit_children(const SurfaceSquare& square) {
    std::array<SurfaceSquare, 4> children;
    std::array<double, 4> entry;
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    for (std::size_t i = 0; i < 4; ++i) {
      children[i] = squares_.child(square, static_cast<int>(i));
      const auto t = frame_.axes.col(2);
      entry[i] = (children[i].centre - frame_.origin).dot(t) +
                 squares_.range(children[i], children[i].controls * t)[0];
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return entry[a] < entry[b]; });
    for (const std::size_t i : order)
      visit(children[i]);
  }

  [[nodiscard]] RayHit::Side side_at_corner(const SurfaceSquare& square) const {
    const auto& tangents = squares_.basis().kinds().refined(square.kind).tangents;
    if (!tangents) return RayHit::Side::edge_on;
    const Eigen::Matrix<double, 2, 3> t = *tangents * square.controls;
    const Vec3 normal = t.row(0).cross(t.row(1)).transpose();
    const double along = normal.dot(frame_.axes.col(2));
    if (std::abs(along) <= 1e-12 * t.row(0).norm() * t.row(1).norm()) return RayHit::Side::edge_on;
    return along < 0 ? RayHit::Side::front : RayHit::Side::back;
  }

  const SurfaceSquares& squares_;
  const RayFrame& frame_;
  FirstSoFar first_;
};

/// What is wrong with a ray; empty: nothing.
std::string defect(const Ray& ray) {
  if (!ray.origin.allFinite() || !ray.direction.allFinite())
    return "origin and direction must be finite";
  if (ray.direction.isZero(0.0)) return "the direction is 0";
  if (!(ray.t_min <= ray.t_max)) return fmt::format("t goes from {} to {}", ray.t_min, ray.t_max);
  return {};
}

std::optional<RayHit> search(const SurfaceTree& tree, const Ray& ray) {
  const RayFrame frame(ray, tree);
  if (!((frame.origin - tree.centre()).norm() <= tree.size())) return {};
  const Search search(tree, frame, frame.to_frame(ray.t_min), frame.to_frame(ray.t_max));
  const FirstSoFar& first = search.first();
  if (!first.found()) return {};
  RayHit hit;
  hit.t = std::clamp(frame.from_frame(first.t()), ray.t_min, ray.t_max);
  hit.face = first.place().face;
  hit.corner = first.place().corner;
  hit.uv = first.uv();
  hit.point = scaled(frame.origin + frame.axes * first.x(), tree.exponent());
  hit.side = first.side();
  return hit;
}

}  // namespace

std::optional<RayHit> first_hit(const SurfaceTree& tree, const Ray& ray) {
  const std::string wrong = defect(ray);
  if (!wrong.empty()) throw InputError("ray: {}", wrong);
  return search(tree, ray);
}

std::vector<std::optional<RayHit>> first_hits(const SurfaceTree& tree, std::span<const Ray> rays) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::string wrong = defect(rays[i]);
    if (!wrong.empty()) throw InputError("ray {}: {}", i, wrong);
  }
  std::vector<std::optional<RayHit>> hits(rays.size());
  for_each_block(
      static_cast<std::int64_t>(rays.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        check_interrupt();
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          hits[i] = search(tree, rays[i]);
      });
  return hits;
}

}  // namespace limes
