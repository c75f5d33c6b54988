#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "limes/core/text.h"
#include "limes/report/canvas.h"

namespace limes {
namespace {

/// Hundredths of a pixel are enough, and short.
std::string coordinate(double x) {
  const double rounded = std::round(x * 100) / 100;
  return format_real(rounded == 0 ? 0.0 : rounded);
}

std::string point_list(std::span<const Vec2> points) {
  std::string result;
  for (const Vec2& p : points)
    result += fmt::format("{}{},{}", result.empty() ? "" : " ", coordinate(p[0]), coordinate(p[1]));
  return result;
}

std::string stroke_attributes(const Stroke& stroke) {
  return fmt::format(" stroke=\"{}\" stroke-width=\"{}\"{}", to_css(stroke.colour),
                     coordinate(stroke.width), stroke.dashed ? " stroke-dasharray=\"6 4\"" : "");
}

std::string paint_attributes(const Paint& paint) {
  return fmt::format(" fill=\"{}\"{}", paint.fill ? to_css(*paint.fill) : "none",
                     paint.stroke ? stroke_attributes(*paint.stroke) : "");
}

}  // namespace

std::string escape_markup(std::string_view text) {
  constexpr std::string_view replacement = "\uFFFD";
  std::string result;
  if (!is_valid_utf8(text)) {  // keep what is ASCII
    for (const char c : text)
      result += static_cast<unsigned char>(c) < 0x80 ? escape_markup({&c, 1}) : "\uFFFD";
    return result;
  }
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f)
          result += replacement;
        else
          result += c;
    }
  }
  return result;
}

void Canvas::line(const Vec2& a, const Vec2& b, const Stroke& stroke) {
  polyline(std::array{a, b}, stroke);
}

void Canvas::rectangle(const Vec2& corner, const Vec2& size, const Paint& paint) {
  polygon(std::array{corner, Vec2(corner + Vec2(size[0], 0)), Vec2(corner + size),
                     Vec2(corner + Vec2(0, size[1]))},
          paint);
}

SvgCanvas::SvgCanvas(double width, double height, std::string_view description, SvgForm form)
    : form_(form) {
  if (form == SvgForm::file)
    svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
  else
    svg_ = "<svg";
  svg_ += fmt::format(
      " width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n",
      coordinate(width), coordinate(height));
  svg_ += fmt::format("<title>{}</title>\n", escape_markup(description));
  rectangle({0, 0}, {width, height}, {palette::paper, {}});
}

void SvgCanvas::polyline(std::span<const Vec2> points, const Stroke& stroke) {
  svg_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-linejoin=\"round\"{}/>\n",
                      point_list(points), stroke_attributes(stroke));
}

void SvgCanvas::polygon(std::span<const Vec2> points, const Paint& paint) {
  svg_ += fmt::format("<polygon points=\"{}\"{}/>\n", point_list(points), paint_attributes(paint));
}

void SvgCanvas::circle(const Vec2& centre, double radius, const Paint& paint) {
  svg_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", coordinate(centre[0]),
                      coordinate(centre[1]), coordinate(radius), paint_attributes(paint));
}

void SvgCanvas::text(const Vec2& at, std::string_view label, const TextStyle& style) {
  const std::string x = coordinate(at[0]);
  const std::string y = coordinate(at[1]);
  svg_ += fmt::format("<text xml:space=\"preserve\" x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"",
                      x, y, coordinate(style.size), to_css(style.colour));
  if (style.anchor != Anchor::start)
    svg_ += fmt::format(" text-anchor=\"{}\"", style.anchor == Anchor::middle ? "middle" : "end");
  if (style.bold) svg_ += " font-weight=\"bold\"";
  if (style.upwards) svg_ += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
  svg_ += ">";
  double shift = 0;  // of the base line, upwards
  for (const TextRun& run : text_runs(label)) {
    const double wanted =
        run.level == 0 ? 0 : style.size * (run.level > 0 ? upper_shift : lower_shift);
    if (run.level == 0 && shift == 0) {
      svg_ += escape_markup(run.text);
    } else {
      svg_ += fmt::format(
          "<tspan dy=\"{}\" font-size=\"{}\">{}</tspan>", coordinate(shift - wanted),
          coordinate(style.size * (run.level == 0 ? 1 : script_size)), escape_markup(run.text));
    }
    shift = wanted;
  }
  svg_ += "</text>\n";
}

void SvgCanvas::image(const Vec2& corner, const Vec2& size, const Image& image) {
  const std::string data = "data:image/png;base64," + base64(encode_png(image));
  svg_ += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "{}=\"{}\"/>\n",
      coordinate(corner[0]), coordinate(corner[1]), coordinate(size[0]), coordinate(size[1]),
      form_ == SvgForm::file ? "xlink:href" : "href", data);
}

std::string SvgCanvas::finish() && {
  svg_ += "</svg>\n";
  return std::move(svg_);
}

}  // namespace limes
