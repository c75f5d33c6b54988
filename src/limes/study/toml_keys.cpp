#include "limes/study/toml_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "limes/core/error.h"
#include "limes/problem/suggest.h"

namespace limes {

void TomlKeys::fail(const toml::node& at, const std::string& what) const {
  throw InputError("{}:{}: {}", file_, at.source().begin.line, what);
}

const toml::node* TomlKeys::take(std::string_view key) {
  known_.push_back(key);
  return table_->get(key);
}

double TomlKeys::number(std::string_view key, double initial, double low, double high) {
  const toml::node* const node = take(key);
  if (!node) return initial;
  const double value = node->is_number() ? to_double(*node) : 0;
  if (!node->is_number() || !(value >= low && value <= high))
    fail(*node, fmt::format("{}{} must be a number from {:.6g} to {:.6g}", name_, key, low, high));
  return value;
}

int TomlKeys::integer(std::string_view key, int initial, int low, int high) {
  const toml::node* const node = take(key);
  if (!node) return initial;
  const auto value = node->value_exact<std::int64_t>();
  if (!value || *value < low || *value > high)
    fail(*node, fmt::format("{}{} must be a whole number from {} to {}", name_, key, low, high));
  return static_cast<int>(*value);
}

std::string TomlKeys::text(std::string_view key, std::string initial) {
  const toml::node* const node = take(key);
  if (!node) return initial;
  const auto value = node->value_exact<std::string>();
  if (!value) fail(*node, fmt::format("{}{} must be text", name_, key));
  return *value;
}

std::vector<std::string> TomlKeys::texts(std::string_view key) {
  const toml::node* const node = take(key);
  std::vector<std::string> out;
  if (!node) return out;
  const toml::array* const list = node->as_array();
  if (!list) fail(*node, fmt::format("{}{} must be a list of texts", name_, key));
  for (const toml::node& entry : *list) {
    const auto value = entry.value_exact<std::string>();
    if (!value) fail(entry, fmt::format("{}{} must be a list of texts", name_, key));
    out.push_back(*value);
  }
  return out;
}

std::vector<int> TomlKeys::integers(std::string_view key, int low, int high) {
  const toml::node* const node = take(key);
  std::vector<int> out;
  if (!node) return out;
  const auto what =
      fmt::format("{}{} must be a list of whole numbers from {} to {}", name_, key, low, high);
  const toml::array* const list = node->as_array();
  if (!list) fail(*node, what);
  for (const toml::node& entry : *list) {
    const auto value = entry.value_exact<std::int64_t>();
    if (!value || *value < low || *value > high) fail(entry, what);
    out.push_back(static_cast<int>(*value));
  }
  return out;
}

void TomlKeys::require_no_others() const {
  for (auto&& [key, value] : *table_)
    if (std::find(known_.begin(), known_.end(), key.str()) == known_.end())
      fail(value,
           fmt::format("there is no key {}{}; {}", name_, key.str(), suggest(key.str(), known_)));
}

}  // namespace limes
