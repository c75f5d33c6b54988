#include "limes/problem/place.h"

namespace limes {

std::string spoken(const Place& place) {
  return place.line > 0 ? fmt::format("line {}", place.line) : place.text;
}

Place culprit(const Place& place, std::initializer_list<Place> others) {
  if (!place.is_override)
    for (const Place& other : others)
      if (other.is_override) return {fmt::format("{}, {}", other.text, place.text), true};
  return place;
}

void fail_with(const Place& place, const std::string& what) {
  if (place.is_override) throw UsageError("{}: {}", place.text, what);
  throw PlacedError("{}: {}", place.text, what);
}

const Place& Origin::of(std::string_view key) const {
  const auto at = keys.find(key);
  return at == keys.end() ? table : at->second;
}

const Place& Origin::override_or_table() const {
  for (const auto& [key, place] : keys)
    if (place.is_override) return place;
  return table;
}

}  // namespace limes
