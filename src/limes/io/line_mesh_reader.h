#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "limes/io/lines.h"
#include "limes/io/mesh_builder.h"

namespace limes {

/// What readers of meshes line by line have alike: where they are, what they build, errors that say
/// where.
class LineMeshReader {
 protected:
  /// @param first_number the format's number of the first vertex, for messages
  LineMeshReader(std::string_view text, std::string_view file, int first_number)
      : file_(file), lines_(checked_text(text, file)), builder_(file, first_number) {}

  /// An error at the present line.
  template <class... Args>
  [[nodiscard]] InputError error(fmt::format_string<Args...> format, Args&&... args) const {
    return error_at(file_, lines_.number(), format, std::forward<Args>(args)...);
  }

  std::string_view file_;
  LineReader lines_;
  MeshBuilder builder_;
};

}  // namespace limes
