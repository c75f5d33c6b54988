#include "limes/report/figure.h"

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"
#include "limes/report/axes_triad.h"
#include "limes/report/legend.h"
#include "limes/report/ticks.h"

namespace limes {
namespace {

using figure_style::bold_width;
using figure_style::line_height;
using figure_style::margin;
constexpr const TextStyle& title_style = figure_style::title;
constexpr const TextStyle& label_style = figure_style::label;
constexpr const TextStyle& caption_style = figure_style::caption;

constexpr double bar_width = 16;
constexpr double bar_gap = 24;
constexpr double tip_height = 12;
constexpr double axes_gap = 18;  // above the axes

/// Where the parts of a figure go.
class FigureLayout {
 public:
  explicit FigureLayout(const Figure& figure) : figure_(figure) {
    LIMES_ASSERT(!figure.image.empty() && figure.density > 0);
    if (figure.axes) axes_.emplace(*figure.axes);
    image_size_ = Vec2(figure.image.width(), figure.image.height()) / figure.density;
    lay_out_columns();
    double y = margin;
    if (!figure.title.empty()) {
      title_lines_ = wrap_text(figure.title, bold_width * title_style.size, content_width());
      title_y_ = y + title_style.size;
      y += static_cast<double>(title_lines_.size()) * title_style.size * line_height + 6;
    }
    image_corner_ = {margin, y};
    column_height_ =
        std::max(image_size_[1], (figure.bar ? bar_heading_height() + 120 : 0.0) + axes_height());
    y += column_height_;
    legend_y_ = y;
    legend_.emplace(figure.legend, content_width());
    y += legend_->height();
    if (!figure.caption.empty()) {
      caption_lines_ = wrap_text(figure.caption, caption_style.size, content_width());
      caption_y_ = y + 10 + caption_style.size;
      y += 10 + static_cast<double>(caption_lines_.size()) * caption_style.size * line_height;
    }
    height_ = std::ceil(y + margin);
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  void draw(Canvas& canvas) const {
    draw_lines(canvas, title_lines_, title_y_, title_style);
    canvas.image(image_corner_, image_size_, figure_.image);
    if (figure_.bar) draw_bar(canvas, *figure_.bar);
    if (axes_)
      axes_->draw(canvas, {image_corner_[0] + image_size_[0] + bar_gap,
                           image_corner_[1] + column_height_ - axes_->size()[1]});
    legend_->draw(canvas, {margin, legend_y_});
    draw_lines(canvas, caption_lines_, caption_y_, caption_style);
  }

 private:
  [[nodiscard]] double content_width() const { return width_ - 2 * margin; }
  [[nodiscard]] double bar_heading_height() const {
    return static_cast<double>(heading_.size()) * label_style.size * line_height + 8;
  }

  [[nodiscard]] double axes_height() const { return axes_ ? axes_->size()[1] + axes_gap : 0; }

  void lay_out_columns() {
    width_ = image_size_[0] + 2 * margin;
    double column = axes_ ? axes_->size()[0] : 0;
    if (figure_.bar) {
      const ColourBar& bar = *figure_.bar;
      ticks_ = linear_ticks(bar.scale.low, bar.scale.high, 9);
      heading_ = {bar.quantity};
      if (!bar.unit.empty()) heading_.push_back("in " + bar.unit);
      if (ticks_.exponent != 0) heading_.push_back(ticks_.factor());
      double texts = 0;
      for (const std::string& label : ticks_.labels)
        texts = std::max(texts, bar_width + 10 + text_width(label, label_style.size));
      for (const std::string& line : heading_)
        texts = std::max(texts, text_width(line, label_style.size));
      column = std::max(column, 1.12 * texts);  // a viewer's font may be wider than ours
    }
    if (column > 0) width_ += bar_gap + column;
    width_ = std::ceil(std::max(width_, 300.0));
  }

  void draw_lines(Canvas& canvas, const std::vector<std::string>& lines, double y,
                  const TextStyle& style) const {
    for (const std::string& line : lines) {
      canvas.text({margin, y}, line, style);
      y += style.size * line_height;
    }
  }

  void draw_bar(Canvas& canvas, const ColourBar& bar) const;

  const Figure& figure_;
  double width_ = 0, height_ = 0;
  std::vector<std::string> title_lines_, caption_lines_, heading_;
  double title_y_ = 0, caption_y_ = 0;
  Vec2 image_corner_, image_size_;
  double column_height_ = 0;  // of the image and of what stands right of it
  std::optional<AxesTriad> axes_;
  Ticks ticks_;
  std::optional<LegendLayout> legend_;
  double legend_y_ = 0;
};

/// The colours from high (top) to low, one row per pixel at twice the figure's resolution.
Image bar_image(const ColourScale& scale, double height) {
  const int rows = std::max(2, static_cast<int>(std::lround(2 * height)));
  Image image(2 * static_cast<int>(bar_width), rows);
  for (int y = 0; y < rows; ++y) {
    const Colour colour = scale.at_normalised(1 - (y + 0.5) / rows);
    for (int x = 0; x < image.width(); ++x)
      image.blend(x, y, colour, 1);
  }
  return image;
}

void FigureLayout::draw_bar(Canvas& canvas, const ColourBar& bar) const {
  const double left = image_corner_[0] + image_size_[0] + bar_gap;
  double top = image_corner_[1];
  for (const std::string& line : heading_) {
    canvas.text({left, top + label_style.size}, line, label_style);
    top += label_style.size * line_height;
  }
  top += 8 + (bar.tip_above ? tip_height : 4);
  const double space =
      image_corner_[1] + column_height_ - axes_height() - top - (bar.tip_below ? tip_height : 4);
  const double height = std::clamp(space, 90.0, 420.0);
  const Stroke outline{palette::muted, 0.8};
  canvas.image({left, top}, {bar_width, height}, bar_image(bar.scale, height));
  const auto tip = [&](double y, double direction, double end) {
    const std::array points{Vec2(left, y), Vec2(left + bar_width, y),
                            Vec2(left + bar_width / 2, y + direction * tip_height)};
    canvas.polygon(points, {bar.scale.at_normalised(end), outline});
  };
  if (bar.tip_above) tip(top, -1, 1);
  if (bar.tip_below) tip(top + height, 1, 0);
  canvas.rectangle({left, top}, {bar_width, height}, {{}, outline});
  for (std::size_t i = 0; i < ticks_.values.size(); ++i) {
    const double y = top + height * (1 - bar.scale.normalised(ticks_.values[i]));
    canvas.line({left + bar_width, y}, {left + bar_width + 4, y}, outline);
    canvas.text({left + bar_width + 8, y + 0.36 * label_style.size}, ticks_.labels[i], label_style);
  }
}

}  // namespace

Drawing drawing(const Figure& figure) {
  const FigureLayout size(figure);
  const std::string description = figure.title.empty() ? figure.caption : figure.title;
  return {size.width(), size.height(), description,
          [figure](Canvas& canvas) { FigureLayout(figure).draw(canvas); }};
}

void draw_marker(Canvas& canvas, const Vec2& centre, MarkerShape shape, double size,
                 const Paint& paint) {
  const double r = size / 2;
  const auto corners = [&](std::initializer_list<Vec2> points) {
    std::vector<Vec2> moved;
    for (const Vec2& p : points)
      moved.emplace_back(centre + r * p);
    canvas.polygon(moved, paint);
  };
  switch (shape) {
    case MarkerShape::disc:
      canvas.circle(centre, r, paint);
      break;
    case MarkerShape::ring:
      canvas.circle(centre, r, {{}, paint.stroke});
      break;
    case MarkerShape::square:
      corners({{-0.886, -0.886}, {0.886, -0.886}, {0.886, 0.886}, {-0.886, 0.886}});
      break;
    case MarkerShape::diamond:
      corners({{0, -1.2}, {1.2, 0}, {0, 1.2}, {-1.2, 0}});
      break;
    case MarkerShape::triangle:
      corners({{0, -1.24}, {1.074, 0.62}, {-1.074, 0.62}});
      break;
  }
}

}  // namespace limes
