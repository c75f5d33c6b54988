#include "limes/report/axes_triad.h"

#include <algorithm>
#include <numeric>

#include "limes/report/legend.h"

namespace limes {
namespace {

constexpr double length = 30;      // of an axis at right angles to the line of sight
constexpr double head = 7;         // of an arrow
constexpr double label_gap = 10;   // from an axis' end to the middle of its letter
constexpr double label_reach = 7;  // around that middle
constexpr double least_seen = 4;   // a shorter axis has no arrow

constexpr std::array colours{palette::series[1], palette::series[2], palette::series[0]};
constexpr std::array<const char*, 3> names{"x", "y", "z"};

/// Where the letter of an axis goes that ends here: farther out, or clear of the others if it points to the eye.
Vec2 label_place(const Vec2& end, const Vec2& others) {
  if (end.norm() >= least_seen) return end + label_gap * end.normalized();
  return others.norm() > 0 ? Vec2(-label_gap * others.normalized()) : Vec2(label_gap, -label_gap);
}

}  // namespace

AxesTriad::AxesTriad(const Mat3& axes) : low_(-3, -3), high_(3, 3) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 axis = axes.col(static_cast<Eigen::Index>(i));
    ends_[i] = length * Vec2(axis.x(), -axis.y());
    towards_eye_[i] = axis.z();
  }
  const Vec2 sum = ends_[0] + ends_[1] + ends_[2];
  for (std::size_t i = 0; i < 3; ++i) {
    labels_[i] = label_place(ends_[i], sum - ends_[i]);
    low_ = low_.cwiseMin(labels_[i] - Vec2::Constant(label_reach));
    high_ = high_.cwiseMax(labels_[i] + Vec2::Constant(label_reach));
  }
}

void AxesTriad::draw_axis(Canvas& canvas, const Vec2& origin, int i) const {
  const auto at = static_cast<std::size_t>(i);
  const Stroke stroke{colours[at], 2};
  const Vec2 end = origin + ends_[at];
  if (const double seen = ends_[at].norm(); seen >= least_seen) {
    const Vec2 along = ends_[at] / seen;
    const Vec2 across(-along.y(), along.x());
    const Vec2 neck = end - std::min(head, seen) * along;
    canvas.line(origin, neck, stroke);
    canvas.polygon(std::array<Vec2, 3>{end, neck + 0.4 * head * across, neck - 0.4 * head * across},
                   {colours[at], {}});
  } else {
    const bool to_eye = towards_eye_[at] > 0;  // an arrow's tip, else its feathers
    canvas.circle(origin, 3.5, {to_eye ? colours[at] : palette::paper, stroke});
  }
  TextStyle style = figure_style::label;
  style.anchor = Anchor::middle;
  style.colour = colours[at];
  style.bold = true;
  canvas.text(origin + labels_[at] + Vec2(0, 0.3 * style.size), names[at], style);
}

void AxesTriad::draw(Canvas& canvas, const Vec2& corner) const {
  std::array<int, 3> order{0, 1, 2};  // the farthest end first
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return towards_eye_[static_cast<std::size_t>(a)] < towards_eye_[static_cast<std::size_t>(b)];
  });
  for (const int i : order)
    draw_axis(canvas, corner - low_, i);
}

}  // namespace limes
