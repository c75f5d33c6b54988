#pragma once

#include <span>
#include <string>
#include <string_view>

namespace limes {

/// Least number of letters to insert, drop, change, or swap with their neighbour on the way from
/// `a` to `b`; upper and lower case are the same letter.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The end of a message about a word that is not known: "did you mean 'young'?" when one of the
/// known words is close, else "known are a, b, c". At most ten are listed, the nearest first when
/// there are more.
[[nodiscard]] std::string suggest(std::string_view word, std::span<const std::string_view> known);

}  // namespace limes
