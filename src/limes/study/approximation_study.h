#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limes/problem/toml_document.h"
#include "limes/study/approximation.h"

namespace limes {

// `limes study` on a file with the table [approximation]: docs/command-line.md.

struct ApproximationStudy {
  enum class Surface { graph, sphere };
  std::string title;
  Surface surface = Surface::graph;
  ApproximationOptions options;
  int rows = 4;
};

/// @throws InputError "FILE:LINE: what" for unknown keys and values out of range
[[nodiscard]] ApproximationStudy read_approximation_study(const toml::table& document,
                                                          const std::filesystem::path& file);

/// One error by step width, beside what the paper prints.
struct ErrorColumn {
  std::string name;
  std::vector<double> values;
  std::vector<double> printed;  ///< empty where the paper measured something else

  /// Ratio of the error before row i to that in row i. i >= 1.
  [[nodiscard]] static double ratio(const std::vector<double>& errors, std::size_t i) {
    return errors[i - 1] / errors[i];
  }
};

struct ErrorTable {
  std::vector<double> h;
  std::vector<ErrorColumn> columns;
};
[[nodiscard]] ErrorTable run(const ApproximationStudy& study);

/// The table with its ratios as comma-separated values.
[[nodiscard]] std::string to_csv(const ErrorTable& table);

}  // namespace limes
