#include "limes/report/axes_triad.h"

#include <algorithm>

#include "limes/report/legend.h"

namespace limes {
namespace {

constexpr double length = 30;       // of an axis at right angles to the line of sight
constexpr double head = 7;          // of an arrow
constexpr double label_gap = 10;    // from an axis' end to the middle of its letter
constexpr double label_reach = 7;   // around that middle
constexpr double label_apart = 13;  // between the middles of two letters
constexpr double least_seen = 4;    // a shorter axis has no arrow

constexpr std::array<const char*, 3> names{"x", "y", "z"};

/// Where the letter of an axis goes that ends here: farther out, or clear of the others if it points to the eye.
Vec2 label_place(const Vec2& end, const Vec2& others) {
  if (end.norm() >= least_seen) return end + label_gap * end.normalized();
  return others.norm() > 0 ? Vec2(-label_gap * others.normalized()) : Vec2(label_gap, -label_gap);
}

/// The axis with the nearest end first.
std::array<std::size_t, 3> nearest_first(const std::array<double, 3>& towards_eye) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return towards_eye[a] > towards_eye[b]; });
  return order;
}

/// Moves letters outwards that lie on the letters of nearer axes.
void separate(std::array<Vec2, 3>& labels, const std::array<std::size_t, 3>& order) {
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec2& label = labels[order[i]];
      const Vec2& nearer = labels[order[j]];
      if ((label - nearer).norm() < label_apart)
        label = (nearer.norm() + label_apart) * label.normalized();
    }
}

}  // namespace

AxesTriad::AxesTriad(const Mat3& axes) : low_(-3, -3), high_(3, 3) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 axis = axes.col(static_cast<Eigen::Index>(i));
    ends_[i] = length * Vec2(axis.x(), -axis.y());
    towards_eye_[i] = axis.z();
  }
  const Vec2 sum = ends_[0] + ends_[1] + ends_[2];
  for (std::size_t i = 0; i < 3; ++i)
    labels_[i] = label_place(ends_[i], sum - ends_[i]);
  separate(labels_, nearest_first(towards_eye_));
  for (const Vec2& label : labels_) {
    low_ = low_.cwiseMin(label - Vec2::Constant(label_reach));
    high_ = high_.cwiseMax(label + Vec2::Constant(label_reach));
  }
}

void AxesTriad::draw_axis(Canvas& canvas, const Vec2& origin, int i) const {
  const auto at = static_cast<std::size_t>(i);
  const Stroke stroke{axis_colours[at], 2};
  const Vec2 end = origin + ends_[at];
  if (const double seen = ends_[at].norm(); seen >= least_seen) {
    const Vec2 along = ends_[at] / seen;
    const Vec2 across(-along.y(), along.x());
    const Vec2 neck = end - std::min(head, seen) * along;
    canvas.line(origin, neck, stroke);
    canvas.polygon(std::array<Vec2, 3>{end, neck + 0.4 * head * across, neck - 0.4 * head * across},
                   {axis_colours[at], {}});
  } else {
    const bool to_eye = towards_eye_[at] > 0;  // an arrow's tip, else its feathers
    canvas.circle(origin, 3.5, {to_eye ? axis_colours[at] : palette::paper, stroke});
  }
  TextStyle style = figure_style::label;
  style.anchor = Anchor::middle;
  style.colour = axis_colours[at];
  style.bold = true;
  canvas.text(origin + labels_[at] + Vec2(0, 0.3 * style.size), names[at], style);
}

void AxesTriad::draw(Canvas& canvas, const Vec2& corner) const {
  const std::array<std::size_t, 3> order = nearest_first(towards_eye_);
  for (auto i = order.rbegin(); i != order.rend(); ++i)
    draw_axis(canvas, corner - low_, static_cast<int>(*i));
}

}  // namespace limes
