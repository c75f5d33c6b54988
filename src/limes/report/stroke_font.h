#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limes/core/types.h"

namespace limes {

/// A piece of a label on one base line. Labels may say _{lower} and ^{upper}, as TeX does; all else
/// is plain UTF-8.
struct TextRun {
  std::string text;
  int level = 0;  ///< -1 lower, 0 normal, 1 upper
};
[[nodiscard]] std::vector<TextRun> text_runs(std::string_view label);

/// Lower and upper runs: their size, and how far their base line is shifted, as shares of the size
/// of the text.
inline constexpr double script_size = 0.72;
inline constexpr double upper_shift = 0.36;
inline constexpr double lower_shift = -0.18;

/// A line of a drawn character, and how thick it is relative to others: less in lower and upper runs.
struct TextLine {
  std::vector<Vec2> points;
  double weight = 1;
};

/// The label as lines: relative to the start of the base line, y upwards.
/// The font is drawn for limes: Latin letters, the Greek ones and the signs that engineers need; a
/// character that it lacks is an empty box.
/// @param size  as of other fonts: capital letters are 0.72 size high
[[nodiscard]] std::vector<TextLine> stroke_text(std::string_view label, double size);

/// Advance of the label, in the unit of `size`. SVG renderers choose a sans-serif font of about
/// this width.
[[nodiscard]] double text_width(std::string_view label, double size);

/// Breaks plain text at blanks into lines no wider than `width` where that is possible.
[[nodiscard]] std::vector<std::string> wrap_text(std::string_view text, double size, double width);

}  // namespace limes
