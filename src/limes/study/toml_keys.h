#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limes/problem/toml.h"

namespace limes {

/// The keys of a table of a study file, taken one by one; what is left is not known. Keeps a reference
/// to the table. Values of the wrong type or out of range are InputErrors "FILE:LINE: what".
class TomlKeys {
 public:
  /// @param name  of the table for messages, with a blank behind: "[refinement] "; empty at the top
  TomlKeys(const toml::table& table, std::string name, std::string file)
      : table_(&table), name_(std::move(name)), file_(std::move(file)) {}

  [[noreturn]] void fail(const toml::node& at, const std::string& what) const;
  /// Naming the table's own line.
  [[noreturn]] void fail(const std::string& what) const { fail(*table_, what); }

  /// Nothing if the key is not there.
  const toml::node* take(std::string_view key);
  double number(std::string_view key, double initial, double low, double high);
  int integer(std::string_view key, int initial, int low, int high);
  std::string text(std::string_view key, std::string initial);
  std::vector<std::string> texts(std::string_view key);
  std::vector<int> integers(std::string_view key, int low, int high);

  /// @throws InputError naming a key that was not taken
  void require_no_others() const;

 private:
  const toml::table* table_;
  std::string name_, file_;
  std::vector<std::string_view> known_;
};

}  // namespace limes
