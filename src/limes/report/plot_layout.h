#pragma once

#include "limes/report/axis.h"

namespace limes {

/// A rectangle on the canvas.
struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  [[nodiscard]] bool contains(const Box& other) const {
    return left <= other.left && other.right <= right && top <= other.top && other.bottom <= bottom;
  }
  [[nodiscard]] Box grown(double by) const {
    return {left - by, top - by, right + by, bottom + by};
  }
};

/// A triangle of a reference slope with the numbers at its legs.
struct SlopeTriangle {
  std::array<Vec2, 3> corners;  ///< right angle in the middle one
  Box rise, run;                ///< around the texts
  std::string rise_text, run_text;
};

/// Where everything inside of a plot goes; the canvas' coordinates.
struct PlotLayout {
  Axis x, y;
  Ticks x_ticks, y_ticks;
  Box frame;
  std::vector<std::vector<Vec2>> curves;  ///< pieces of series, see `curve_series`
  std::vector<std::size_t> curve_series;
  Box legend;  ///< of zero size if there is none
  std::vector<SlopeTriangle> slopes;
  double width = 0, height = 0;  ///< of the plot without title and caption

  [[nodiscard]] Vec2 to_canvas(const Vec2& value) const {
    return {frame.left + x.at(value[0]) * frame.width(),
            frame.bottom - y.at(value[1]) * frame.height()};
  }
};

inline constexpr double plot_margin = 14;
inline constexpr double plot_text_size = 13;
inline constexpr double legend_row = 20;
inline constexpr double legend_sample = 38;  ///< room for the line and marker before a name

/// @throws InputError as drawing(Plot)
[[nodiscard]] PlotLayout lay_out(const Plot& plot);

}  // namespace limes
