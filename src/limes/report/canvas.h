#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limes/report/image.h"
#include "limes/report/stroke_font.h"

namespace limes {

struct Stroke {
  Colour colour = palette::ink;
  double width = 1;
  bool dashed = false;
};

/// How an area looks: filled, outlined or both.
struct Paint {
  std::optional<Colour> fill;
  std::optional<Stroke> stroke;
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 13;
  Colour colour = palette::ink;
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees, read from the right
};

/// What figures and plots draw on: an SVG document or pixels, alike but for the font. The unit is
/// the CSS pixel, the origin the upper left corner, y points down.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void polyline(std::span<const Vec2> points, const Stroke& stroke) = 0;
  virtual void polygon(std::span<const Vec2> points, const Paint& paint) = 0;
  virtual void circle(const Vec2& centre, double radius, const Paint& paint) = 0;
  /// @param at  start, middle or end of the base line
  virtual void text(const Vec2& at, std::string_view label, const TextStyle& style) = 0;
  virtual void image(const Vec2& corner, const Vec2& size, const Image& image) = 0;

  void line(const Vec2& a, const Vec2& b, const Stroke& stroke);
  void rectangle(const Vec2& corner, const Vec2& size, const Paint& paint);
};

enum class SvgForm {
  file,   ///< a document of its own
  inside  ///< an element of an HTML page: no namespaces, they are implied there
};

/// Writes SVG 1.1 text that needs nothing else: images inside as PNG, fonts by their common names.
class SvgCanvas final : public Canvas {
 public:
  /// @param description  for people who cannot see the picture
  SvgCanvas(double width, double height, std::string_view description, SvgForm form);
  void polyline(std::span<const Vec2> points, const Stroke& stroke) override;
  void polygon(std::span<const Vec2> points, const Paint& paint) override;
  void circle(const Vec2& centre, double radius, const Paint& paint) override;
  void text(const Vec2& at, std::string_view label, const TextStyle& style) override;
  void image(const Vec2& corner, const Vec2& size, const Image& image) override;

  /// The document; the canvas is used up.
  [[nodiscard]] std::string finish() &&;

 private:
  SvgForm form_;
  std::string svg_;
};

/// Draws pixels, smoothed by exact distances; text in the stroke font.
class ImageCanvas final : public Canvas {
 public:
  /// @param density  pixels per unit
  ImageCanvas(double width, double height, double density);
  void polyline(std::span<const Vec2> points, const Stroke& stroke) override;
  void polygon(std::span<const Vec2> points, const Paint& paint) override;
  void circle(const Vec2& centre, double radius, const Paint& paint) override;
  void text(const Vec2& at, std::string_view label, const TextStyle& style) override;
  void image(const Vec2& corner, const Vec2& size, const Image& image) override;

  [[nodiscard]] Image finish() && { return std::move(image_); }

 private:
  void stroke_lines(std::span<const TextLine> lines, double width, const Colour& colour);
  void fill(std::span<const Vec2> points, const Colour& colour);

  double density_;
  Image image_;
};

/// Something to put on paper: its size and how to draw it. Figures and plots become one of these.
struct Drawing {
  double width = 0, height = 0;
  std::string description;
  std::function<void(Canvas&)> draw;
};

[[nodiscard]] std::string to_svg(const Drawing& drawing, SvgForm form = SvgForm::file);
[[nodiscard]] Image to_image(const Drawing& drawing, double density = 2);
/// Writes .svg or .png. @throws UsageError for another extension, OutputError
void write_drawing(const std::filesystem::path& file, const Drawing& drawing);

/// Text inside an XML or HTML element or a quoted attribute. Control characters and broken UTF-8
/// become U+FFFD.
[[nodiscard]] std::string escape_markup(std::string_view text);

}  // namespace limes
