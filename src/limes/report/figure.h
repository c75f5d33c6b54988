#pragma once

#include "limes/report/canvas.h"
#include "limes/report/colour_map.h"
#include "limes/report/scene.h"

namespace limes {

/// The key to a field's colours.
struct ColourBar {
  ColourScale scale;
  std::string quantity = {};  ///< "σ_{xx}", see TextRun
  std::string unit = {};      ///< "N/mm²"; empty: none
  /// Values beyond an end occur (and have the end's colour): the bar gets a tip there.
  bool tip_below = false;
  bool tip_above = false;
};

struct LegendEntry {
  enum class Kind { area, line, marker };
  std::string label = {};
  Kind kind = Kind::area;
  Colour colour = palette::clay;  ///< of the area, the line, the marker's inside
  MarkerShape shape = MarkerShape::disc;
  double width = 1.6;  ///< of the line

  friend bool operator==(const LegendEntry&, const LegendEntry&) = default;
};

/// A rendered image with all that explains it.
struct Figure {
  Image image;
  double density = 2;  ///< pixels of the image per unit of the figure
  std::string title;   ///< may be empty, like all that follows
  std::string caption;
  std::optional<ColourBar> bar;     ///< right of the image
  std::vector<LegendEntry> legend;  ///< below the image
  /// Of the camera (Camera::axes): x, y, z are drawn right of the image, as it sees them.
  std::optional<Mat3> axes = {};
};

[[nodiscard]] Drawing drawing(const Figure& figure);

/// A marker as it appears in pictures and legends.
void draw_marker(Canvas& canvas, const Vec2& centre, MarkerShape shape, double size,
                 const Paint& paint);

}  // namespace limes
