#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "limes/core/error.h"
#include "limes/report/axes_triad.h"
#include "limes/report/html.h"
#include "limes/report/plot.h"

namespace limes {
namespace {

constexpr std::string_view hostile = "<script>alert('x')</script> & \"quoted\" \x01";

View3d tetrahedron() {
  View3d view;
  Surface s;
  s.points = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 5}};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  s.triangle_colours.assign(4, Colour::hex(0xff8000));
  view.scene.surfaces = {s};
  view.scene.lines.resize(1);
  view.scene.lines[0].points = s.points;
  view.scene.lines[0].segments = {{0, 1}, {1, 2}};
  view.description = hostile;
  view.size = {80, 60};
  return view;
}

HtmlReport full_report() {
  const std::string text(hostile);
  HtmlReport report(text, text);
  report.summary({{text, text}});
  for (const char* name : {"a", "b", "c"})
    report.section(text + name);
  report.paragraph("σ_{xx} in N/mm² " + text);
  report.table({text, {text, "number"}, {{text, "1.25"}, {"b", "−10"}, {"c", "100.5"}}});
  report.checks({{text, text, text, true}, {"second", "1", "2 ± 1 %", false}});
  report.figure(drawing(convergence_plot(text, text, text,
                                         {{text, {{1, 1}, {0.5, 0.25}, {0.25, 0.06}}}}, {{2}})),
                text);
  report.view(tetrahedron(), text);
  report.raw_data(text, text);
  report.footer(text);
  return report;
}

/// The elements of a page in order, "/name" where one closes; what is inside of <style> and
/// <script> is text.
std::vector<std::string> tags_of(const std::string& html) {
  std::vector<std::string> tags;
  const std::regex tag("<(/?[a-zA-Z][a-zA-Z0-9]*)([^<>]*)>");
  for (std::size_t at = 0;;) {
    std::smatch match;
    if (!std::regex_search(html.begin() + static_cast<std::ptrdiff_t>(at), html.end(), match, tag))
      return tags;
    const std::string name = match[1];
    at += static_cast<std::size_t>(match.position() + match.length());
    if (!match[2].str().ends_with('/')) tags.push_back(name);
    if (name == "script" || name == "style") at = html.find("</" + name, at);
  }
}

TEST(HtmlReport, EveryElementIsClosedInOrder) {
  std::vector<std::string> open;
  int count = 0;
  for (const std::string& tag : tags_of(full_report().text())) {
    if (tag == "meta" || tag == "img" || tag == "input") continue;
    if (tag.front() != '/') {
      open.push_back(tag);
      ++count;
      continue;
    }
    ASSERT_FALSE(open.empty()) << tag;
    EXPECT_EQ("/" + open.back(), tag);
    open.pop_back();
  }
  EXPECT_TRUE(open.empty());
  EXPECT_GT(count, 60);
}

TEST(HtmlReport, NoTextBecomesMarkup) {
  const std::string html = full_report().text();
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find('\x01'), std::string::npos);
  std::size_t escaped = 0;
  for (std::size_t at = html.find("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;");
       at != std::string::npos; at = html.find("&lt;script&gt;alert", at + 1))
    ++escaped;
  EXPECT_GE(escaped, 25U);  // as often as it was put in
}

TEST(HtmlReport, LoadsNothingFromAnywhere) {
  const std::string html = full_report().text();
  for (const char* word : {"http:", "https:", "url(", "@import", "<link", "<iframe", "import("})
    EXPECT_EQ(html.find(word), std::string::npos) << word;
  const std::regex reference("(src|href)=\"([^\"]{0,12})");
  for (std::sregex_iterator it(html.begin(), html.end(), reference), end; it != end; ++it) {
    const std::string target = (*it)[2];
    EXPECT_TRUE(target.starts_with("data:image") || target.starts_with("#section-")) << target;
  }
}

TEST(HtmlReport, IdsAreUniqueAndLinkedOnce) {
  const std::string html = full_report().text();
  for (const char* id : {"section-1", "section-2", "section-3"}) {
    const std::string definition = std::string("id=\"") + id + "\"";
    const std::size_t first = html.find(definition);
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(html.find(definition, first + 1), std::string::npos);
    EXPECT_NE(html.find(std::string("href=\"#") + id + "\""), std::string::npos);
  }
}

TEST(HtmlReport, ChecksSayPassAndFailInWords) {
  HtmlReport report("checks");
  report.checks({{"a", "1", "1", true}, {"b", "1", "2", false}});
  const std::string html = report.text();
  EXPECT_NE(html.find("<td class=\"pass\">✓ pass</td>"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"fail\">✗ fail</td>"), std::string::npos);
  EXPECT_NE(html.find("Failed: 1 of 2."), std::string::npos);
  HtmlReport good("checks");
  good.checks({{"a", "1", "1", true}});
  EXPECT_NE(good.text().find("Passed: 1 of 1."), std::string::npos);
}

TEST(HtmlReport, NumbersAreAlignedAtThePoint) {
  HtmlReport report("table");
  report.table({"", {"name", "x"}, {{"1a", "1.25"}, {"b", "−10"}, {"c", "100.5"}, {"d", ""}}});
  const std::string html = report.text();
  EXPECT_NE(html.find("<th scope=\"col\">name</th><th scope=\"col\" class=\"number\">x</th>"),
            std::string::npos);
  EXPECT_NE(html.find("<td class=\"number\">1.25</td>"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"number\">−10\u2008\u2007\u2007</td>"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"number\">100.5\u2007</td>"), std::string::npos);
}

TEST(HtmlReport, RowsLongerThanTheHeaderAreInputErrors) {
  HtmlReport report("table");
  EXPECT_THROW(report.table({"t", {"a"}, {{"1", "2"}}}), InputError);
}

TEST(HtmlReport, LowerAndUpperPartsAreElements) {
  EXPECT_EQ(to_html("σ_{x<y} 10^{−3}"), "σ<sub>x&lt;y</sub> 10<sup>−3</sup>");
}

/// Undoes base64() with code of its own.
std::string decoded(std::string_view text) {
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                                             : 63;
    bits = bits << 6 | static_cast<unsigned>(value);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 255U);
    }
  }
  return bytes;
}

std::string block(const std::string& html, const std::string& name) {
  const std::string start = "data-name=\"" + name + "\">";
  const std::size_t at = html.find(start) + start.size();
  return decoded(std::string_view(html).substr(at, html.find('<', at) - at));
}

float float_at(const std::string& bytes, std::size_t index) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;)
    bits = bits << 8 | static_cast<unsigned char>(bytes[4 * index + i]);
  return std::bit_cast<float>(bits);
}

TEST(View3d, DataHoldTheModelInTheUnitBall) {
  const std::string html = to_html(tetrahedron());
  const std::string points = block(html, "surface-points");
  ASSERT_EQ(points.size(), 12U * 3 * 4);  // facets and colours per triangle: no shared points
  double farthest = 0;
  for (std::size_t p = 0; p < 12; ++p) {
    const Vec3 x(float_at(points, 3 * p), float_at(points, 3 * p + 1), float_at(points, 3 * p + 2));
    farthest = std::max(farthest, x.norm());
  }
  EXPECT_NEAR(farthest, 1, 1e-6);
  const auto coordinate = [&](std::size_t p, std::size_t i) { return float_at(points, 3 * p + i); };
  EXPECT_NEAR((coordinate(1, 1) - coordinate(0, 1)) / (coordinate(2, 0) - coordinate(0, 0)),
              4.0 / 3,
              1e-5);  // from (0,0,0), (0,4,0), (3,0,0)
  const std::string colours = block(html, "surface-colours");
  ASSERT_EQ(colours.size(), 36U);
  EXPECT_EQ(static_cast<unsigned char>(colours[1]), 0x80);
  const std::string normals = block(html, "surface-normals");
  ASSERT_EQ(normals.size(), 48U);
  EXPECT_EQ(normals[2], -127);  // the face in z = 0 looks down
  EXPECT_EQ(block(html, "surface-indices").size(), 12U * 4);
  EXPECT_EQ(block(html, "lines-points").size(), 4U * 3 * 4);
  EXPECT_EQ(block(html, "lines-indices"), std::string("\0\0\0\0\1\0\0\0\1\0\0\0\2\0\0\0", 16));
}

// The fourth byte of a normal is the kind of light, by which the shader in the page branches.
TEST(View3d, NormalsSayTheKindOfLight) {
  for (const auto& [shading, kind] :
       {std::pair(Shading::flat, 0), std::pair(Shading::faint, 1), std::pair(Shading::lit, 2)}) {
    View3d view = tetrahedron();
    view.scene.surfaces[0].shading = shading;
    const std::string normals = block(to_html(view), "surface-normals");
    EXPECT_EQ(normals[2], -127);
    for (std::size_t p = 0; p < 12; ++p)
      EXPECT_EQ(normals[4 * p + 3], kind);
  }
  HtmlReport report("", "");
  report.view(tetrahedron(), "");
  const std::string page = report.text();
  for (const char* line :
       {"attribute(\"light\", 1, gl.BYTE, false, 4, 3);", "if (kind == 0 ||", "if (kind == 1) {"})
    EXPECT_NE(page.find(line), std::string::npos) << line;
}

// The colours of its axes are data: those of the axes beside still pictures.
TEST(View3d, AxesHaveTheColoursOfThePictures) {
  const std::string html = to_html(tetrahedron());
  EXPECT_NE(html.find("data-axis-colours=\"" + to_css(axis_colours[0]) + " " +
                      to_css(axis_colours[1]) + " " + to_css(axis_colours[2]) + "\""),
            std::string::npos);
}

TEST(View3d, BrokenScenesAreInputErrors) {
  View3d view = tetrahedron();
  view.scene.surfaces[0].triangles[0][1] = 99;
  EXPECT_THROW((void)to_html(view), InputError);
}

TEST(HtmlReport, SameInputSameBytesAlsoInTheFile) {
  const auto file = std::filesystem::path(testing::TempDir()) / "limes_report_test.html";
  full_report().write(file);
  std::ostringstream read;
  read << std::ifstream(file, std::ios::binary).rdbuf();
  EXPECT_EQ(read.str(), full_report().text());
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace limes
