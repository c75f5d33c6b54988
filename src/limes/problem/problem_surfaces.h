#pragma once

#include <filesystem>

#include "limes/problem/surface_settings.h"
#include "limes/problem/toml.h"

namespace limes::problem_file {

/// [geometry], [[curve]] and [[seam]] of a document, each of which may be missing.
/// @throws as fail()
[[nodiscard]] SurfaceSettings surfaces_in(const toml::table& document,
                                          const std::filesystem::path& file);

}  // namespace limes::problem_file
