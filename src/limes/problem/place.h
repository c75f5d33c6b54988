#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "limes/core/error.h"

namespace limes {

/// Where a problem says something, for messages: a line of its file, or an override.
struct Place {
  std::string text;  ///< "FILE:LINE", "FILE", or the override: "--set mesh.levels"
  bool is_override = false;
  int line = 0;  ///< of the file; 0: none
};

/// How a message at another place speaks of this one: "line 12", or the override.
[[nodiscard]] std::string spoken(const Place& place);

/// The one to blame of values that do not fit together: the place itself, but an override rather than a
/// line of the file, which is then named beside it.
[[nodiscard]] Place culprit(const Place& place, std::initializer_list<Place> others);

/// What is wrong at a place, which its message begins with; nothing has to be put before it.
class PlacedError : public InputError {
  using InputError::InputError;
};

/// @throws UsageError for an override, else PlacedError: "PLACE: what"
[[noreturn]] void fail_with(const Place& place, const std::string& what);
template <class... Args>
[[noreturn]] void fail_at(const Place& place, fmt::format_string<Args...> format, Args&&... args) {
  fail_with(place, fmt::format(format, std::forward<Args>(args)...));
}

/// Where a table of a problem and the values of its keys were said.
struct Origin {
  Place table;
  std::map<std::string, Place, std::less<>> keys;

  /// Of the key if it was said, else of the table. An override of a single entry of a list counts.
  [[nodiscard]] const Place& of(std::string_view key) const;
  /// The first override among the keys, else the table.
  [[nodiscard]] const Place& override_or_table() const;
};

}  // namespace limes
