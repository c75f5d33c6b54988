#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>

#include "limes/core/error.h"
#include "limes/report/pictures.h"

namespace limes {
namespace {

/// A grid of n x n quads on [0, 1]^2, one quad replaced by an n-gon pair if wanted.
Mesh grid(int n) {
  std::vector<Vec3> points;
  std::vector<VertexId> corners;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      points.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n, 0);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      for (const int v : {a, a + 1, a + n + 2, a + n + 1})
        corners.emplace_back(v);
    }
  }
  Mesh mesh;
  mesh.topology = Topology((n + 1) * (n + 1), 4, corners);
  mesh.points = IdArray<VertexId, Vec3>(points);
  return mesh;
}

Topology cube() {
  std::vector<VertexId> corners;
  for (const int v : {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7})
    corners.emplace_back(v);
  return {8, 4, corners};
}

Figure some_figure() {
  FieldPicture field;
  const Mesh mesh = grid(3);
  field.points = mesh.points.vector();
  field.triangles = triangulate(mesh.topology, mesh.points.span()).triangles;
  for (const Vec3& p : field.points)
    field.values.push_back(-2e8 + 6e8 * p[0]);
  field.quantity = "σ_{xx}";
  field.unit = "N/m² <&>";
  return field_figure(field, {.title = "A \"title\" & more <b>", .size = {200, 200}, .density = 1});
}

TEST(FaceCategory, CornersBoundaryAndInsideOfAGrid) {
  const auto categories = classify_faces(grid(4).topology);
  EXPECT_EQ(std::count(categories.begin(), categories.end(), FaceCategory::corner), 4);
  EXPECT_EQ(std::count(categories.begin(), categories.end(), FaceCategory::boundary), 8);
  EXPECT_EQ(std::count(categories.begin(), categories.end(), FaceCategory::regular), 4);
  EXPECT_TRUE(extraordinary_vertices(grid(4).topology).empty());
}

TEST(FaceCategory, EveryVertexOfACubeIsExtraordinary) {
  const auto categories = classify_faces(cube());
  EXPECT_EQ(std::count(categories.begin(), categories.end(), FaceCategory::extraordinary), 6);
  EXPECT_EQ(extraordinary_vertices(cube()).size(), 8U);
}

TEST(Triangulate, HollowFacesAreCoveredOnce) {
  const std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 1, 0}, {0, 3, 0}};  // an M
  std::vector<VertexId> corners;
  for (int v = 0; v < 5; ++v)
    corners.emplace_back(v);
  const Triangulation t = triangulate(Topology(5, 5, corners), points);
  ASSERT_EQ(t.triangles.size(), 3U);
  double sum = 0;
  for (const auto& [a, b, c] : t.triangles) {
    const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
    const double area = (at(b) - at(a)).cross(at(c) - at(a))[2] / 2;
    EXPECT_GT(area, 0);
    sum += area;
  }
  EXPECT_DOUBLE_EQ(sum, 12 - 4);
}

TEST(ControlMeshFigure, HolesStayOpen) {
  Mesh mesh = grid(3);
  mesh.tags.holes = {FaceId(4)};
  const Figure figure = control_mesh_figure(mesh, {.size = {120, 120}, .density = 1});
  const auto middle = figure.image.pixel(60, 60);
  EXPECT_TRUE(std::equal(middle.begin(), middle.end(), to_bytes(palette::paper).begin()));
  ASSERT_EQ(figure.legend.size(), 2U);  // the only regular face was the hole
  EXPECT_EQ(figure.legend[0].label, "boundary");
}

TEST(FieldFigure, ConstantAndMissingValuesHaveAPicture) {
  FieldPicture field;
  const Mesh mesh = grid(3);
  field.points = mesh.points.vector();
  field.triangles = triangulate(mesh.topology, mesh.points.span()).triangles;
  field.values.assign(field.points.size(), 7.0);
  field.values[0] = std::numeric_limits<double>::quiet_NaN();
  const Figure figure = field_figure(field, {.size = {90, 90}, .density = 1});
  const auto known = figure.image.pixel(70, 20), missing = figure.image.pixel(4, 85);
  const auto middle = to_bytes(ColourMap::sequential()(0.5));
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(known[c], middle[c], 2);
  EXPECT_TRUE(std::equal(missing.begin(), missing.end(), to_bytes(palette::no_data).begin()));
  EXPECT_NE(to_svg(drawing(figure)).find(">7</text>"), std::string::npos);
}

TEST(EdgeLines, EveryEdgeOnce) {
  EXPECT_EQ(edge_lines(grid(4).topology, grid(4).points.span()).segments.size(), 40U);
}

/// Where the bar says 200 (with its factor 10^6) the scale has that colour: the tick's height on the
/// bar is linear in the value.
TEST(Figure, ColourBarTicksLieAtTheirValues) {
  const std::string svg = to_svg(drawing(some_figure()));
  std::vector<std::pair<double, double>> ticks;  // label, y
  const std::regex label(
      "<text xml:space=\"preserve\" x=\"[0-9.]+\" y=\"([0-9.]+)\" font-size=\"13\" "
      "fill=\"#1f2328\">((?:−)?)([0-9]+)</text>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), label), end; it != end; ++it) {
    const double sign = (*it)[2].length() > 0 ? -1 : 1;
    ticks.emplace_back(sign * std::stod((*it)[3]), std::stod((*it)[1]));
  }
  ASSERT_GE(ticks.size(), 4U);
  EXPECT_EQ(ticks.front().first, -400);  // symmetric about zero: -400e6 to 400e6
  EXPECT_EQ(ticks.back().first, 400);
  const auto [v0, y0] = ticks.front();
  const auto [v1, y1] = ticks.back();
  EXPECT_LT(y1, y0);  // up is more
  for (const auto& [value, y] : ticks)
    EXPECT_NEAR(y, y0 + (value - v0) / (v1 - v0) * (y1 - y0), 0.02);
  EXPECT_NE(svg.find("×10<tspan"), std::string::npos);
}

TEST(Figure, TextIsEscapedAndNothingIsLoadedFromOutside) {
  const std::string svg = to_svg(drawing(some_figure()));
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_NE(svg.find("A &quot;title&quot; &amp; more &lt;b&gt;"), std::string::npos);
  EXPECT_NE(svg.find("&lt;&amp;&gt;"), std::string::npos);
  for (std::size_t at = svg.find("href=\""); at != std::string::npos;
       at = svg.find("href=\"", at + 1))
    EXPECT_EQ(svg.compare(at, 16, "href=\"data:image"), 0);
}

TEST(Figure, ImageHoldsThePictureUnchanged) {
  Figure figure = some_figure();
  figure.density = 2;
  const Image whole = to_image(drawing(figure), 2);
  // the first row that is not white below the title is the picture's
  int found = -1;
  for (int y = 0; y + figure.image.height() <= whole.height() && found < 0; ++y) {
    bool same = true;
    for (int row = 0; row < figure.image.height() && same; ++row)
      same = std::equal(figure.image.row(row), figure.image.row(row) + 3 * figure.image.width(),
                        whole.row(y + row) + 3 * 32);
    if (same) found = y;
  }
  EXPECT_GE(found, 0);
}

TEST(Figure, SameInputSameBytes) {
  EXPECT_EQ(to_svg(drawing(some_figure())), to_svg(drawing(some_figure())));
  EXPECT_EQ(to_image(drawing(some_figure())), to_image(drawing(some_figure())));
}

TEST(Figure, OnlySvgAndPngAreWritten) {
  EXPECT_THROW(write_drawing("x.jpg", drawing(some_figure())), UsageError);
}

TEST(Figure, FieldNeedsOneValuePerPoint) {
  FieldPicture field;
  field.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  field.triangles = {{0, 1, 2}};
  field.values = {1, 2};
  EXPECT_THROW((void)field_figure(field, {}), InputError);
}

TEST(ControlMeshFigure, LegendNamesWhatOccurs) {
  const Figure figure = control_mesh_figure(grid(4), {.size = {120, 120}, .density = 1});
  ASSERT_EQ(figure.legend.size(), 3U);
  EXPECT_EQ(figure.legend[0].label, "regular");
  EXPECT_EQ(figure.legend[1].label, "boundary");
  EXPECT_EQ(figure.legend[2].label, "corner");
  const auto pixel = figure.image.pixel(60 + 15, 60 - 15);  // middle of an inner face
  EXPECT_TRUE(std::equal(pixel.begin(), pixel.end(), to_bytes(palette::green).begin()));
  const auto corner = figure.image.pixel(15, 15);
  EXPECT_TRUE(std::equal(corner.begin(), corner.end(), to_bytes(palette::red).begin()));
}

}  // namespace
}  // namespace limes
