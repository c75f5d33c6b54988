#include "limes/problem/toml_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <vector>

#include "limes/core/error.h"
#include "limes/core/text.h"

namespace limes {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_file = 16U << 20U;

/// Number of the first line that is no UTF-8, 0 if all are.
std::size_t first_broken_line(std::string_view text) {
  for (std::size_t begin = 0, line = 1; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (!is_valid_utf8(text.substr(begin, end - begin))) return line;
    begin = end + 1;
  }
  return 0;
}

bool makes_toml_assert(std::string_view text) {
  try {
    (void)toml::parse(text);
  } catch (const toml::parse_error&) {
    return false;
  } catch (const TomlAssertion&) {
    return true;
  }
  return false;
}

/// Number of the line that makes toml++ assert: the last one of the shortest beginning that does.
std::size_t asserting_line(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t end = 0; (end = text.find('\n', end)) != std::string_view::npos;)
    ends.push_back(++end);
  const auto first = std::partition_point(ends.begin(), ends.end(), [&](std::size_t end) {
    return !makes_toml_assert(text.substr(0, end));
  });
  return static_cast<std::size_t>(first - ends.begin()) + 1;
}

/// In one line, different for different texts.
std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 32 || c == '\\' || c == '"' || c == 127)
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      out += c;
  return out + "\"";
}

std::string shown_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return "a date";  // no key has one
}

void list_values(const toml::node& node, const std::string& path, std::vector<std::string>& out) {
  const std::string before = path.empty() ? path : path + ".";
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      list_values(value, before + std::string(key.str()), out);
  } else if (const auto* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i)
      list_values((*array)[i], before + std::to_string(i), out);
  } else {
    out.push_back(path + " = " + shown_value(node));
  }
}

}  // namespace

std::string read_toml_text(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw InputError("{}: no such file", name);
  if (fs::is_directory(status)) throw InputError("{}: is a directory; a TOML file is right", name);
  if (!fs::is_regular_file(status)) throw InputError("{}: is no regular file", name);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"),
                                                             std::fclose);
  if (!file) throw InputError("{}: {}", name, std::generic_category().message(errno));
  if (fs::file_size(path) > largest_file)
    throw InputError("{}: is larger than 16 MiB, which no TOML file of limes is", name);
  std::string text(static_cast<std::size_t>(largest_file), '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get())) throw InputError("{}: cannot be read", name);
  return text;
}

toml::table parse_toml(std::string_view text, const std::filesystem::path& file) {
  if (const std::size_t line = first_broken_line(text))
    throw InputError("{}:{}: no valid UTF-8; TOML files are UTF-8", file.string(), line);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::string what(error.description());
    std::replace_if(
        what.begin(), what.end(), [](char c) { return c >= 0 && c < ' '; }, '?');
    throw InputError("{}:{}: {}", file.string(), error.source().begin.line, what);
  } catch (const TomlAssertion&) {
    throw InputError("{}:{}: no TOML: names consist of A-Z a-z 0-9 _ -, or stand in quotes",
                     file.string(), asserting_line(text));
  }
}

std::vector<std::string> listed_values(const toml::table& table) {
  std::vector<std::string> out;
  list_values(table, "", out);
  return out;
}

}  // namespace limes
