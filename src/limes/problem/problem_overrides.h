#pragma once

#include <span>
#include <string>

#include "limes/problem/problem_table.h"

namespace limes::problem_file {

/// Puts overrides "dotted.path=value" into a document as parsed. Paths are those of the schema, the
/// entries of lists by their number from 0 ("load.0.pressure"); where there is one table, its
/// number may be left out. The value is TOML, or else a bare string. Keys that the file does not
/// have are added, tables of lists are not.
/// @throws UsageError for a path that does not exist
void apply_overrides(toml::table& document, std::span<const std::string> overrides);

}  // namespace limes::problem_file
