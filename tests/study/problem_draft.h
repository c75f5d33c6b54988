#pragma once

// What the tests of problem files share.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limes/core/error.h"
#include "limes/problem/problem.h"
#include "limes/problem/problem_keys.h"

namespace limes {

using namespace problem_file;

inline std::string whole_file(const std::string& name) {
  std::ifstream file(LIMES_TEST_DATA_DIR "/study/" + name);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A problem that has every key that plane models have.
inline const std::string& full() {
  static const std::string text = whole_file("full.toml");
  return text;
}

/// A shell on a cylinder with every key that only shells have.
inline const std::string& full_shell() {
  static const std::string text = whole_file("full_shell.toml");
  return text;
}

/// A shell with the keys that a graph has instead.
inline const std::string& full_graph() {
  static const std::string text = whole_file("full_graph.toml");
  return text;
}

inline Problem parse(std::string_view text, const std::vector<std::string>& overrides = {}) {
  return parse_problem(text, "p.toml", overrides);
}

/// The message of the error of type Expected; fails the test when there is none.
template <class Expected>
std::string message_of(std::string_view text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)parse(text, overrides);
  } catch (const Expected& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another kind of error: " << error.what();
    return {};
  }
  ADD_FAILURE() << "accepted:\n" << text;
  return {};
}

inline void expect_message(const std::string& message, std::string_view beginning,
                           const std::vector<std::string>& parts) {
  EXPECT_EQ(message.substr(0, beginning.size()), beginning);
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks " << part;
}

/// A shell of two parts with the keys that only those have.
inline const std::string& full_parts() {
  static const std::string text = whole_file("full_parts.toml");
  return text;
}

/// Poisson's equation, refined adaptively, with the keys that only those have.
inline const std::string& full_poisson() {
  static const std::string text = whole_file("full_poisson.toml");
  return text;
}

/// A small valid problem as lines of tables, to change one of them.
class Draft {
 public:
  using Lines = std::vector<std::pair<std::string, std::string>>;  // key, value

  Draft() {
    set("mesh", "file", "\"m.obj\"");
    set("model", "kind", "\"plane-stress\"");
    set("material", "young", "1");
    set("material", "poisson", "0.25");
    set("support", "where", "\"x == 0\"");
    set("support", "fix", "[\"ux\", \"uy\"]");
  }

  void set(const std::string& table, const std::string& key, const std::string& value) {
    for (auto& [k, v] : tables_[table])
      if (k == key) {
        v = value;
        return;
      }
    tables_[table].emplace_back(key, value);
  }
  void erase(const std::string& table, const std::string& key) {
    std::erase_if(tables_[table], [&](const auto& line) { return line.first == key; });
  }
  void erase(const std::string& table) { tables_.erase(table); }

  /// What a table needs besides `key`.
  void complete(const std::string& table, const std::string& key) {
    if (table == "load") set(table, "where", "\"all\"");
    if (table == "load" && find_key(table, key)->need != Need::one_of)
      set(table, "force", "[0, 0]");
    if (table == "geometry") {
      set("model", "kind", "\"mitc4\"");
      const bool formula = key == "height" || key == "zero";
      set(table, "kind",
          key == "height"        ? "\"graph\""
          : key == "zero"        ? "\"formula\""
          : key == "angle"       ? "\"cone\""
          : key == "tube_radius" ? "\"torus\""
                                 : "\"cylinder\"");
      set(table, formula || key == "angle" ? key : "radius", "1");
      if (key == "tube_radius") set(table, key, "0.5");
    }
    if (table == "curve") {
      complete("geometry", "radius");
      set("mesh", "placement", "\"exact\"");
      set(table, "where", "\"boundary\"");
      set(table, "zero", "\"x\"");
    }
    if (key == "smooth_start" || key == "smoothing") {
      complete("geometry", "radius");
      set("mesh", "placement", "\"exact\"");
    }
    if (table == "seam") {
      set("model", "kind", "\"mitc4\"");
      set(table, "parts", "[\"a\", \"b\"]");
    }
    if (key == "shear_factor" || key == "kink_angle" || key == "membrane" || key == "drilling" ||
        key == "junctions")
      set("model", "kind", "\"mitc4\"");
    if (table == "support" && (key == "kind" || key == "rotation")) {
      set("model", "kind", "\"mitc4\"");
      erase(table, "fix");
      set(table, "kind", "\"supported\"");
    }
    if (key == "conductivity" || key == "value" || key == "source" || key == "flux") {
      set("mesh", "scheme", "\"linear\"");
      set("model", "kind", "\"poisson\"");
      erase("material", "young");
      erase("material", "poisson");
      set("material", "conductivity", "1");
      erase("support", "fix");
      set("support", "value", "0");
    }
    if (table == "adapt") set("mesh", "scheme", "\"linear\"");
    if (table == "probe") set(table, "name", "\"a\""), set(table, "at", "[0, 0]");
    if (table == "periodic") set(table, "gradient", "[[1, 0], [0, 1]]");
  }

  [[nodiscard]] std::string text() const {
    std::string result;
    for (const auto& [table, lines] : tables_) {
      if (!table.empty()) result += written(*find_table(table)) + "\n";
      for (const auto& [key, value] : lines)
        result += key + " = " + value + "\n";
    }
    return result;
  }
  /// Line of a key, or of the head of the table when the key is empty.
  [[nodiscard]] int line(const std::string& table, const std::string& key) const {
    int number = 0;
    for (const auto& [name, lines] : tables_) {
      if (!name.empty()) ++number;
      if (name == table && key.empty()) return number;
      for (const auto& [k, v] : lines) {
        ++number;
        if (name == table && k == key) return number;
      }
    }
    return -1;
  }

 private:
  std::map<std::string, Lines> tables_;
};

}  // namespace limes
