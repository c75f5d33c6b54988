#include "limes/study/periodic_cell.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "limes/core/error.h"
#include "limes/limit/limit_surface.h"
#include "limes/space/boundary_trace.h"
#include "limes/study/supports.h"

namespace limes {
namespace {

/// One of the two directions in which the cell repeats.
struct Direction {
  int axis;  ///< 0: from left to right, 1: from bottom to top
  std::string_view low, high;
};
constexpr std::array directions{Direction{0, "left", "right"}, Direction{1, "bottom", "top"}};

class CellFinder {
 public:
  explicit CellFinder(const PlaneModel& model)
      : model_(model),
        adjacency_(model.adjacency()),
        surface_(model.space->geometry(), model.mesh().points.span()),
        tolerance_(1e-9 * model.diagonal),
        sides_(domain_sides(*model.space)) {
    for (const HalfedgeId h : sides_)
      box_.extend(start(h));
  }

  PeriodicCell find() {
    if (box_.isEmpty()) throw error("the mesh has no boundary");
    const Vec2 size = box_.sizes();
    PeriodicCell cell{size.x(), size.y(), {}};
    for (const Direction& d : directions)
      pair_sides(d, cell.pairs);
    return cell;
  }

 private:
  [[nodiscard]] Vec2 start(HalfedgeId h) const {
    return model_.limit_points[adjacency_.from(h)].head<2>();
  }
  [[nodiscard]] Vec2 end(HalfedgeId h) const {
    return model_.limit_points[adjacency_.to(h)].head<2>();
  }

  /// Boundary sides on the line axis = value, by the lower end along the line.
  [[nodiscard]] std::vector<HalfedgeId> sides_on(int axis, double value) const {
    std::vector<HalfedgeId> sides;
    for (const HalfedgeId h : sides_)
      if (std::abs(start(h)(axis) - value) <= tolerance_ &&
          std::abs(end(h)(axis) - value) <= tolerance_)
        sides.push_back(h);
    std::sort(sides.begin(), sides.end(), [&](HalfedgeId a, HalfedgeId b) {
      return low_end(a, 1 - axis) < low_end(b, 1 - axis);
    });
    return sides;
  }
  [[nodiscard]] double low_end(HalfedgeId h, int along) const {
    return std::min(start(h)(along), end(h)(along));
  }

  void pair_sides(const Direction& d, std::vector<PeriodicCell::Pair>& pairs) const {
    const auto low = sides_on(d.axis, box_.min()(d.axis));
    const auto high = sides_on(d.axis, box_.max()(d.axis));
    if (low.empty() || high.empty())
      throw error(
          "no boundary side lies on the {} of the cell's bounding box; the cell must be a "
          "rectangle (sharp corners: 't interpolateboundary 1/0/0 1')",
          low.empty() ? d.low : d.high);
    Vec2 shift = Vec2::Zero();
    shift(d.axis) = box_.sizes()(d.axis);
    for (std::size_t i = 0; i < std::max(low.size(), high.size()); ++i) {
      if (i >= low.size()) throw unmatched(high[i], d.high, d.low);
      if (i >= high.size()) throw unmatched(low[i], d.low, d.high);
      if (!match(low[i], high[i], shift)) throw unmatched(low[i], d.low, d.high);
      pairs.push_back({low[i], high[i]});
    }
  }

  /// Equal curves, point by point, one run through backwards.
  [[nodiscard]] bool match(HalfedgeId low, HalfedgeId high, const Vec2& shift) const {
    for (const double s : {0.0, 0.21, 0.5, 0.83, 1.0})
      if ((point(low, s) + shift - point(high, 1.0 - s)).norm() > 10.0 * tolerance_) return false;
    return true;
  }
  [[nodiscard]] Vec2 point(HalfedgeId h, double s) const {
    const SidePoint p = side_point(surface_.basis(), h, s);
    return surface_.position(adjacency_.face(h), p.corner, p.uv).head<2>();
  }

  template <class... Args>
  [[nodiscard]] InputError error(fmt::format_string<Args...> format, Args&&... args) const {
    return InputError("{}: periodic cell: {}", model_.problem.periodic->origin.table.text,
                      fmt::format(format, std::forward<Args>(args)...));
  }
  [[nodiscard]] InputError unmatched(HalfedgeId h, std::string_view here,
                                     std::string_view there) const {
    return error(
        "the side from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) on the {} has no partner on "
        "the {}; both boundaries need equal vertices",
        start(h).x(), start(h).y(), end(h).x(), end(h).y(), here, there);
  }

  const PlaneModel& model_;
  const Adjacency& adjacency_;
  LimitSurface surface_;
  double tolerance_;
  std::vector<HalfedgeId> sides_;
  Eigen::AlignedBox2d box_;
};

}  // namespace

PeriodicCell find_periodic_cell(const PlaneModel& model) {
  return CellFinder(model).find();
}

std::vector<ConstraintRow> periodic_constraints(const PlaneModel& model, const PeriodicCell& cell) {
  std::vector<ConstraintRow> rows;
  for (const PeriodicCell::Pair& pair : cell.pairs)
    for (ConstraintRow& row : on_both_components(tie_of_sides(*model.space, pair.low, pair.high)))
      rows.push_back(std::move(row));
  const int pinned = model.space->dofs(0)[0];
  rows.push_back({{2 * pinned, 1.0}});
  rows.push_back({{2 * pinned + 1, 1.0}});
  return rows;
}

}  // namespace limes
