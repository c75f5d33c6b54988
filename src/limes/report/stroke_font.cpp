#include "limes/report/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/report/stroke_glyphs.h"

namespace limes {
namespace {

constexpr double cap_height = 14;
constexpr double unit = 0.72 / cap_height;  // of the grid, per size

using Polylines = std::vector<std::vector<Vec2>>;

/// Turns a glyph's path into lines on the grid.
class PathReader {
 public:
  explicit PathReader(std::string_view path) : rest_(path) {}

  Polylines run() {
    for (std::string_view word = next_token(rest_); !word.empty(); word = next_token(rest_))
      command(word.front());
    return std::move(lines_);
  }

 private:
  double number() {
    const std::optional<double> value = parse_real(next_token(rest_));
    LIMES_ASSERT(value.has_value());
    return *value;
  }
  Vec2 point() {
    const double x = number();
    return {x, number()};
  }
  void command(char c) {
    switch (c) {
      case 'M':
        lines_.push_back({point()});
        break;
      case 'L':
        lines_.back().push_back(point());
        break;
      case 'D': {
        const Vec2 p = point();
        lines_.push_back({p - Vec2(0, 0.25), p + Vec2(0, 0.25)});
        break;
      }
      case 'Q':
        parabola();
        break;
      case 'A':
        lines_.emplace_back();
        arc();
        break;
      case 'a':
        arc();
        break;
      default:
        LIMES_ASSERT(!"unknown path command");
    }
  }
  void parabola() {
    const Vec2 from = lines_.back().back();
    const Vec2 control = point();
    const Vec2 to = point();
    constexpr int pieces = 8;
    for (int i = 1; i <= pieces; ++i) {
      const double t = static_cast<double>(i) / pieces;
      lines_.back().push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to);
    }
  }
  void arc() {
    const Vec2 centre = point();
    const Vec2 radii = point();
    const double from = number();
    const double to = number();
    const int pieces = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) / 15)));
    for (int i = 0; i <= pieces; ++i) {
      const double angle = (from + (to - from) * i / pieces) * std::numbers::pi / 180;
      lines_.back().push_back(centre + radii.cwiseProduct(Vec2(std::cos(angle), std::sin(angle))));
    }
  }

  std::string_view rest_;
  Polylines lines_;
};

/// Takes one character off UTF-8 text; a broken sequence is one unknown character per byte.
char32_t next_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xc0 ? 0
                             : lead < 0xe0 ? 2
                             : lead < 0xf0 ? 3
                                           : 4;
  char32_t character = length <= 1 ? lead : lead & (0x7fU >> length);
  bool good = length > 0 && length <= text.size();
  for (std::size_t i = 1; good && i < length; ++i) {
    good = (byte(i) & 0xc0U) == 0x80;
    character = character << 6 | (byte(i) & 0x3fU);
  }
  text.remove_prefix(good ? length : 1);
  return good ? character : 0xfffd;
}

/// Superscript digits as they come in units: m², N/mm².
std::string_view script_digit(std::string_view text) {
  if (text.starts_with("²")) return "2";
  if (text.starts_with("³")) return "3";
  if (text.starts_with("¹")) return "1";
  return {};
}

double run_width(const TextRun& run, double size) {
  double width = 0;
  for (std::string_view rest = run.text; !rest.empty();)
    width += find_glyph(next_character(rest)).advance;
  return width * unit * size * (run.level == 0 ? 1 : script_size);
}

}  // namespace

std::vector<TextRun> text_runs(std::string_view label) {
  std::vector<TextRun> runs;
  const auto add = [&](std::string_view text, int level) {
    if (runs.empty() || runs.back().level != level) runs.push_back({"", level});
    runs.back().text += text;
  };
  while (!label.empty()) {
    const std::size_t close = label.find('}');
    if ((label.starts_with("_{") || label.starts_with("^{")) && close != std::string_view::npos) {
      add(label.substr(2, close - 2), label.front() == '_' ? -1 : 1);
      label.remove_prefix(close + 1);
    } else if (const std::string_view digit = script_digit(label); !digit.empty()) {
      add(digit, 1);
      label.remove_prefix(2);
    } else {
      add(label.substr(0, 1), 0);
      label.remove_prefix(1);
    }
  }
  return runs;
}

std::vector<TextLine> stroke_text(std::string_view label, double size) {
  std::vector<TextLine> result;
  double x = 0;
  for (const TextRun& run : text_runs(label)) {
    const double share = run.level == 0 ? 1 : script_size;
    const double scale = unit * size * share;
    const double y = size * (run.level == 0 ? 0 : run.level > 0 ? upper_shift : lower_shift);
    for (std::string_view rest = run.text; !rest.empty();) {
      const Glyph& glyph = find_glyph(next_character(rest));
      for (std::vector<Vec2>& line : PathReader(glyph.path).run()) {
        for (Vec2& p : line)
          p = Vec2(x, y) + scale * p;
        result.push_back({std::move(line), (1 + share) / 2});
      }
      x += glyph.advance * scale;
    }
  }
  return result;
}

double text_width(std::string_view label, double size) {
  double width = 0;
  for (const TextRun& run : text_runs(label))
    width += run_width(run, size);
  return width;
}

std::vector<std::string> wrap_text(std::string_view text, double size, double width) {
  std::vector<std::string> lines;
  for (std::string_view word = next_token(text); !word.empty(); word = next_token(text)) {
    std::string longer = lines.empty() ? "" : lines.back() + " ";
    longer += word;
    if (lines.empty() || text_width(longer, size) > width) {
      lines.emplace_back(word);
    } else {
      lines.back() = std::move(longer);
    }
  }
  return lines;
}

}  // namespace limes
