#include "number_table.h"

#include <fmt/ranges.h>

#include <optional>
#include <string>

#include "files.h"
#include "limes/core/text.h"
#include "limes/io/lines.h"

namespace limes::app {
namespace {

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(trim(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

class TableReader {
 public:
  TableReader(std::string file, std::span<const std::string_view> columns)
      : file_(std::move(file)), columns_(columns) {}

  void read_head(std::int64_t line, std::string_view text) {
    const auto names = split(text);
    num_fields_ = names.size();
    for (const std::string_view column : columns_) {
      std::optional<std::size_t> found;
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] != column) continue;
        if (found) throw error_at(file_, line, "column {} appears twice", column);
        found = i;
      }
      if (!found)
        throw error_at(file_, line, "there is no column {}; the head must name {}", column,
                       fmt::join(columns_, ","));
      field_.push_back(*found);
    }
  }

  void read_row(std::int64_t line, std::string_view text, std::vector<double>& values) const {
    const auto fields = split(text);
    if (fields.size() != num_fields_)
      throw error_at(file_, line, "{} fields; the head has {} columns", fields.size(), num_fields_);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const auto value = parse_real(fields[field_[c]]);
      if (!value)
        throw error_at(file_, line, "{} is {}; a number is right", columns_[c],
                       quote(fields[field_[c]]));
      values.push_back(*value);
    }
  }

 private:
  std::string file_;
  std::span<const std::string_view> columns_;
  std::vector<std::size_t> field_;  // by column
  std::size_t num_fields_ = 0;
};

}  // namespace

NumberTable read_number_table(const std::filesystem::path& file,
                              std::span<const std::string_view> columns) {
  const std::string name = file.string();
  const std::string bytes = read_text_file(file);
  LineReader lines(checked_text(bytes, name));
  TableReader reader(name, columns);
  NumberTable table{columns.size(), {}, {}};
  bool head = true;
  while (lines.next()) {
    if (trim(lines.line()).empty()) continue;
    if (head) {
      reader.read_head(lines.number(), lines.line());
    } else {
      reader.read_row(lines.number(), lines.line(), table.values);
      table.lines.push_back(lines.number());
    }
    head = false;
  }
  if (head)
    throw InputError("{}: empty; the first line must name {}", name, fmt::join(columns, ","));
  return table;
}

}  // namespace limes::app
