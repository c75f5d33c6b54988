#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limes/report/canvas.h"
#include "limes/report/view3d.h"

namespace limes {

/// Rows of cells. A column in which every filled cell is a number stands to the right, points below
/// each other; numbers are what format_real() and format_readable() give.
struct Table {
  std::string caption = {};
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// One line of a check: what was computed, what it should be, and whether that holds.
struct Check {
  std::string name;
  std::string value;
  std::string expected;  ///< with its tolerance: "0.3024 ± 0.5 %"
  bool passed = false;
};

/// A report as one HTML file that needs nothing else: no network, no other file. It reads from top
/// to bottom, prints, and has a list of its sections. All text is plain text with the canvas' markup
/// for lower and upper parts (TextRun); it is escaped here.
class HtmlReport {
 public:
  explicit HtmlReport(std::string title, std::string subtitle = {});

  /// Names and values, two columns.
  void summary(const std::vector<std::pair<std::string, std::string>>& rows);
  void section(std::string_view title);
  void paragraph(std::string_view text);
  /// @throws InputError if a row has more cells than the header
  void table(const Table& table);
  /// Ends with a line that counts what failed.
  void checks(const std::vector<Check>& checks);
  void figure(const Drawing& drawing, std::string_view caption = {});
  /// A model to turn; its still picture where there is no WebGL, and on paper.
  void view(const View3d& view, std::string_view caption = {});
  /// Preformatted text behind a line to open.
  void raw_data(std::string_view title, std::string_view text);
  void footer(std::string_view text);

  [[nodiscard]] std::string text() const;
  /// @throws OutputError
  void write(const std::filesystem::path& file) const;

 private:
  std::string title_, subtitle_, footer_;
  std::string body_;
  std::vector<std::string> sections_;
  bool has_views_ = false;
};

/// Escaped text with <sub> and <sup> for its lower and upper parts.
[[nodiscard]] std::string to_html(std::string_view label);

}  // namespace limes
