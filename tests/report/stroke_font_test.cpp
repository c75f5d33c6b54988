#include <gtest/gtest.h>

#include "limes/report/canvas.h"

namespace limes {
namespace {

TEST(TextRuns, LowerAndUpperParts) {
  const auto runs = text_runs("σ_{xx} in 10^{−3} N/mm²");
  ASSERT_EQ(runs.size(), 6U);
  EXPECT_EQ(runs[0].text, "σ");
  EXPECT_EQ(runs[1].text, "xx");
  EXPECT_EQ(runs[1].level, -1);
  EXPECT_EQ(runs[3].text, "−3");
  EXPECT_EQ(runs[3].level, 1);
  EXPECT_EQ(runs[5].text, "2");
  EXPECT_EQ(runs[5].level, 1);
}

TEST(TextRuns, PlainUnderscoresAndOpenBracesStayText) {
  ASSERT_EQ(text_runs("a_b ^ x_{").size(), 1U);
  EXPECT_EQ(text_runs("a_b ^ x_{")[0].text, "a_b ^ x_{");
}

TEST(StrokeFont, EveryPrintableAsciiCharacterIsDrawn) {
  const auto box = stroke_text("\u4e2d", 14);  // a character that is not there
  for (char c = '!'; c <= '~'; ++c) {
    const auto lines = stroke_text({&c, 1}, 14);
    ASSERT_FALSE(lines.empty()) << c;
    EXPECT_NE(lines[0].points, box[0].points) << c;
    for (const TextLine& line : lines) {
      for (const Vec2& p : line.points) {
        EXPECT_GE(p[0], -0.2) << c;  // within its advance: neighbours do not touch
        EXPECT_LE(p[0], text_width({&c, 1}, 14) + 0.2) << c;
        EXPECT_GT(p[1], -0.3 * 14) << c;
        EXPECT_LT(p[1], 0.9 * 14) << c;
      }
    }
  }
}

TEST(StrokeFont, BrokenUtf8IsBoxesNotGarbage) {
  EXPECT_EQ(stroke_text("\xff\xc3", 14).size(), 2U);
  EXPECT_EQ(stroke_text("\xe2\x88", 14).size(), 2U);
}

TEST(StrokeFont, WidthAddsUp) {
  EXPECT_DOUBLE_EQ(text_width("ab", 10), text_width("a", 10) + text_width("b", 10));
  EXPECT_LT(text_width("a_{b}", 10), text_width("ab", 10));
}

TEST(WrapText, BreaksAtBlanksOnly) {
  const auto lines =
      wrap_text("one two three unbreakablylongword x", 10, text_width("one two ", 10));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "one two");
  EXPECT_EQ(lines[2], "unbreakablylongword");
  EXPECT_TRUE(wrap_text("", 10, 100).empty());
}

TEST(EscapeMarkup, SpecialAndBrokenCharacters) {
  EXPECT_EQ(escape_markup("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
  EXPECT_EQ(escape_markup("x\x01y"), "x\uFFFDy");
  EXPECT_EQ(escape_markup("ok \xff"), "ok \uFFFD");
  EXPECT_EQ(escape_markup("σ²"), "σ²");
}

}  // namespace
}  // namespace limes
