#pragma once

#include <filesystem>
#include <string>

namespace limes {

/// @throws InputError unless a file that can be read may be there, whatever its extension
void require_file(const std::filesystem::path& path);
/// All bytes of a file. @throws InputError
[[nodiscard]] std::string read_bytes(const std::filesystem::path& path);

}  // namespace limes
