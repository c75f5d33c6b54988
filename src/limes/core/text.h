#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace limes {

/// Numbers and words of text files, independent of the locale. A number is the whole token or
/// nothing: "1,5", "1.0abc" and "0x1" are no numbers. A leading '+' is allowed.

/// A finite number; NaN, infinity and what overflows give nothing.
[[nodiscard]] std::optional<double> parse_real(std::string_view token);
/// The same, rounded once to single precision (for sharpness values).
[[nodiscard]] std::optional<float> parse_single(std::string_view token);
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view token);

/// The shortest text that parse_real() turns back into the same double: 1, 0.1, 1e+300, -0.
[[nodiscard]] std::string format_real(double value);

/// The blanks of a line: space, tab, and the rare vertical tab and form feed.
[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
/// Without blanks at either end.
[[nodiscard]] std::string_view trim(std::string_view text);
/// Cuts the next word off `rest`; empty when nothing but blanks is left.
[[nodiscard]] std::string_view next_token(std::string_view& rest);
/// ASCII letters only.
[[nodiscard]] std::string to_lower(std::string_view text);
[[nodiscard]] bool is_valid_utf8(std::string_view text);

/// A number with its noun: "1 face", "3 faces".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// A piece of a file as it may appear in a message: 'text' in quotes, one line, at most 40
/// characters, anything but printable ASCII shown as '?'.
[[nodiscard]] std::string quote(std::string_view text);

}  // namespace limes
