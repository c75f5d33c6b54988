#include "limes/problem/problem_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/problem/selection.h"
#include "limes/problem/suggest.h"

namespace limes::problem_file {
namespace {

/// Not to be taken for an integer: 4.0.
std::string shown_real(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

/// A value as a message shows it.
std::string shown(const toml::node& value) {
  if (const auto text = value.value_exact<std::string>()) return quote(*text);
  if (const auto integer = value.value_exact<std::int64_t>()) return fmt::format("{}", *integer);
  if (const auto real = value.value_exact<double>()) return shown_real(*real);
  if (const auto boolean = value.value_exact<bool>()) return *boolean ? "true" : "false";
  if (const toml::array* list = value.as_array())
    return list->empty() ? "an empty list" : fmt::format("a list of {}", list->size());
  return value.is_table() ? "a table" : "a date or time";
}

/// The value or the first entry of it that comes from an override; none: all is of the file.
const toml::node* overridden(const toml::node& value) {
  if (value.source().path) return &value;
  if (const toml::array* const list = value.as_array())
    for (const toml::node& entry : *list)
      if (const toml::node* const found = overridden(entry)) return found;
  return nullptr;
}

bool contains(const std::vector<std::string_view>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

Place place_of(const toml::node& node, std::string_view file) {
  const toml::source_region& source = node.source();
  if (source.path) return {*source.path, true};
  if (!source.begin) return {std::string(file)};
  return {fmt::format("{}:{}", file, source.begin.line), false,
          static_cast<int>(source.begin.line)};
}

TableReader::TableReader(const toml::table& values, const Table& table, std::string_view file)
    : values_(&values), table_(table), file_(file) {
  for (auto&& [key, value] : values)
    check_known(key.str(), value);
  for (const Key& key : problem_keys())
    if (key.table == table.name && key.need == Need::required && !has(key.name))
      fail_with(place(), fmt::format("{} is missing: {}; {}", label(key.name), describe_value(key),
                                     key.help));
}

/// How messages name a key: "[mesh] levels".
std::string TableReader::label(std::string_view key) const {
  return table_.name.empty() ? std::string(key) : fmt::format("{} {}", written(table_), key);
}

Place TableReader::place(std::string_view key) const {
  const toml::node* const value = find(key);
  return place_of(value ? *value : *values_, file_);
}

Origin TableReader::origin() const {
  Origin out{place(), {}};
  for (auto&& [key, value] : *values_) {
    const toml::node* const changed = overridden(value);
    out.keys.emplace(key.str(), place_of(changed ? *changed : value, file_));
  }
  return out;
}

const toml::node* TableReader::find(std::string_view key) const {
  return values_->get(key);
}

void TableReader::check_known(std::string_view name, const toml::node& value) const {
  const Key* const key = find_key(table_.name, name);
  const Table* const table = table_.name.empty() ? find_table(name) : nullptr;
  const bool later = (key && key->need == Need::later) || (table && table->need == Need::later);
  if ((key || table) && !later) return;
  const Place where = place_of(value, file_);
  const std::vector<std::string_view> known = names_in(table_.name);
  if (later)
    fail_with(where, fmt::format("{} is not available yet; available are {}",
                                 table ? written(*table) : label(name), fmt::join(known, ", ")));
  const std::string owner = table_.name.empty() ? "a problem" : written(table_);
  fail_with(where, fmt::format("{} has no key {}; {}", owner, quote(name), suggest(name, known)));
}

std::string_view TableReader::chosen_key() const {
  std::vector<std::string_view> all, given;
  for (const Key& key : problem_keys()) {
    if (key.table != table_.name || key.need != Need::one_of) continue;
    all.push_back(key.name);
    if (has(key.name)) given.push_back(key.name);
  }
  if (given.empty())
    fail_with(place(), fmt::format("{} has none of {}; exactly one is right", written(table_),
                                   fmt::join(all, ", ")));
  if (given.size() > 1)
    fail_with(place(given[1]), fmt::format("{} has both {} and {}; exactly one is right",
                                           written(table_), given[0], given[1]));
  return given[0];
}

void TableReader::fail_value(const Key& key, const toml::node& value) const {
  fail_with(place_of(value, file_), fmt::format("{} is {}; it must be {}", label(key.name),
                                                shown(value), describe_value(key)));
}

void TableReader::check_choice(const Key& key, const std::string& word,
                               const toml::node& value) const {
  const auto known = split_words(key.choices);
  if (contains(known, word)) return;
  if (contains(split_words(key.later_choices), word))
    fail_with(place_of(value, file_), fmt::format("{} '{}' is not available yet; available are {}",
                                                  label(key.name), word, fmt::join(known, ", ")));
  fail_with(place_of(value, file_),
            fmt::format("{} is {}; {}", label(key.name), quote(word), suggest(word, known)));
}

double TableReader::number(const Key& key, const toml::node& value) const {
  if (!value.is_number()) fail_value(key, value);
  const double result = to_double(value);
  if (!std::isfinite(result))
    fail_with(place_of(value, file_),
              fmt::format("{} is {}; it must be finite", label(key.name), shown(value)));
  if (!key.range.contains(result)) fail_value(key, value);
  return result;
}

Expression TableReader::formula(const Key& key, const toml::node& value) const {
  const auto text = value.value_exact<std::string>();
  if (!text) return Expression(number(key, value));
  try {
    return Expression(*text);
  } catch (const InputError& error) {
    fail_with(place_of(value, file_), fmt::format("{}: {}", label(key.name), error.what()));
  }
}

std::vector<const toml::node*> TableReader::entries(const Key& key, const toml::node& value,
                                                    std::size_t fewest, std::size_t most) const {
  const toml::array* const list = value.as_array();
  if (!list || list->size() < fewest || list->size() > most) fail_value(key, value);
  std::vector<const toml::node*> result;
  for (const toml::node& entry : *list)
    result.push_back(&entry);
  return result;
}

void TableReader::read(std::string_view name, std::string& value) const {
  const toml::node* const node = find(name);
  if (!node) return;
  const Key& key = *find_key(table_.name, name);
  const auto text = node->value_exact<std::string>();
  if (!text) fail_value(key, *node);
  if (key.type == ValueType::name) check_choice(key, *text, *node);
  if (key.type == ValueType::text && trim(*text).empty())
    fail_with(place_of(*node, file_), fmt::format("{} is empty", label(name)));
  if (key.type == ValueType::selection) {
    try {
      (void)parse_where(*text);
    } catch (const InputError& error) {
      fail_with(place_of(*node, file_), fmt::format("{}: {}", label(name), error.what()));
    }
  }
  value = *text;
}

void TableReader::read(std::string_view name, std::vector<std::string>& value) const {
  const toml::node* const node = find(name);
  if (!node) return;
  const Key& key = *find_key(table_.name, name);
  constexpr std::size_t most = 100;
  std::vector<std::string> words;
  for (const toml::node* entry : entries(key, *node, 1, most)) {
    const auto word = entry->value_exact<std::string>();
    if (!word) fail_value(key, *entry);
    if (key.type == ValueType::names) check_choice(key, *word, *entry);
    if (std::find(words.begin(), words.end(), *word) != words.end())
      fail_with(place_of(*entry, file_), fmt::format("{} has '{}' twice", label(name), *word));
    words.push_back(*word);
  }
  value = words;
}

void TableReader::read(std::string_view name, int& value) const {
  const toml::node* const node = find(name);
  if (!node) return;
  const Key& key = *find_key(table_.name, name);
  if (!node->is_integer()) fail_value(key, *node);
  value = static_cast<int>(number(key, *node));
}

void TableReader::read(std::string_view name, double& value) const {
  const toml::node* const node = find(name);
  if (node) value = number(*find_key(table_.name, name), *node);
}

void TableReader::read(std::string_view name, bool& value) const {
  const toml::node* const node = find(name);
  if (!node) return;
  if (!node->is_boolean()) fail_value(*find_key(table_.name, name), *node);
  value = *node->value_exact<bool>();
}

void TableReader::read(std::string_view name, Expression& value) const {
  const toml::node* const node = find(name);
  if (node) value = formula(*find_key(table_.name, name), *node);
}

void TableReader::read(std::string_view name, std::array<Expression, 3>& value) const {
  const toml::node* const node = find(name);
  if (!node) return;
  const Key& key = *find_key(table_.name, name);
  value = {};
  std::size_t i = 0;
  for (const toml::node* entry : entries(key, *node, 2, 3))
    value[i++] = formula(key, *entry);
}

void TableReader::read(std::string_view name, Vec3& value) const {
  const toml::node* const node = find(name);
  if (!node) return;
  const Key& key = *find_key(table_.name, name);
  value.setZero();
  Eigen::Index i = 0;
  for (const toml::node* entry : entries(key, *node, 2, 3))
    value[i++] = number(key, *entry);
}

void TableReader::read(std::string_view name, Mat2& value) const {
  const toml::node* const node = find(name);
  if (!node) return;
  const Key& key = *find_key(table_.name, name);
  Eigen::Index i = 0;
  for (const toml::node* row : entries(key, *node, 2, 2)) {
    Eigen::Index j = 0;
    for (const toml::node* entry : entries(key, *row, 2, 2))
      value(i, j++) = number(key, *entry);
    ++i;
  }
}

std::vector<TableReader> tables_of(const toml::table& document, std::string_view name,
                                   std::string_view file) {
  const Table& table = *find_table(name);
  const toml::node* const node = document.get(name);
  if (!node) {
    if (table.need == Need::required)
      fail_with({std::string(file)}, fmt::format("{} is missing: {}", written(table), table.help));
    return {};
  }
  const Place where = place_of(*node, file);
  if (const toml::table* values = node->as_table()) {
    if (table.form == TableForm::list)
      fail_with(where, fmt::format("there may be several {0}; write {0}", written(table)));
    return {TableReader(*values, table, file)};
  }
  const toml::array* const list = node->as_array();
  if (!list || table.form == TableForm::single)
    fail_with(where, fmt::format("{} is no table; write [{}]", name, name));
  if (list->empty()) fail_with(where, fmt::format("{} is an empty list", name));
  std::vector<TableReader> result;
  for (const toml::node& entry : *list) {
    if (!entry.is_table())
      fail_with(place_of(entry, file),
                fmt::format("{} is a list of tables; write [[{}]]", name, name));
    result.emplace_back(*entry.as_table(), table, file);
  }
  return result;
}

void refuse_keys(const TableReader& table, std::string_view name,
                 std::initializer_list<std::string_view> keys, std::string_view whose,
                 const Place& reason) {
  for (const std::string_view key : keys)
    if (table.has(key))
      fail_with(culprit(table.place(key), {reason}),
                fmt::format("[{}] {} is no key of {}; remove it", name, key, whose));
}

}  // namespace limes::problem_file
