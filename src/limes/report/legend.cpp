#include "limes/report/legend.h"

namespace limes {
namespace {

constexpr double swatch_width = 18;
constexpr double swatch_height = 13;
constexpr double swatch_gap = 8;

void draw_entry(Canvas& canvas, const LegendEntry& entry, const Vec2& at) {
  const Vec2 middle = at + Vec2(swatch_width / 2, swatch_height / 2);
  const Stroke edge{palette::ink, 1};
  switch (entry.kind) {
    case LegendEntry::Kind::area:
      canvas.rectangle(at, {swatch_width, swatch_height}, {entry.colour, edge});
      break;
    case LegendEntry::Kind::line:
      canvas.line(middle - Vec2(swatch_width / 2, 0), middle + Vec2(swatch_width / 2, 0),
                  {entry.colour, entry.width});
      break;
    case LegendEntry::Kind::marker:
      draw_marker(canvas, middle, entry.shape, 10, {entry.colour, Stroke{palette::ink, 1.4}});
      break;
  }
  const TextStyle& style = figure_style::label;
  canvas.text({at[0] + swatch_width + swatch_gap, middle[1] + 0.36 * style.size}, entry.label,
              style);
}

}  // namespace

LegendLayout::LegendLayout(std::span<const LegendEntry> entries, double width) : entries_(entries) {
  if (entries.empty()) return;
  constexpr double gap = 22;
  const double size = figure_style::label.size;
  const double row = size * figure_style::line_height + 4;
  Vec2 at(0, 12);
  for (const LegendEntry& entry : entries) {
    // A viewer's font may be wider than ours.
    const double needed = swatch_width + swatch_gap + 1.12 * text_width(entry.label, size);
    if (at[0] > 0 && at[0] + needed > width) at = {0, at[1] + row};
    at_.push_back(at);
    at[0] += needed + gap;
  }
  height_ = at[1] + row;
}

void LegendLayout::draw(Canvas& canvas, const Vec2& corner) const {
  for (std::size_t i = 0; i < at_.size(); ++i)
    draw_entry(canvas, entries_[i], corner + at_[i]);
}

}  // namespace limes
