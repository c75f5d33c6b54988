#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace limes::app {

/// Columns of numbers from a file, line by line.
struct NumberTable {
  std::size_t num_columns;
  std::vector<double> values;       ///< row by row
  std::vector<std::int64_t> lines;  ///< of each row in its file

  [[nodiscard]] std::size_t num_rows() const { return lines.size(); }
  [[nodiscard]] std::span<const double> row(std::size_t i) const {
    return std::span(values).subspan(num_columns * i, num_columns);
  }
};

/// Reads a table with commas whose first line names its columns: the named ones, in this order,
/// wherever they are in the file. Other columns and empty lines are ignored.
/// @throws InputError "FILE:LINE: ..." for what is no such table; numbers must be finite
[[nodiscard]] NumberTable read_number_table(const std::filesystem::path& file,
                                            std::span<const std::string_view> columns);

}  // namespace limes::app
