#include "limes/report/figure_grid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "limes/core/error.h"
#include "limes/report/legend.h"
#include "limes/report/moved_canvas.h"

namespace limes {
namespace {

/// The legends of all figures, taken out of them. What several say is said once; an entry comes
/// before those that follow it in its own figure.
std::vector<LegendEntry> take_legends(std::vector<Figure>& figures) {
  std::vector<LegendEntry> all;
  for (Figure& figure : figures) {
    auto next = all.end();
    for (auto entry = figure.legend.rbegin(); entry != figure.legend.rend(); ++entry) {
      const auto known = std::find(all.begin(), all.end(), *entry);
      next = known != all.end() ? known : all.insert(next, *entry);
    }
    figure.legend.clear();
  }
  return all;
}

/// What is drawn where. Immutable once built: Drawing copies its function.
struct Placed {
  std::vector<Drawing> cells;
  std::vector<Vec2> corners;
  std::string title;
  std::vector<LegendEntry> legend;
  double width = 0, height = 0;
  double legend_y = 0;

  [[nodiscard]] double content_width() const { return width - 2 * figure_style::margin; }
};

double title_height(const std::string& title) {
  if (title.empty()) return 0;
  return figure_style::margin + figure_style::title.size * figure_style::line_height;
}

void place_cells(Placed& placed, std::size_t columns) {
  std::vector<double> widths(std::min(columns, placed.cells.size()), 0.0);
  for (std::size_t i = 0; i < placed.cells.size(); ++i)
    widths[i % columns] = std::max(widths[i % columns], placed.cells[i].width);
  const double row_width = std::accumulate(widths.begin(), widths.end(), 0.0);
  const double title_width =
      figure_style::bold_width * text_width(placed.title, figure_style::title.size);
  placed.width = std::ceil(std::max(row_width, title_width + 2 * figure_style::margin));

  double y = title_height(placed.title);
  for (std::size_t first = 0; first < placed.cells.size(); first += columns) {
    double x = 0;
    double height = 0;
    for (std::size_t i = first; i < std::min(first + columns, placed.cells.size()); ++i) {
      placed.corners.emplace_back(x, y);
      x += widths[i - first];
      height = std::max(height, placed.cells[i].height);
    }
    y += height;
  }
  placed.legend_y = y - figure_style::margin;  // the cells have a margin of their own
}

void draw_grid(Canvas& canvas, const Placed& placed) {
  using namespace figure_style;
  if (!placed.title.empty()) canvas.text({margin, margin + title.size}, placed.title, title);
  for (std::size_t i = 0; i < placed.cells.size(); ++i) {
    MovedCanvas cell(canvas, placed.corners[i]);
    placed.cells[i].draw(cell);
  }
  LegendLayout(placed.legend, placed.content_width()).draw(canvas, {margin, placed.legend_y});
}

}  // namespace

Drawing drawing(FigureGrid grid) {
  if (grid.figures.empty()) throw InputError("figure grid: no figures");
  if (grid.columns < 1) throw InputError("figure grid: {} columns, at least 1", grid.columns);
  auto placed = std::make_shared<Placed>();
  placed->title = std::move(grid.title);
  placed->legend = take_legends(grid.figures);
  for (const Figure& figure : grid.figures)
    placed->cells.push_back(drawing(figure));
  place_cells(*placed, static_cast<std::size_t>(grid.columns));
  placed->height = std::ceil(placed->legend_y + figure_style::margin +
                             LegendLayout(placed->legend, placed->content_width()).height());
  const std::string description =
      placed->title.empty() ? placed->cells.front().description : placed->title;
  return {placed->width, placed->height, description,
          [placed](Canvas& canvas) { draw_grid(canvas, *placed); }};
}

}  // namespace limes
