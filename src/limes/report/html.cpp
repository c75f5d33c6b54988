#include "limes/report/html.h"

#include <fmt/format.h>

#include <algorithm>

#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/report/embedded.h"

namespace limes {
namespace {

constexpr std::string_view minus = "\u2212";
constexpr std::string_view figure_space = "\u2007";       // as wide as a digit
constexpr std::string_view punctuation_space = "\u2008";  // as wide as a point

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Digits before and after the point of a number, and where it ends; {0, 0, 0} for other text.
struct NumberShape {
  std::size_t whole = 0, fraction = 0, end = 0;
};
NumberShape shape_of(std::string_view cell) {
  NumberShape shape;
  std::size_t i = cell.starts_with(minus)                          ? minus.size()
                  : cell.starts_with('-') || cell.starts_with('+') ? 1
                                                                   : 0;
  for (; i < cell.size() && is_digit(cell[i]); ++i)
    ++shape.whole;
  if (i < cell.size() && cell[i] == '.') {
    for (++i; i < cell.size() && is_digit(cell[i]); ++i)
      ++shape.fraction;
  }
  shape.end = i;
  return shape.whole + shape.fraction > 0 ? shape : NumberShape{};
}

/// "12", "−0.5", "1e-7", "1.2×10^{−7}", "4.1 %": a number with little behind it.
bool is_number(std::string_view cell) {
  const NumberShape shape = shape_of(cell);
  const std::string_view rest = cell.substr(shape.end);
  return shape.end > 0 && (rest.empty() || rest.starts_with('e') || rest.starts_with("×10^{") ||
                           rest == " %" || rest == "%");
}

/// How a column is written: as numbers, and with how many places after the point.
struct Column {
  bool numeric = false;
  std::size_t fraction = 0;
};

std::vector<Column> columns_of(const Table& table) {
  std::vector<Column> columns(table.header.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    bool filled = false, numeric = true, plain = true;
    std::size_t fraction = 0;
    for (const auto& row : table.rows) {
      if (c >= row.size() || row[c].empty()) continue;
      filled = true;
      numeric = numeric && is_number(row[c]);
      const NumberShape shape = shape_of(row[c]);
      plain = plain && shape.end == row[c].size();
      fraction = std::max(fraction, shape.fraction);
    }
    columns[c] = {filled && numeric, plain ? fraction : 0};
  }
  return columns;
}

/// The cell with blanks of a digit's width where the column has more places.
std::string padded(const std::string& cell, const Column& column) {
  std::string result = to_html(cell);
  const std::size_t fraction = shape_of(cell).fraction;
  if (cell.empty() || column.fraction == 0 || fraction >= column.fraction) return result;
  if (fraction == 0) result += punctuation_space;
  for (std::size_t i = fraction; i < column.fraction; ++i)
    result += figure_space;
  return result;
}

std::string anchor(std::size_t section) {
  return fmt::format("section-{}", section + 1);
}

}  // namespace

std::string to_html(std::string_view label) {
  std::string result;
  for (const TextRun& run : text_runs(label)) {
    const char* tag = run.level < 0 ? "sub" : "sup";
    if (run.level == 0)
      result += escape_markup(run.text);
    else
      result += fmt::format("<{0}>{1}</{0}>", tag, escape_markup(run.text));
  }
  return result;
}

HtmlReport::HtmlReport(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void HtmlReport::summary(const std::vector<std::pair<std::string, std::string>>& rows) {
  body_ += "<div class=\"scroll\"><table class=\"summary\">\n<tbody>\n";
  for (const auto& [name, value] : rows)
    body_ += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", to_html(name),
                         to_html(value));
  body_ += "</tbody>\n</table></div>\n";
}

void HtmlReport::section(std::string_view title) {
  body_ += fmt::format("<h2 id=\"{}\">{}</h2>\n", anchor(sections_.size()), to_html(title));
  sections_.emplace_back(title);
}

void HtmlReport::paragraph(std::string_view text) {
  body_ += fmt::format("<p>{}</p>\n", to_html(text));
}

void HtmlReport::table(const Table& table) {
  const std::vector<Column> columns = columns_of(table);
  const auto kind = [&](std::size_t c) { return columns[c].numeric ? " class=\"number\"" : ""; };
  body_ += "<div class=\"scroll\"><table>\n";
  if (!table.caption.empty())
    body_ += fmt::format("<caption>{}</caption>\n", to_html(table.caption));
  body_ += "<thead><tr>";
  for (std::size_t c = 0; c < columns.size(); ++c)
    body_ += fmt::format("<th scope=\"col\"{}>{}</th>", kind(c), to_html(table.header[c]));
  body_ += "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto& row = table.rows[r];
    if (row.size() > columns.size())
      throw InputError("report table '{}': row {} has {} cells, the header {}", table.caption,
                       r + 1, row.size(), columns.size());
    body_ += "<tr>";
    for (std::size_t c = 0; c < columns.size(); ++c)
      body_ +=
          fmt::format("<td{}>{}</td>", kind(c), c < row.size() ? padded(row[c], columns[c]) : "");
    body_ += "</tr>\n";
  }
  body_ += "</tbody>\n</table></div>\n";
}

void HtmlReport::checks(const std::vector<Check>& checks) {
  body_ +=
      "<div class=\"scroll\"><table class=\"checks\">\n<thead><tr><th scope=\"col\">check</th>"
      "<th scope=\"col\">value</th><th scope=\"col\">expected</th><th scope=\"col\">result</th>"
      "</tr></thead>\n<tbody>\n";
  for (const Check& check : checks)
    body_ += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td></tr>\n",
                         to_html(check.name), to_html(check.value), to_html(check.expected),
                         check.passed ? "pass" : "fail", check.passed ? "✓ pass" : "✗ fail");
  const auto failed =
      std::count_if(checks.begin(), checks.end(), [](const Check& check) { return !check.passed; });
  body_ += "</tbody>\n</table></div>\n<p class=\"verdict\">";
  body_ += failed == 0 ? fmt::format("Passed: {0} of {0}.", checks.size())
                       : fmt::format("Failed: {} of {}.", failed, checks.size());
  body_ += "</p>\n";
}

void HtmlReport::figure(const Drawing& drawing, std::string_view caption) {
  body_ += "<figure>\n" + to_svg(drawing, SvgForm::inside);
  if (!caption.empty()) body_ += fmt::format("<figcaption>{}</figcaption>\n", to_html(caption));
  body_ += "</figure>\n";
}

void HtmlReport::view(const View3d& view, std::string_view caption) {
  has_views_ = true;
  body_ += "<figure>\n" + to_html(view);
  if (!caption.empty()) body_ += fmt::format("<figcaption>{}</figcaption>\n", to_html(caption));
  body_ += "</figure>\n";
}

void HtmlReport::raw_data(std::string_view title, std::string_view text) {
  body_ += fmt::format("<details><summary>{}</summary>\n<pre>{}</pre>\n</details>\n",
                       to_html(title), escape_markup(text));
}

void HtmlReport::footer(std::string_view text) {
  footer_ = text;
}

std::string HtmlReport::text() const {
  std::string result = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n",
      escape_markup(title_), embedded::report_css, to_html(title_));
  if (!subtitle_.empty())
    result += fmt::format("<p class=\"subtitle\">{}</p>\n", to_html(subtitle_));
  result += "</header>\n";
  if (sections_.size() > 2) {
    result += "<nav aria-label=\"Sections\"><ul>\n";
    for (std::size_t i = 0; i < sections_.size(); ++i)
      result += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", anchor(i), to_html(sections_[i]));
    result += "</ul></nav>\n";
  }
  result += "<main>\n" + body_ + "</main>\n";
  if (!footer_.empty()) result += fmt::format("<footer>{}</footer>\n", to_html(footer_));
  if (has_views_) result += fmt::format("<script>\n{}</script>\n", embedded::viewer_js);
  return result + "</body>\n</html>\n";
}

void HtmlReport::write(const std::filesystem::path& file) const {
  write_file(file, text());
}

}  // namespace limes
