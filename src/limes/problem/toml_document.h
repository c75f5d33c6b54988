#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limes/problem/toml.h"

namespace limes {

/// The text of a TOML file. @throws InputError that names the file
[[nodiscard]] std::string read_toml_text(const std::filesystem::path& path);

/// @param file  for messages
/// @throws InputError "FILE:LINE: what" for a text that is no TOML
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::filesystem::path& file);

/// Every value with its path, tables in the order of their keys: "load.0.flux = 3"; numbers read back
/// as they are.
[[nodiscard]] std::vector<std::string> listed_values(const toml::table& table);

}  // namespace limes
