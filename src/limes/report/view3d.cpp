#include "limes/report/view3d.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>

#include "limes/core/text.h"
#include "limes/report/axes_triad.h"
#include "limes/report/canvas.h"
#include "limes/report/render.h"

namespace limes {
namespace {

/// Little-endian whatever the machine.
template <class Number>
void append(std::string& bytes, Number value) {
  auto bits = std::bit_cast<std::uint32_t>(value);
  for (int i = 0; i < 4; ++i, bits >>= 8)
    bytes += static_cast<char>(bits & 255U);
}

/// What viewer.js uploads for triangles or for lines.
struct Buffers {
  std::string points, normals, colours, indices;
  std::uint32_t count = 0;

  /// Three bytes of a normal and one with the kind of light: 0 none, 1 faint, 2 lit.
  void add_point(const Vec3& p, Vec3 normal, Shading shading, const Colour& colour) {
    normal.normalize();  // zero stays zero
    for (int i = 0; i < 3; ++i) {
      append(points, static_cast<float>(p[i]));
      normals += static_cast<char>(std::lround(127 * normal[i]));
    }
    normals += static_cast<char>(shading == Shading::lit ? 2 : shading == Shading::faint ? 1 : 0);
    for (const std::uint8_t c : to_bytes(colour))
      colours += static_cast<char>(c);
    ++count;
  }
};

/// The model's middle and size, so that the viewer has it in a ball of radius 1.
struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 1;
  [[nodiscard]] Vec3 place(const Vec3& p) const { return (p - centre) / radius; }
};

Ball ball_around(const Scene& scene) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  const auto visit = [&](auto&& action) {
    for (const Surface& s : scene.surfaces)
      for (const Vec3& p : s.points)
        action(p);
    for (const Lines& l : scene.lines)
      for (const Vec3& p : l.points)
        action(p);
  };
  visit([&](const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  });
  Ball ball;
  ball.centre = (low + high) / 2;
  double radius = 0;
  visit([&](const Vec3& p) { radius = std::max(radius, (p - ball.centre).norm()); });
  if (radius > 0) ball.radius = radius;
  return ball;
}

/// Points are shared unless each triangle has a colour or a normal of its own.
void add_surface(const Surface& s, const Ball& ball, Buffers& out) {
  const bool flat = s.shading == Shading::flat;
  const bool by_point = s.triangle_colours.empty() && (flat || !s.normals.empty());
  const auto colour = [&](std::size_t point, std::size_t triangle) {
    if (!s.values.empty()) return s.scale(s.values[point]);
    if (!s.point_colours.empty()) return s.point_colours[point];
    return s.triangle_colours.empty() ? s.colour : s.triangle_colours[triangle];
  };
  const std::uint32_t first = out.count;
  if (by_point) {
    for (std::size_t p = 0; p < s.points.size(); ++p)
      out.add_point(ball.place(s.points[p]), flat ? Vec3(0, 0, 0) : s.normals[p], s.shading,
                    colour(p, 0));
    for (const auto& triangle : s.triangles)
      for (const int i : triangle)
        append(out.indices, first + static_cast<std::uint32_t>(i));
    return;
  }
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto at = [&](std::size_t i) { return static_cast<std::size_t>(s.triangles[t][i]); };
    const Vec3 facet =
        (s.points[at(1)] - s.points[at(0)]).cross(s.points[at(2)] - s.points[at(0)]).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 normal = s.normals.empty() ? facet : s.normals[at(i)];
      append(out.indices, out.count);
      out.add_point(ball.place(s.points[at(i)]), normal, s.shading, colour(at(i), t));
    }
  }
}

void add_lines(const Lines& lines, const Ball& ball, Buffers& out) {
  const std::uint32_t first = out.count;
  for (const Vec3& p : lines.points)
    out.add_point(ball.place(p), Vec3(0, 0, 0), Shading::flat, lines.colour);
  for (const auto& segment : lines.segments)
    for (const int i : segment)
      append(out.indices, first + static_cast<std::uint32_t>(i));
}

std::string data_block(std::string_view name, const std::string& bytes) {
  return fmt::format("<script type=\"text/plain\" data-name=\"{}\">{}</script>\n", name,
                     base64(bytes));
}

std::string axes_text(const Mat3& axes) {
  std::string rows;
  for (int i = 0; i < 3; ++i)
    rows += fmt::format("{}[{},{},{}]", i == 0 ? "" : ",", format_real(axes(i, 0)),
                        format_real(axes(i, 1)), format_real(axes(i, 2)));
  return "[" + rows + "]";
}

}  // namespace

std::string to_html(const View3d& view) {
  const double aspect = static_cast<double>(view.size.width) / view.size.height;
  const FitOptions fit;
  const Camera camera = fit_camera(view.scene, view.direction, view.up, aspect, fit);
  const Image still = render(view.scene, camera, {.size = view.size});
  const Ball ball = ball_around(view.scene);
  Buffers triangles, lines;
  for (const Surface& s : view.scene.surfaces)
    add_surface(s, ball, triangles);
  for (const Lines& l : view.scene.lines)
    add_lines(l, ball, lines);

  std::string html = fmt::format(
      "<div class=\"view3d\" style=\"width:{0}px\" data-slope=\"{2}\" data-axes=\"{3}\" "
      "data-axis-colours=\"{6} {7} {8}\">\n"
      "<img width=\"{0}\" height=\"{1}\" alt=\"{4}\" src=\"data:image/png;base64,{5}\">\n"
      "<canvas tabindex=\"0\" style=\"aspect-ratio:{0}/{1}\" aria-label=\"{4}\"></canvas>\n"
      "<div class=\"controls\"><label><input type=\"checkbox\" checked> edges</label>"
      "<button type=\"button\">reset</button><span>drag to turn, click then wheel to zoom, "
      "shift-drag to move</span></div>\n",
      view.size.width, view.size.height, format_real(camera.half_height), axes_text(camera.axes),
      escape_markup(view.description), base64(encode_png(still)), to_css(axis_colours[0]),
      to_css(axis_colours[1]), to_css(axis_colours[2]));
  html += data_block("surface-points", triangles.points);
  html += data_block("surface-normals", triangles.normals);
  html += data_block("surface-colours", triangles.colours);
  html += data_block("surface-indices", triangles.indices);
  html += data_block("lines-points", lines.points);
  html += data_block("lines-colours", lines.colours);
  html += data_block("lines-indices", lines.indices);
  return html + "</div>\n";
}

}  // namespace limes
