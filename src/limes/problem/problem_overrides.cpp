#include "limes/problem/problem_overrides.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <utility>
#include <vector>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/problem/suggest.h"

namespace limes::problem_file {
namespace {

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (byte < 0x20 || byte == 0x7f)
      result += fmt::format("\\u{:04x}", byte);
    else
      result += c;
  }
  return result + "\"";
}

/// As messages show a path: one line, not too long.
std::string shown(std::string_view path) {
  const std::string quoted = quote(path);
  return quoted.substr(1, quoted.size() - 2);
}

/// One override, on its way down the document.
class Override {
 public:
  explicit Override(const std::string& text);
  void apply(toml::table& document);

 private:
  [[noreturn]] void fail(std::string_view what) const { throw UsageError("{}: {}", label_, what); }
  [[nodiscard]] bool at_end() const { return next_ == path_.size(); }
  toml::table* find_or_add(toml::table& document, const Table& table);
  toml::table* list_entry(toml::array& list, const Table& table);
  std::size_t index(std::size_t size, std::string_view what);
  void set_key(toml::table& values, const Table& table);
  void set_entry(toml::node& value);
  toml::table parsed_value() const;

  std::string label_, value_;
  std::vector<std::string> path_;
  std::size_t next_ = 0;
};

Override::Override(const std::string& text) : label_("--set " + quote(text)) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    fail("there is no '='; right is a path and a value, as in mesh.levels=3");
  if (!is_valid_utf8(text)) fail("it is no valid UTF-8");
  std::string path(trim(std::string_view(text).substr(0, equals)));
  label_ = "--set " + shown(path);
  value_ = trim(std::string_view(text).substr(equals + 1));
  for (std::size_t dot; (dot = path.find('.')) != std::string::npos; path.erase(0, dot + 1))
    path_.push_back(path.substr(0, dot));
  path_.push_back(path);
}

/// {value = ...}, every node with the override as its source.
toml::table Override::parsed_value() const {
  try {
    toml::table table = toml::parse("value = " + value_, label_);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
    // no TOML: a bare string
  } catch (const TomlAssertion&) {
    // the same
  }
  return toml::parse("value = " + toml_string(value_), label_);
}

void Override::apply(toml::table& document) {
  const std::string& name = path_[next_++];
  if (find_key("", name)) {
    next_ = 0;
    return set_key(document, Table{});
  }
  const Table* const table = find_table(name);
  if (!table)
    fail(fmt::format("a problem has no {}; {}", quote(name), suggest(name, names_in(""))));
  if (table->need == Need::later)
    fail(fmt::format("{} is not available yet; available are {}", written(*table),
                     fmt::join(names_in(""), ", ")));
  if (toml::table* const values = find_or_add(document, *table)) set_key(*values, *table);
}

/// Nothing if the file says something else under that name; its reader complains then.
toml::table* Override::find_or_add(toml::table& document, const Table& table) {
  if (!document.contains(table.name)) {
    if (table.form == TableForm::list) fail(fmt::format("the file has no {}", written(table)));
    document.insert(table.name, std::move(*toml::parse("value = {}", label_).get("value")));
  }
  toml::node& node = *document.get(table.name);
  if (toml::array* const list = node.as_array())
    return table.form == TableForm::single ? nullptr : list_entry(*list, table);
  const bool numbered = !at_end() && parse_integer(path_[next_]).has_value();
  if (node.is_table() && table.form == TableForm::single_or_list && numbered)
    (void)index(1, written(table));
  return node.as_table();
}

toml::table* Override::list_entry(toml::array& list, const Table& table) {
  const bool numbered = !at_end() && parse_integer(path_[next_]).has_value();
  if (!numbered && list.size() != 1)
    fail(fmt::format("there are {} tables {}; right is {}.0 to {}.{}", list.size(),
                     fmt::format("[[{}]]", table.name), table.name, table.name, list.size() - 1));
  const std::size_t i = numbered ? index(list.size(), fmt::format("[[{}]]", table.name)) : 0;
  return list[i].as_table();
}

/// Takes a number off the path, below `size`.
std::size_t Override::index(std::size_t size, std::string_view what) {
  const std::string& word = path_[next_++];
  const std::optional<std::int64_t> number = parse_integer(word);
  if (!number) fail(fmt::format("{} is no number of an entry of {}", quote(word), what));
  if (*number < 0 || *number >= static_cast<std::int64_t>(size))
    fail(fmt::format("there is no entry {} of {}; {}", *number, what,
                     size ? fmt::format("they count from 0 to {}", size - 1) : "it is empty"));
  return static_cast<std::size_t>(*number);
}

void Override::set_key(toml::table& values, const Table& table) {
  const std::vector<std::string_view> known = names_in(table.name);
  if (at_end())
    fail(fmt::format("{} is a table; name one of its keys {}", written(table),
                     fmt::join(known, ", ")));
  const std::string& name = path_[next_++];
  const Key* const key = find_key(table.name, name);
  if (!key)
    fail(fmt::format("{} has no key {}; {}", written(table), quote(name), suggest(name, known)));
  if (key->need == Need::later)
    fail(fmt::format("{} {} is not available yet; available are {}", written(table), name,
                     fmt::join(known, ", ")));
  if (at_end()) {
    values.insert_or_assign(name, std::move(*parsed_value().get("value")));
    return;
  }
  toml::node* const value = values.get(name);
  if (!value) fail(fmt::format("the file has no {}, whose entries could be set", quote(name)));
  set_entry(*value);
}

/// The rest of the path are numbers of entries in nested lists.
void Override::set_entry(toml::node& value) {
  toml::node* node = &value;
  for (;;) {
    toml::array* const list = node->as_array();
    if (!list)
      fail(fmt::format("there is no list whose entry {} could be set", quote(path_[next_])));
    const std::size_t i = index(list->size(), "the list");
    if (at_end()) {
      list->replace(list->cbegin() + static_cast<std::ptrdiff_t>(i),
                    std::move(*parsed_value().get("value")));
      return;
    }
    node = list->get(i);
  }
}

}  // namespace

void apply_overrides(toml::table& document, std::span<const std::string> overrides) {
  for (const std::string& text : overrides)
    Override(text).apply(document);
}

}  // namespace limes::problem_file
