#pragma once

#include "limes/report/canvas.h"
#include "limes/report/scene.h"

namespace limes {

enum class AxisScale { linear, logarithmic };

/// One curve. Points that are not finite, or not positive on a logarithmic axis, interrupt it.
struct Series {
  std::string name;
  std::vector<Vec2> points;
  std::optional<Colour> colour = {};  ///< empty: the next of palette::series
  bool markers = true;
  bool line = true;
  bool dashed = false;
};

/// A triangle that shows a rate: y goes like x to the power of `slope`. Both axes are logarithmic.
struct ReferenceSlope {
  double slope;
  int series = -1;  ///< the curve to stand by; -1: the one whose end is nearest to this slope
};

/// Curves over two axes. Labels may use canvas markup ("‖u − u_{h}‖") and should name units.
struct Plot {
  std::string title = {};
  std::string caption = {};
  std::string x_label = {};
  std::string y_label = {};
  AxisScale x_scale = AxisScale::linear;
  AxisScale y_scale = AxisScale::linear;
  std::vector<Series> series = {};
  std::vector<ReferenceSlope> slopes = {};
  double width = 640;
  double height = 430;  ///< without title and caption
};

/// A drawing in which labels, legend, slopes and curves keep clear of each other: the legend takes a
/// free corner or moves below the plot, and the axes grow until every slope has room.
/// @throws InputError if no series has a point that can be shown, or a slope names no series
[[nodiscard]] Drawing drawing(const Plot& plot);

/// (d) Errors over mesh sizes or unknowns, both logarithmic.
[[nodiscard]] Plot convergence_plot(std::string title, std::string x_label, std::string y_label,
                                    std::vector<Series> series, std::vector<ReferenceSlope> slopes);

}  // namespace limes
