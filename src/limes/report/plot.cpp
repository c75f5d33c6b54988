#include "limes/report/plot.h"

#include <algorithm>
#include <cmath>

#include "limes/report/figure.h"
#include "limes/report/moved_canvas.h"
#include "limes/report/plot_layout.h"

namespace limes {
namespace {

constexpr Stroke grid_line{palette::rule, 0.9};
constexpr Stroke fine_line{Colour::hex(0xeceff2), 0.7};
constexpr Stroke frame_line{palette::ink, 1};
constexpr TextStyle tick_style{.size = plot_text_size};
constexpr double baseline = 0.36 * plot_text_size;  // from the middle of digits down to their foot
constexpr std::array marker_shapes{MarkerShape::disc, MarkerShape::square, MarkerShape::triangle,
                                   MarkerShape::diamond};

Colour colour_of(const Plot& plot, std::size_t series) {
  return plot.series[series].colour.value_or(palette::series[series % palette::series.size()]);
}

void draw_series_marker(Canvas& canvas, const Plot& plot, std::size_t series, const Vec2& at) {
  draw_marker(canvas, at, marker_shapes[series % marker_shapes.size()], 7.5,
              {colour_of(plot, series), Stroke{palette::paper, 1}});
}

void draw_grid(Canvas& canvas, const PlotLayout& layout) {
  const Box& f = layout.frame;
  const auto vertical = [&](double value, const Stroke& stroke) {
    const double x = f.left + layout.x.at(value) * f.width();
    canvas.line({x, f.top}, {x, f.bottom}, stroke);
  };
  const auto horizontal = [&](double value, const Stroke& stroke) {
    const double y = f.bottom - layout.y.at(value) * f.height();
    canvas.line({f.left, y}, {f.right, y}, stroke);
  };
  for (const double v : layout.x.minor())
    vertical(v, fine_line);
  for (const double v : layout.y.minor())
    horizontal(v, fine_line);
  for (const double v : layout.x_ticks.values)
    vertical(v, grid_line);
  for (const double v : layout.y_ticks.values)
    horizontal(v, grid_line);
}

std::string with_factor(const std::string& label, const Ticks& ticks) {
  if (ticks.exponent == 0) return label;
  return label.empty() ? ticks.factor() : label + " (" + ticks.factor() + ")";
}

void draw_axes(Canvas& canvas, const Plot& plot, const PlotLayout& layout) {
  const Box& f = layout.frame;
  canvas.rectangle({f.left, f.top}, {f.width(), f.height()}, {{}, frame_line});
  TextStyle style = tick_style;
  style.anchor = Anchor::middle;
  for (std::size_t i = 0; i < layout.x_ticks.values.size(); ++i) {
    const double x = f.left + layout.x.at(layout.x_ticks.values[i]) * f.width();
    canvas.line({x, f.bottom}, {x, f.bottom + 4}, frame_line);
    canvas.text({x, f.bottom + 8 + plot_text_size * 0.8}, layout.x_ticks.labels[i], style);
  }
  canvas.text({(f.left + f.right) / 2, f.bottom + 8 + plot_text_size * 2.4},
              with_factor(plot.x_label, layout.x_ticks), style);
  style.upwards = true;
  canvas.text({plot_margin + plot_text_size * 0.8, (f.top + f.bottom) / 2},
              with_factor(plot.y_label, layout.y_ticks), style);
  style.upwards = false;
  style.anchor = Anchor::end;
  for (std::size_t i = 0; i < layout.y_ticks.values.size(); ++i) {
    const double y = f.bottom - layout.y.at(layout.y_ticks.values[i]) * f.height();
    canvas.line({f.left - 4, y}, {f.left, y}, frame_line);
    canvas.text({f.left - 8, y + baseline}, layout.y_ticks.labels[i], style);
  }
}

void draw_curves(Canvas& canvas, const Plot& plot, const PlotLayout& layout) {
  for (std::size_t c = 0; c < layout.curves.size(); ++c) {
    const std::size_t s = layout.curve_series[c];
    if (plot.series[s].line && layout.curves[c].size() > 1)
      canvas.polyline(layout.curves[c], {colour_of(plot, s), 1.8, plot.series[s].dashed});
  }
  for (std::size_t c = 0; c < layout.curves.size(); ++c) {
    const std::size_t s = layout.curve_series[c];
    if (!plot.series[s].markers) continue;
    for (const Vec2& p : layout.curves[c])
      draw_series_marker(canvas, plot, s, p);
  }
}

void draw_slopes(Canvas& canvas, const PlotLayout& layout) {
  TextStyle style{.size = plot_text_size, .colour = palette::ink, .anchor = Anchor::middle};
  for (const SlopeTriangle& t : layout.slopes) {
    canvas.polygon(t.corners, {Colour::hex(0xf1f3f5), Stroke{palette::muted, 1.1}});
    const auto write = [&](const Box& box, const std::string& text) {
      canvas.text({(box.left + box.right) / 2, (box.top + box.bottom) / 2 + baseline}, text, style);
    };
    write(t.rise, t.rise_text);
    write(t.run, t.run_text);
  }
}

void draw_legend(Canvas& canvas, const Plot& plot, const PlotLayout& layout) {
  const Box& box = layout.legend;
  if (box.width() == 0) return;
  canvas.rectangle({box.left, box.top}, {box.width(), box.height()},
                   {palette::paper, Stroke{palette::rule, 1}});
  double y = box.top + 5 + legend_row / 2;
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const Series& series = plot.series[s];
    if (series.name.empty()) continue;
    const double from = box.left + 9, to = box.left + legend_sample - 5;
    if (series.line) canvas.line({from, y}, {to, y}, {colour_of(plot, s), 1.8, series.dashed});
    if (series.markers) draw_series_marker(canvas, plot, s, {(from + to) / 2, y});
    canvas.text({box.left + legend_sample + 3, y + baseline}, series.name, tick_style);
    y += legend_row;
  }
}

}  // namespace

Drawing drawing(const Plot& plot) {
  constexpr TextStyle title_style{.size = 16, .bold = true};
  constexpr TextStyle caption_style{.size = 13, .colour = palette::muted};
  constexpr double title_row = 23, caption_row = 19;
  const PlotLayout layout = lay_out(plot);
  const double text = layout.width - 2 * plot_margin;
  const auto title = wrap_text(plot.title, 1.1 * title_style.size, text);
  const auto caption = wrap_text(plot.caption, caption_style.size, text);
  const double top =
      title.empty() ? 0 : plot_margin - 4 + title_row * static_cast<double>(title.size());
  const double below = caption.empty() ? 0 : 6 + caption_row * static_cast<double>(caption.size());
  const auto draw = [=](Canvas& canvas) {
    for (std::size_t i = 0; i < title.size(); ++i)
      canvas.text({plot_margin, plot_margin + 12 + title_row * static_cast<double>(i)}, title[i],
                  title_style);
    MovedCanvas inner(canvas, {0, top});
    draw_grid(inner, layout);
    draw_curves(inner, plot, layout);
    draw_slopes(inner, layout);
    draw_axes(inner, plot, layout);
    draw_legend(inner, plot, layout);
    for (std::size_t i = 0; i < caption.size(); ++i)
      canvas.text({plot_margin, top + layout.height + 8 + caption_row * static_cast<double>(i)},
                  caption[i], caption_style);
  };
  return {layout.width, top + layout.height + below,
          plot.title.empty() ? plot.y_label + " over " + plot.x_label : plot.title, draw};
}

Plot convergence_plot(std::string title, std::string x_label, std::string y_label,
                      std::vector<Series> series, std::vector<ReferenceSlope> slopes) {
  return {.title = std::move(title),
          .x_label = std::move(x_label),
          .y_label = std::move(y_label),
          .x_scale = AxisScale::logarithmic,
          .y_scale = AxisScale::logarithmic,
          .series = std::move(series),
          .slopes = std::move(slopes)};
}

}  // namespace limes
