#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "limes/report/canvas.h"

namespace limes {
namespace {

/// How much of each pixel of a small area is covered, 0 to 1. Lines that cross within one mask do
/// not darken each other.
class Mask {
 public:
  /// An area that holds all points and `reach` around them, cut to the image.
  Mask(std::span<const TextLine> lines, double reach, const Image& image) {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (const TextLine& line : lines) {
      for (const Vec2& p : line.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
    const auto pixel = [](double x, int most) {
      return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(most)));
    };
    x0_ = pixel(low[0] - reach, image.width());
    y0_ = pixel(low[1] - reach, image.height());
    width_ = std::max(0, pixel(high[0] + reach + 1, image.width()) - x0_);
    height_ = std::max(0, pixel(high[1] + reach + 1, image.height()) - y0_);
    coverage_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  }

  /// A line with round ends; a pixel's cover falls off linearly over one pixel at its edge.
  void add_segment(const Vec2& a, const Vec2& b, double half_width) {
    const Vec2 d = b - a;
    const double length2 = d.squaredNorm();
    const double reach = half_width + 0.5;
    const auto range = [&](double low, double high, int first, int count) {
      return std::pair{std::max(0, static_cast<int>(std::floor(low - reach)) - first),
                       std::min(count, static_cast<int>(std::ceil(high + reach)) - first + 1)};
    };
    const auto [x_begin, x_end] = range(std::min(a[0], b[0]), std::max(a[0], b[0]), x0_, width_);
    const auto [y_begin, y_end] = range(std::min(a[1], b[1]), std::max(a[1], b[1]), y0_, height_);
    for (int y = y_begin; y < y_end; ++y) {
      for (int x = x_begin; x < x_end; ++x) {
        const Vec2 p = Vec2(x0_ + x + 0.5, y0_ + y + 0.5) - a;
        const double t = length2 > 0 ? std::clamp(p.dot(d) / length2, 0.0, 1.0) : 0;
        const double cover = std::min(reach - (p - t * d).norm(), std::min(1.0, 2 * half_width));
        raise(x, y, cover);
      }
    }
  }

  /// The inside of a closed line (even-odd), from 8 x 8 samples per pixel.
  void add_area(std::span<const Vec2> outline) {
    constexpr int n = 8;
    std::vector<double> crossings;
    for (int y = 0; y < height_; ++y) {
      for (int s = 0; s < n; ++s) {
        const double line = y0_ + y + (s + 0.5) / n;
        crossings.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
          const Vec2& a = outline[i];
          const Vec2& b = outline[(i + 1) % outline.size()];
          if ((a[1] <= line) == (b[1] <= line)) continue;
          crossings.push_back(a[0] + (line - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) - x0_);
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
          add_span(y, crossings[i], crossings[i + 1], 1.0 / n);
      }
    }
  }

  void blend_into(Image& image, const Colour& colour) const {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        image.blend(x0_ + x, y0_ + y, colour, coverage_[index(x, y)]);
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  void raise(int x, int y, double cover) {
    float& old = coverage_[index(x, y)];
    old = std::max(old, static_cast<float>(cover));
  }
  void add_span(int y, double from, double to, double weight) {
    const int first = std::max(0, static_cast<int>(std::floor(from)));
    const int last = std::min(width_ - 1, static_cast<int>(std::floor(to)));
    for (int x = first; x <= last; ++x) {
      const double part = std::min(to, x + 1.0) - std::max(from, static_cast<double>(x));
      if (part > 0) coverage_[index(x, y)] += static_cast<float>(weight * part);
    }
  }

  int x0_ = 0, y0_ = 0, width_ = 0, height_ = 0;
  std::vector<float> coverage_;
};

/// Cuts a polyline into dashes of 6 with gaps of 4.
std::vector<TextLine> dashes(std::span<const Vec2> points, double unit) {
  std::vector<TextLine> result{{{points.front()}}};
  double left = 6 * unit;
  bool drawn = true;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    Vec2 at = points[i];
    double length = (points[i + 1] - at).norm();
    while (length > left) {
      at += left / length * (points[i + 1] - at);
      length -= left;
      if (drawn)
        result.back().points.push_back(at);
      else
        result.push_back({{at}});
      drawn = !drawn;
      left = (drawn ? 6 : 4) * unit;
    }
    left -= length;
    if (drawn) result.back().points.push_back(points[i + 1]);
  }
  return result;
}

}  // namespace

ImageCanvas::ImageCanvas(double width, double height, double density)
    : density_(density),
      image_(static_cast<int>(std::lround(width * density)),
             static_cast<int>(std::lround(height * density))) {}

/// @param lines, width  in pixels
void ImageCanvas::stroke_lines(std::span<const TextLine> lines, double width,
                               const Colour& colour) {
  Mask mask(lines, width / 2 + 1, image_);
  for (const TextLine& line : lines) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
      mask.add_segment(line.points[i], line.points[i + 1], line.weight * width / 2);
  }
  mask.blend_into(image_, colour);
}

void ImageCanvas::fill(std::span<const Vec2> points, const Colour& colour) {
  const std::vector<TextLine> outline{{{points.begin(), points.end()}}};
  Mask mask(outline, 1, image_);
  mask.add_area(points);
  mask.blend_into(image_, colour);
}

void ImageCanvas::polyline(std::span<const Vec2> points, const Stroke& stroke) {
  if (points.empty()) return;
  std::vector<Vec2> scaled(points.begin(), points.end());
  for (Vec2& p : scaled)
    p *= density_;
  const auto lines =
      stroke.dashed ? dashes(scaled, density_) : std::vector<TextLine>{{std::move(scaled)}};
  stroke_lines(lines, stroke.width * density_, stroke.colour);
}

void ImageCanvas::polygon(std::span<const Vec2> points, const Paint& paint) {
  std::vector<Vec2> scaled(points.begin(), points.end());
  for (Vec2& p : scaled)
    p *= density_;
  if (paint.fill) fill(scaled, *paint.fill);
  if (paint.stroke) {
    std::vector<Vec2> closed(points.begin(), points.end());
    closed.push_back(points.front());
    polyline(closed, *paint.stroke);
  }
}

void ImageCanvas::circle(const Vec2& centre, double radius, const Paint& paint) {
  constexpr int corners = 48;
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  polygon(points, paint);
}

void ImageCanvas::text(const Vec2& at, std::string_view label, const TextStyle& style) {
  std::vector<TextLine> lines = stroke_text(label, style.size);
  const double width = text_width(label, style.size);
  const double start = style.anchor == Anchor::start    ? 0
                       : style.anchor == Anchor::middle ? -width / 2
                                                        : -width;
  for (TextLine& line : lines) {
    for (Vec2& p : line.points) {
      const Vec2 q(p[0] + start, -p[1]);  // on the canvas y points down
      p = density_ * (at + (style.upwards ? Vec2(q[1], -q[0]) : q));
    }
  }
  const double weight = style.size * (style.bold ? 0.125 : 0.082);
  stroke_lines(lines, weight * density_, style.colour);
}

/// Each pixel of the canvas takes the mean of the pixels below it, so figures in which both have
/// the same density copy exactly.
void ImageCanvas::image(const Vec2& corner, const Vec2& size, const Image& image) {
  const auto pixel = [&](double x) { return static_cast<int>(std::lround(x * density_)); };
  const int x0 = pixel(corner[0]), x1 = pixel(corner[0] + size[0]);
  const int y0 = pixel(corner[1]), y1 = pixel(corner[1] + size[1]);
  const auto source = [](int i, int count, int length) {
    const int first = static_cast<int>(static_cast<std::int64_t>(i) * length / count);
    const int end = static_cast<int>(static_cast<std::int64_t>(i + 1) * length / count);
    return std::pair{first, std::max(first + 1, end)};
  };
  for (int y = std::max(0, y0); y < std::min(y1, image_.height()); ++y) {
    const auto [sy0, sy1] = source(y - y0, y1 - y0, image.height());
    for (int x = std::max(0, x0); x < std::min(x1, image_.width()); ++x) {
      const auto [sx0, sx1] = source(x - x0, x1 - x0, image.width());
      unsigned sum[3] = {0, 0, 0};
      for (int sy = sy0; sy < sy1; ++sy)
        for (int sx = sx0; sx < sx1; ++sx)
          for (std::size_t c = 0; c < 3; ++c)
            sum[c] += image.pixel(sx, sy)[c];
      const auto count = static_cast<unsigned>((sy1 - sy0) * (sx1 - sx0));
      for (std::size_t c = 0; c < 3; ++c)
        image_.row(y)[3 * x + static_cast<int>(c)] =
            static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    }
  }
}

}  // namespace limes
