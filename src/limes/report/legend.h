#pragma once

#include <span>
#include <vector>

#include "limes/report/figure.h"

namespace limes {

/// What figures and grids of figures share: their margin and the styles of their texts.
namespace figure_style {
inline constexpr double margin = 16;
inline constexpr double line_height = 1.45;  ///< in sizes of the text
inline constexpr double bold_width = 1.1;    ///< a viewer's bold type is wider than our font
inline constexpr TextStyle title{.size = 17, .bold = true};
inline constexpr TextStyle label{.size = 13};
inline constexpr TextStyle caption{.size = 13, .colour = palette::muted};
}  // namespace figure_style

/// Places legend entries side by side, in a new line where one is full. Keeps a reference.
class LegendLayout {
 public:
  LegendLayout(std::span<const LegendEntry> entries, double width);

  /// 0 without entries.
  [[nodiscard]] double height() const { return height_; }
  /// @param corner  upper left
  void draw(Canvas& canvas, const Vec2& corner) const;

 private:
  std::span<const LegendEntry> entries_;
  std::vector<Vec2> at_;  // relative to the corner
  double height_ = 0;
};

}  // namespace limes
