#pragma once

#include <string_view>

namespace limes {

/// One drawn character; the path's language is described at the table.
struct Glyph {
  char32_t character;
  double advance;
  std::string_view path;
};

/// The glyph of a character, or an empty box.
[[nodiscard]] const Glyph& find_glyph(char32_t character);

}  // namespace limes
