#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/ids.h"
#include "limes/mesh/mesh.h"

namespace limes {

/// What is wrong with one face; whoever knows the mesh's file adds the face's line.
class FaceError : public InputError {
 public:
  template <class... Args>
  FaceError(FaceId face, fmt::format_string<Args...> format, Args&&... args)
      : InputError(fmt::format(format, std::forward<Args>(args)...)), face_(face) {}
  [[nodiscard]] FaceId face() const { return face_; }

 private:
  FaceId face_;
};

/// "FILE:LINE" of a face, "FILE" if its line is not known.
[[nodiscard]] inline std::string place_of(const Mesh& mesh, FaceId face, std::string_view file) {
  const auto i = static_cast<std::size_t>(face.value);
  return i < mesh.face_lines.size() ? fmt::format("{}:{}", file, mesh.face_lines[i])
                                    : std::string(file);
}

}  // namespace limes
