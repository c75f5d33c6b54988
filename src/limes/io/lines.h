#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "limes/core/error.h"

namespace limes {

/// "FILE:LINE: what is wrong; what would be right"
template <class... Args>
[[nodiscard]] InputError error_at(std::string_view file, std::int64_t line,
                                  fmt::format_string<Args...> format, Args&&... args) {
  return InputError("{}:{}: {}", file, line, fmt::format(format, std::forward<Args>(args)...));
}

/// The text without its UTF-8 byte order mark.
/// @throws InputError for UTF-16 and for NUL bytes
[[nodiscard]] std::string_view checked_text(std::string_view bytes, std::string_view file);

/// The lines of a text one after the other; LF, CRLF and CR end a line.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// Moves to the next line; false at the end.
  bool next();
  /// The same, but a backslash at the end joins the next line; comments ('#') are never joined.
  bool next_joined();

  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] std::int64_t number() const { return number_; }  ///< 1 is the first
  [[nodiscard]] std::string_view rest() const { return rest_; }  ///< text after the line

 private:
  std::string_view rest_, line_;
  std::string joined_;
  std::int64_t number_ = 0, lines_read_ = 0;
};

/// The words of a text one after the other, with their line numbers.
class WordReader {
 public:
  explicit WordReader(std::string_view text, std::int64_t first_line = 1)
      : rest_(text), line_(first_line) {}

  /// The next word; empty at the end.
  [[nodiscard]] std::string_view next();
  void skip_line();

  [[nodiscard]] std::int64_t line() const { return line_; }  ///< of the word read last
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  void skip_line_end();

  std::string_view rest_;
  std::int64_t line_;
};

}  // namespace limes
