#include "limes/report/plot_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limes/core/error.h"
#include "limes/report/clearance.h"

namespace limes {
namespace {

constexpr double clearance = 7;  // between curves and what stands by them

std::array<Vec2, 4> outline(const Box& box) {
  return {Vec2(box.left, box.top), Vec2(box.right, box.top), Vec2(box.right, box.bottom),
          Vec2(box.left, box.bottom)};
}

class PlotLayouter {
 public:
  explicit PlotLayouter(const Plot& plot) : plot_(plot) { find_axes(); }

  PlotLayout run() {
    const Axis y = out_.y;
    constexpr double step = 0.1;
    constexpr int most_steps = 12;
    for (int i = 0; i <= most_steps; ++i) {
      out_.y = i == 0 ? y : y.grown(step * i);
      arrange();
      if (!place_legend()) place_legend_below();
      if (place_slopes()) break;
    }
    return std::move(out_);
  }

 private:
  void find_axes();
  void arrange();
  void choose_x_ticks();
  void make_curves();
  [[nodiscard]] Vec2 legend_size() const;
  bool place_legend();
  void place_legend_below();
  bool place_slopes();
  [[nodiscard]] std::size_t series_for(const ReferenceSlope& slope) const;
  [[nodiscard]] bool place_slope(const ReferenceSlope& slope);
  [[nodiscard]] SlopeTriangle triangle_at(const ReferenceSlope& slope, const Vec2& corner,
                                          bool below) const;
  [[nodiscard]] bool fits(const SlopeTriangle& triangle) const;

  const Plot& plot_;
  PlotLayout out_;
};

void PlotLayouter::find_axes() {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  const auto shows = [](AxisScale scale, double v) {
    return std::isfinite(v) && (scale == AxisScale::linear || v > 0);
  };
  for (const Series& s : plot_.series) {
    for (const Vec2& p : s.points) {
      if (!shows(plot_.x_scale, p[0]) || !shows(plot_.y_scale, p[1])) continue;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  if (!(low[0] <= high[0]))
    throw InputError(
        "plot '{}': no point can be shown; coordinates must be finite, and positive "
        "on logarithmic axes",
        plot_.title);
  out_.x = Axis(plot_.x_scale, low[0], high[0]);
  out_.y = Axis(plot_.y_scale, low[1], high[1]);
}

/// Finds the frame: what the labels leave.
void PlotLayouter::arrange() {
  out_.width = plot_.width;
  out_.height = plot_.height;
  Box& frame = out_.frame;
  frame.top = plot_margin;
  const double label_height = plot_text_size * 1.6;
  frame.bottom =
      plot_.height - plot_margin - label_height - (plot_.x_label.empty() ? 0 : label_height);
  out_.y_ticks = out_.y.ticks(std::max(2, static_cast<int>(frame.height() / 42)));
  double widest = 0;
  for (const std::string& label : out_.y_ticks.labels)
    widest = std::max(widest, text_width(label, plot_text_size));
  frame.left = plot_margin + (plot_.y_label.empty() ? 0 : label_height) + 1.1 * widest + 10;
  frame.right = plot_.width - plot_margin - 8;
  choose_x_ticks();
  make_curves();
}

/// As many ticks as fit side by side.
void PlotLayouter::choose_x_ticks() {
  for (int most = std::max(2, static_cast<int>(out_.frame.width() / 60)); most >= 2; --most) {
    out_.x_ticks = out_.x.ticks(most);
    double last = -1e9;
    bool free = true;
    for (std::size_t i = 0; i < out_.x_ticks.values.size(); ++i) {
      const double half = 1.1 * text_width(out_.x_ticks.labels[i], plot_text_size) / 2;
      const double at = out_.frame.left + out_.x.at(out_.x_ticks.values[i]) * out_.frame.width();
      free = free && at - half > last + 10;
      last = at + half;
    }
    if (free) return;
  }
}

void PlotLayouter::make_curves() {
  out_.curves.clear();
  out_.curve_series.clear();
  for (std::size_t s = 0; s < plot_.series.size(); ++s) {
    bool open = false;
    for (const Vec2& p : plot_.series[s].points) {
      const bool shown = out_.x.shows(p[0]) && out_.y.shows(p[1]);
      if (shown && (!open || !plot_.series[s].line)) {
        out_.curves.emplace_back();
        out_.curve_series.push_back(s);
      }
      if (shown) out_.curves.back().push_back(out_.to_canvas(p));
      open = shown;
    }
  }
}

Vec2 PlotLayouter::legend_size() const {
  double widest = 0;
  std::size_t count = 0;
  for (const Series& s : plot_.series) {
    if (s.name.empty()) continue;
    widest = std::max(widest, text_width(s.name, plot_text_size));
    ++count;
  }
  if (count == 0) return Vec2::Zero();
  return {legend_sample + 1.12 * widest + 18, legend_row * static_cast<double>(count) + 10};
}

bool PlotLayouter::place_legend() {
  const Vec2 size = legend_size();
  out_.legend = {};
  if (size[0] == 0) return true;
  constexpr double inset = 10;
  const Box& f = out_.frame;
  const double left = f.left + inset, right = f.right - inset - size[0];
  const double top = f.top + inset, bottom = f.bottom - inset - size[1];
  for (const Vec2& at :
       {Vec2(right, top), Vec2(left, top), Vec2(left, bottom), Vec2(right, bottom)}) {
    const Box box{at[0], at[1], at[0] + size[0], at[1] + size[1]};
    if (f.contains(box) && is_clear(out_.curves, outline(box), clearance + 3)) {
      out_.legend = box;
      return true;
    }
  }
  return false;
}

void PlotLayouter::place_legend_below() {
  const Vec2 size = legend_size();
  const double left = out_.frame.left, top = plot_.height - plot_margin + 8;
  out_.legend = {left, top, left + size[0], top + size[1]};
  out_.width = std::max(out_.width, out_.legend.right + plot_margin);
  out_.height = out_.legend.bottom + plot_margin;
}

bool PlotLayouter::place_slopes() {
  out_.slopes.clear();
  return std::all_of(plot_.slopes.begin(), plot_.slopes.end(),
                     [&](const ReferenceSlope& slope) { return place_slope(slope); });
}

/// The series whose last two points have the slope nearest to this one.
std::size_t PlotLayouter::series_for(const ReferenceSlope& slope) const {
  const auto count = static_cast<int>(plot_.series.size());
  if (slope.series >= count)
    throw InputError("plot '{}': a slope stands by series {}, there are {}", plot_.title,
                     slope.series, count);
  if (slope.series >= 0) return static_cast<std::size_t>(slope.series);
  std::size_t best = out_.curve_series.front();
  double best_error = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < out_.curves.size(); ++c) {
    const std::vector<Vec2>& points = plot_.series[out_.curve_series[c]].points;
    if (out_.curves[c].size() < 2) continue;
    const Vec2& a = points[points.size() - 2];
    const Vec2& b = points.back();
    const double error = std::abs(std::log(b[1] / a[1]) / std::log(b[0] / a[0]) - slope.slope);
    if (error < best_error) {
      best = out_.curve_series[c];
      best_error = error;
    }
  }
  return best;
}

/// A triangle whose hypotenuse starts at `corner` and runs to the right along the slope; the right
/// angle lies below it or above it.
SlopeTriangle PlotLayouter::triangle_at(const ReferenceSlope& slope, const Vec2& corner,
                                        bool below) const {
  const Box& f = out_.frame;
  const double x_decades = std::log10(out_.x.value(1) / out_.x.value(0));
  const double y_decades = std::log10(out_.y.value(1) / out_.y.value(0));
  const double steepness = slope.slope * x_decades / f.width() * f.height() / y_decades;
  const double run = std::min(0.14 * f.width(), 0.22 * f.height() / std::abs(steepness));
  const Vec2 end = corner + Vec2(run, -run * steepness);
  const bool rises = end[1] < corner[1];
  SlopeTriangle t;
  t.corners = {corner, below == rises ? Vec2(end[0], corner[1]) : Vec2(corner[0], end[1]), end};
  t.rise_text = format_readable(std::abs(slope.slope), 3);
  t.run_text = "1";
  const auto box_at = [](const Vec2& middle, std::string_view text) {
    const Vec2 half(0.56 * text_width(text, plot_text_size), 0.42 * plot_text_size);
    return Box{middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1]};
  };
  const double side = below == rises ? 1 : -1;  // the vertical leg is at the right or left end
  const double rise_gap = 6 + 0.56 * text_width(t.rise_text, plot_text_size);
  t.rise = box_at({t.corners[1][0] + side * rise_gap, (corner[1] + end[1]) / 2}, t.rise_text);
  t.run = box_at({corner[0] + run / 2, t.corners[1][1] + (below ? 11 : -11)}, t.run_text);
  return t;
}

bool PlotLayouter::fits(const SlopeTriangle& t) const {
  const auto bounds = [](const SlopeTriangle& triangle) {
    Box box{triangle.corners[0][0], triangle.corners[0][1], triangle.corners[0][0],
            triangle.corners[0][1]};
    const auto add = [&](const Box& b) {
      box = {std::min(box.left, b.left), std::min(box.top, b.top), std::max(box.right, b.right),
             std::max(box.bottom, b.bottom)};
    };
    for (const Vec2& c : triangle.corners)
      add({c[0], c[1], c[0], c[1]});
    add(triangle.rise);
    add(triangle.run);
    return box;
  };
  const Box box = bounds(t);
  if (!out_.frame.contains(box.grown(5)) || box.grown(6).overlaps(out_.legend)) return false;
  for (const SlopeTriangle& other : out_.slopes)
    if (box.grown(6).overlaps(bounds(other))) return false;
  return is_clear(out_.curves, t.corners, clearance) &&
         is_clear(out_.curves, outline(t.rise), clearance - 2) &&
         is_clear(out_.curves, outline(t.run), clearance - 2);
}

/// Tries places along the curve from its end, closest ones first, below before above; then any.
bool PlotLayouter::place_slope(const ReferenceSlope& slope) {
  if (plot_.x_scale != AxisScale::logarithmic || plot_.y_scale != AxisScale::logarithmic)
    throw InputError("plot '{}': slopes need two logarithmic axes", plot_.title);
  const std::size_t series = series_for(slope);
  const auto try_at = [&](const Vec2& corner, bool below) {
    SlopeTriangle t = triangle_at(slope, corner, below);
    if (!fits(t)) return false;
    out_.slopes.push_back(std::move(t));
    return true;
  };
  for (double offset = 10; offset <= 60; offset += 5) {
    for (std::size_t c = out_.curves.size(); c-- > 0;) {
      if (out_.curve_series[c] != series) continue;
      const std::vector<Vec2>& curve = out_.curves[c];
      for (std::size_t i = curve.size(); i-- > 1;) {
        for (const double t : {0.75, 0.5, 0.25, 0.0}) {
          const Vec2 at = curve[i - 1] + t * (curve[i] - curve[i - 1]);
          if (try_at(at + Vec2(0, offset), true) || try_at(at - Vec2(0, offset), false))
            return true;
        }
      }
    }
  }
  for (double y = out_.frame.bottom; y > out_.frame.top; y -= 10)
    for (double x = out_.frame.left; x < out_.frame.right; x += 10)
      if (try_at({x, y}, true)) return true;
  return false;
}

}  // namespace

PlotLayout lay_out(const Plot& plot) {
  return PlotLayouter(plot).run();
}

}  // namespace limes
