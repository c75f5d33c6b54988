#pragma once

#include <string>
#include <vector>

namespace limes::app {

/// Text in columns that line up; the first row is the head.
[[nodiscard]] std::string format_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace limes::app
