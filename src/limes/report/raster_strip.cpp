#include <limits>

#include "limes/report/raster_shader.h"

namespace limes::raster {
namespace {

using Sample = std::array<std::uint8_t, 3>;

/// Samples whose centres lie in an interval, cut to [from, to).
struct SampleRange {
  int begin, end;
  SampleRange(double low, double high, int from, int to)
      : begin(std::max(from, static_cast<int>(std::ceil(std::max(low, -1e8) - 0.5)))),
        end(std::min(to, static_cast<int>(std::floor(std::min(high, 1e8) - 0.5)) + 1)) {}
};

/// The line through p and q: 0 on it, > 0 on the inner side (in units of the grid, squared).
/// A sample exactly on an edge belongs to the triangle only if the edge is a top or a left one: of
/// two triangles that share the edge, one has the sample and the other has not.
class Edge {
 public:
  Edge(const Vertex& p, const Vertex& q) : px_(p.x), py_(p.y), dx_(q.x - p.x), dy_(q.y - p.y) {
    least_ = (dy_ == 0 && dx_ > 0) || dy_ < 0 ? 0 : 1;
  }
  [[nodiscard]] std::int64_t at(std::int64_t x, std::int64_t y) const {
    return dx_ * (y - py_) - dy_ * (x - px_);
  }
  [[nodiscard]] std::int64_t step_x() const { return -dy_ * subpixels; }
  [[nodiscard]] std::int64_t least() const { return least_; }

 private:
  std::int64_t px_, py_, dx_, dy_;
  std::int64_t least_;
};

/// The samples of one strip.
class StripBuffer {
 public:
  StripBuffer(const Frame& frame, const Strip& strip)
      : frame_(frame),
        begin_(strip.begin),
        end_(strip.end),
        depth_(count(), -std::numeric_limits<float>::infinity()),
        colour_(count(), to_bytes(frame.background)),
        stamp_(count(), 0) {}

  void draw_triangle(const PreparedSurface& surface, const Triangle& triangle);
  void draw_segment(const Segment& segment, const PreparedLines& lines);
  void draw_marker(const PreparedMarker& marker);
  void resolve(Image& image) const;

 private:
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(end_ - begin_) * static_cast<std::size_t>(frame_.width);
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - begin_) * static_cast<std::size_t>(frame_.width) +
           static_cast<std::size_t>(x);
  }
  void draw_line_sample(std::size_t i, float depth, const Segment& segment, const Lines& lines);

  const Frame& frame_;
  int begin_, end_;
  std::vector<float> depth_;
  std::vector<Sample> colour_;
  std::vector<std::uint32_t> stamp_;  // group of the last line that shone through here
};

void StripBuffer::draw_triangle(const PreparedSurface& surface, const Triangle& triangle) {
  const Vertex* a = &surface.vertices[static_cast<std::size_t>(triangle.a)];
  const Vertex* b = &surface.vertices[static_cast<std::size_t>(triangle.b)];
  const Vertex* c = &surface.vertices[static_cast<std::size_t>(triangle.c)];
  const std::int64_t area = Edge(*a, *b).at(c->x, c->y);
  if (area == 0) return;
  const bool turned = area < 0;
  if (turned) std::swap(b, c);
  const Edge opposite_a(*b, *c), opposite_b(*c, *a), opposite_c(*a, *b);

  const auto [low_x, high_x] = std::minmax({a->x, b->x, c->x});
  const auto [low_y, high_y] = std::minmax({a->y, b->y, c->y});
  constexpr double unit = 1.0 / subpixels;
  const SampleRange columns(low_x * unit, high_x * unit, 0, frame_.width);
  const SampleRange rows(low_y * unit, high_y * unit, begin_, end_);
  if (columns.begin >= columns.end || rows.begin >= rows.end) return;

  const Shader shader(surface, triangle, frame_.perspective, 0.5 * frame_.unit);
  const float scale = 1 / static_cast<float>(std::abs(area));
  constexpr int centre = subpixels / 2;
  for (int y = rows.begin; y < rows.end; ++y) {
    const std::int64_t gx = std::int64_t{columns.begin} * subpixels + centre;
    const std::int64_t gy = std::int64_t{y} * subpixels + centre;
    std::int64_t ea = opposite_a.at(gx, gy);
    std::int64_t eb = opposite_b.at(gx, gy);
    std::int64_t ec = opposite_c.at(gx, gy);
    for (int x = columns.begin; x < columns.end; ++x) {
      if (ea >= opposite_a.least() && eb >= opposite_b.least() && ec >= opposite_c.least()) {
        const float la = static_cast<float>(ea) * scale;
        const float lb = static_cast<float>(eb) * scale;
        const float lc = static_cast<float>(ec) * scale;
        const float depth = la * a->depth + lb * b->depth + lc * c->depth;
        const std::size_t i = index(x, y);
        if (depth > depth_[i]) {
          depth_[i] = depth;
          colour_[i] =
              to_bytes(shader(turned ? Shader::Weights{la, lc, lb} : Shader::Weights{la, lb, lc}));
        }
      }
      ea += opposite_a.step_x();
      eb += opposite_b.step_x();
      ec += opposite_c.step_x();
    }
  }
}

void StripBuffer::draw_line_sample(std::size_t i, float depth, const Segment& segment,
                                   const Lines& lines) {
  if (lines.on_top || depth > depth_[i]) {
    if (!lines.on_top) depth_[i] = depth;
    colour_[i] = to_bytes(lines.colour);
    stamp_[i] = segment.group;
  } else if (lines.hidden_opacity > 0 && stamp_[i] != segment.group) {
    stamp_[i] = segment.group;
    const auto [r, g, b] = to_bytes(lines.colour);
    const auto blend = [&](std::uint8_t& old, std::uint8_t line) {
      old = static_cast<std::uint8_t>(std::lround(old + lines.hidden_opacity * (line - old)));
    };
    blend(colour_[i][0], r);
    blend(colour_[i][1], g);
    blend(colour_[i][2], b);
  }
}

void StripBuffer::draw_segment(const Segment& s, const PreparedLines& lines) {
  const double reach = lines.half_width;
  const double dx = s.bx - s.ax;
  const double dy = s.by - s.ay;
  const double length2 = dx * dx + dy * dy;
  const auto [low_y, high_y] = std::minmax({s.ay, s.by});
  const SampleRange rows(low_y - reach, high_y + reach, begin_, end_);
  for (int y = rows.begin; y < rows.end; ++y) {
    const double py = y + 0.5 - s.ay;
    // the part of the segment that can be within reach of this row
    double t0 = 0, t1 = 1;
    if (dy != 0) {
      const auto [near, far] = std::minmax({(py - reach) / dy, (py + reach) / dy});
      t0 = std::clamp(near, 0.0, 1.0);
      t1 = std::clamp(far, 0.0, 1.0);
    }
    const auto [low_x, high_x] = std::minmax({s.ax + t0 * dx, s.ax + t1 * dx});
    const SampleRange columns(low_x - reach, high_x + reach, 0, frame_.width);
    for (int x = columns.begin; x < columns.end; ++x) {
      const double px = x + 0.5 - s.ax;
      const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0;
      const double ex = px - t * dx;
      const double ey = py - t * dy;
      if (ex * ex + ey * ey > reach * reach) continue;
      const float depth = s.depth_a + static_cast<float>(t) * (s.depth_b - s.depth_a);
      draw_line_sample(index(x, y), depth, s, *lines.lines);
    }
  }
}

/// Distance from the middle in units of the marker's radius, so that 1 is its outline.
double marker_distance(MarkerShape shape, double x, double y) {
  switch (shape) {
    case MarkerShape::square:
      return std::max(std::abs(x), std::abs(y)) / 0.886;  // the disc's area
    case MarkerShape::diamond:
      return (std::abs(x) + std::abs(y)) / 1.2;
    case MarkerShape::triangle:
      return std::max(y / 0.62, (std::sqrt(3.0) * std::abs(x) - y) / 1.24);
    case MarkerShape::disc:
    case MarkerShape::ring:
      break;
  }
  return std::hypot(x, y);
}

void StripBuffer::draw_marker(const PreparedMarker& m) {
  const double reach = 1.3 * m.radius;
  const SampleRange rows(m.y - reach, m.y + reach, begin_, end_);
  const SampleRange columns(m.x - reach, m.x + reach, 0, frame_.width);
  const Sample fill = to_bytes(m.style->fill);
  const Sample edge = to_bytes(m.style->edge);
  const double inner = 1 - m.edge / m.radius;
  for (int y = rows.begin; y < rows.end; ++y) {
    for (int x = columns.begin; x < columns.end; ++x) {
      const double d =
          marker_distance(m.style->shape, (x + 0.5 - m.x) / m.radius, (y + 0.5 - m.y) / m.radius);
      if (d > 1 || (m.style->shape == MarkerShape::ring && d < inner)) continue;
      const std::size_t i = index(x, y);
      if (!m.style->on_top && m.depth <= depth_[i]) continue;
      colour_[i] = d > inner ? edge : fill;
    }
  }
}

/// The mean of each pixel's samples.
void StripBuffer::resolve(Image& image) const {
  const int n = frame_.samples;
  const auto total = static_cast<unsigned>(n * n);
  for (int y = begin_; y < end_; y += n) {
    std::uint8_t* out = image.row(y / n);
    for (int x = 0; x < frame_.width; x += n) {
      std::array<unsigned, 3> sum{total / 2, total / 2, total / 2};
      for (int sy = 0; sy < n; ++sy) {
        for (int sx = 0; sx < n; ++sx) {
          const Sample& sample = colour_[index(x + sx, y + sy)];
          for (std::size_t c = 0; c < 3; ++c)
            sum[c] += sample[c];
        }
      }
      for (const unsigned s : sum)
        *out++ = static_cast<std::uint8_t>(s / total);
    }
  }
}

}  // namespace

void draw_strip(const Frame& frame, const Strip& strip, Image& image) {
  StripBuffer buffer(frame, strip);
  for (std::size_t s = 0; s < frame.surfaces.size(); ++s)
    for (const int t : strip.triangles[s])
      buffer.draw_triangle(frame.surfaces[s],
                           frame.surfaces[s].triangles[static_cast<std::size_t>(t)]);
  for (std::size_t l = 0; l < frame.lines.size(); ++l)
    for (const int i : strip.segments[l])
      buffer.draw_segment(frame.lines[l].segments[static_cast<std::size_t>(i)], frame.lines[l]);
  for (const PreparedMarker& marker : frame.markers)
    buffer.draw_marker(marker);
  buffer.resolve(image);
}

}  // namespace limes::raster
