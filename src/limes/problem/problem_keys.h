#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limes::problem_file {

// Everything a problem file may say, as one table. Messages ("did you mean"), checks of type and
// range, and the documentation are made from it. A new key is a row here, a line in problem.cpp
// that reads it, and a row in docs/problem-file.md.

enum class ValueType {
  text,            ///< not empty
  name,            ///< one of Key::choices
  names,           ///< a list of Key::choices, not empty, none twice
  texts,           ///< a list of texts, not empty, none twice
  integer,         ///< within Key::range
  number,          ///< within Key::range
  boolean,         ///< true, false
  formula,         ///< a number, or text with a formula in x, y, z
  formula_vector,  ///< two or three formulas
  point,           ///< two or three numbers
  matrix,          ///< 2 x 2 numbers, rows first
  selection        ///< text that selects, see selection.h
};

/// Numbers from low to high. Open: without the end itself.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  [[nodiscard]] bool contains(double value) const;
};
[[nodiscard]] constexpr Range above(double low) {
  return {.low = low, .low_open = true};
}
[[nodiscard]] constexpr Range between(double low, double high) {
  return {.low = low, .high = high, .low_open = true, .high_open = true};
}
[[nodiscard]] constexpr Range from_to(double low, double high) {
  return {.low = low, .high = high};
}

enum class Need {
  required,
  optional,
  one_of,  ///< exactly one of the keys of its table that are marked so
  later    ///< part of the language, not available in this version
};

struct Key {
  std::string_view table;  ///< empty: at the top of the file
  std::string_view name;
  ValueType type = ValueType::text;
  Need need = Need::optional;
  Range range = {};
  std::string_view choices = {};        ///< separated by blanks
  std::string_view later_choices = {};  ///< known, not available in this version
  std::string_view initial = {};        ///< what holds when the key is absent, as text
  std::string_view help = {};           ///< one line
};

/// How often a table may appear.
enum class TableForm {
  single,          ///< [name]
  list,            ///< [[name]], any number of times
  single_or_list,  ///< either
};

struct Table {
  std::string_view name;
  TableForm form = TableForm::single;
  Need need = Need::optional;
  std::string_view help = {};
};

[[nodiscard]] std::span<const Table> problem_tables();
[[nodiscard]] std::span<const Key> problem_keys();

/// Nothing if there is no such name.
[[nodiscard]] const Table* find_table(std::string_view name);
[[nodiscard]] const Key* find_key(std::string_view table, std::string_view name);

/// Names of the tables, or of the keys of a table, that are available; empty: the top of the file,
/// which has keys and tables.
[[nodiscard]] std::vector<std::string_view> names_in(std::string_view table);

/// The table as users write it: "[mesh]", "[[load]]".
[[nodiscard]] std::string written(const Table& table);
/// What the value of a key must be: "a number > 0", "one of plane-stress, plane-strain".
[[nodiscard]] std::string describe_value(const Key& key);
/// The words of Key::choices.
[[nodiscard]] std::vector<std::string_view> split_words(std::string_view words);

}  // namespace limes::problem_file
