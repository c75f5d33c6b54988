#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "limes/core/types.h"
#include "limes/problem/expression.h"
#include "limes/problem/place.h"
#include "limes/problem/problem_keys.h"
#include "limes/problem/toml.h"

namespace limes::problem_file {

/// Nodes that come from overrides carry the override as the path of their source.
[[nodiscard]] Place place_of(const toml::node& node, std::string_view file);

/// One table of a problem file, checked key by key against problem_keys.h. Keeps references.
class TableReader {
 public:
  /// Checks that every key is known and available, and that none is missing.
  /// @param table  its row in the schema; a nameless one for the top of the file
  TableReader(const toml::table& values, const Table& table, std::string_view file);

  [[nodiscard]] bool has(std::string_view key) const { return values_->contains(key); }
  /// Of the key if it is there, else of the table.
  [[nodiscard]] Place place(std::string_view key = {}) const;
  [[nodiscard]] Origin origin() const;
  /// The one key of those marked Need::one_of; checked to be there and alone.
  [[nodiscard]] std::string_view chosen_key() const;

  // Each reads the value of a key of the fitting type; an absent key leaves `value` as it is.
  void read(std::string_view key, std::string& value) const;
  void read(std::string_view key, std::vector<std::string>& value) const;
  void read(std::string_view key, int& value) const;
  void read(std::string_view key, double& value) const;
  void read(std::string_view key, bool& value) const;
  void read(std::string_view key, Expression& value) const;
  void read(std::string_view key, std::array<Expression, 3>& value) const;
  void read(std::string_view key, Vec3& value) const;
  void read(std::string_view key, Mat2& value) const;

 private:
  [[nodiscard]] const toml::node* find(std::string_view key) const;
  [[nodiscard]] std::string label(std::string_view key) const;
  [[noreturn]] void fail_value(const Key& key, const toml::node& value) const;
  void check_known(std::string_view key, const toml::node& value) const;
  void check_choice(const Key& key, const std::string& word, const toml::node& value) const;
  [[nodiscard]] double number(const Key& key, const toml::node& value) const;
  [[nodiscard]] Expression formula(const Key& key, const toml::node& value) const;
  /// The entries of a list, `fewest` to `most` of them.
  [[nodiscard]] std::vector<const toml::node*> entries(const Key& key, const toml::node& value,
                                                       std::size_t fewest, std::size_t most) const;

  const toml::table* values_;
  Table table_;
  std::string_view file_;
};

/// All tables of that name: none, one, or a list. @throws as fail() for one that is required and missing
[[nodiscard]] std::vector<TableReader> tables_of(const toml::table& document, std::string_view name,
                                                 std::string_view file);

/// For keys that mean nothing to the kind that the table names.
/// @param reason  where that kind was said
void refuse_keys(const TableReader& table, std::string_view name,
                 std::initializer_list<std::string_view> keys, std::string_view whose,
                 const Place& reason);

}  // namespace limes::problem_file
