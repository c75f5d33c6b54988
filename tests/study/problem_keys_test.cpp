#include "limes/problem/problem_keys.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include "limes/core/error.h"
#include "study/problem_draft.h"

namespace limes {
namespace {

TEST(ProblemKeys, EveryAvailableKeyIsInTheFullExample) {
  std::set<std::string> seen;
  std::istringstream lines{full() + full_shell() + full_graph() + full_parts() + full_poisson()};
  std::string table;
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.substr(0, line.find(" ="));
    if (line[0] == '[')
      table = line.substr(line.find_last_of('[') + 1, line.find(']') - line.find_last_of('[') - 1);
    else
      seen.insert(table + "." + name);
  }
  for (const Key& key : problem_keys()) {
    const std::string path = std::string(key.table) + "." + std::string(key.name);
    EXPECT_EQ(seen.count(path), key.need == Need::later ? 0U : 1U) << path;
  }
}

TEST(ProblemKeys, EveryKeyHasHelpAndBelongsToATable) {
  for (const Key& key : problem_keys()) {
    EXPECT_FALSE(key.help.empty()) << key.name;
    EXPECT_TRUE(key.table.empty() || find_table(key.table)) << key.name;
    if (key.need != Need::later) {
      EXPECT_FALSE(describe_value(key).empty()) << key.name;
    }
  }
  for (const Table& table : problem_tables())
    EXPECT_FALSE(table.help.empty()) << table.name;
}

TEST(ProblemKeys, EveryKeyRefusesAWrongTypeWithItsLine) {
  for (const Key& key : problem_keys()) {
    if (key.need == Need::later) continue;
    for (const char* wrong : {"1979-05-27", "{ a = 1 }", "[[[1]]]", "[]"}) {
      Draft draft;
      const std::string table(key.table), name(key.name);
      draft.complete(table, name);
      draft.set(table, name, wrong);
      const std::string where = table.empty() ? name : written(*find_table(table)) + " " + name;
      expect_message(message_of<InputError>(draft.text()),
                     fmt::format("p.toml:{}: {} is ", draft.line(table, name), where),
                     {"it must be " + describe_value(key)});
    }
  }
}

TEST(ProblemKeys, EveryMisspeltKeyIsToldTheRightOne) {
  for (const Key& key : problem_keys()) {
    if (key.need == Need::later) continue;
    Draft draft;
    const std::string table(key.table), name(key.name);
    draft.complete(table, name);
    const std::size_t half = name.size() / 2;
    const std::string misspelt = fmt::format("{}q{}", name.substr(0, half), name.substr(half));
    draft.set(table, misspelt, "1");
    expect_message(message_of<InputError>(draft.text()),
                   fmt::format("p.toml:{}: ", draft.line(table, misspelt)),
                   {fmt::format("has no key '{}'; ", misspelt), fmt::format("'{}'", name)});
  }
}

TEST(ProblemKeys, EveryRequiredKeyIsMissed) {
  for (const Key& key : problem_keys()) {
    if (key.need != Need::required) continue;
    Draft draft;
    const std::string table(key.table), name(key.name);
    draft.complete(table, name);
    draft.erase(table, name);
    expect_message(message_of<InputError>(draft.text()),
                   fmt::format("p.toml:{}: {} {} is missing: ", draft.line(table, ""),
                               written(*find_table(table)), name),
                   {std::string(key.help)});
  }
}

TEST(ProblemKeys, EveryRequiredTableIsMissed) {
  for (const Table& table : problem_tables()) {
    if (table.need != Need::required) continue;
    Draft draft;
    draft.erase(std::string(table.name));
    expect_message(message_of<InputError>(draft.text()),
                   "p.toml: " + written(table) + " is missing", {});
  }
}

TEST(ProblemKeys, EveryMisspeltTableIsToldTheRightOne) {
  for (const Table& table : problem_tables()) {
    if (table.need == Need::later) continue;
    const std::string misspelt = std::string(table.name) + "x";
    const std::string draft = Draft().text() + fmt::format("[{}]\n", misspelt);
    const auto lines = std::count(draft.begin(), draft.end(), '\n');
    expect_message(message_of<InputError>(draft), fmt::format("p.toml:{}: ", lines),
                   {"a problem has no key '" + misspelt + "'; did you mean '" +
                    std::string(table.name) + "'?"});
  }
}

TEST(ProblemKeys, WhatComesLaterSaysSo) {
  for (const Table& table : problem_tables()) {
    if (table.need != Need::later) continue;
    const std::string text = Draft().text() + written(table) + "\n";
    const auto lines = std::count(text.begin(), text.end(), '\n');
    expect_message(message_of<InputError>(text),
                   fmt::format("p.toml:{}: {} is not available yet", lines, written(table)),
                   {"available are title, units, mesh, geometry, curve, seam, model, material"});
  }
  for (const Key& key : problem_keys()) {
    const std::string table(key.table), name(key.name);
    if (key.need == Need::later) {
      Draft draft;
      draft.complete(table, name);
      draft.set(table, name, "\"a\"");
      expect_message(message_of<InputError>(draft.text()),
                     fmt::format("p.toml:{}: {} {} is not available yet", draft.line(table, name),
                                 written(*find_table(table)), name),
                     {"available are where, "});
      continue;
    }
    for (const std::string_view choice : split_words(key.later_choices)) {
      Draft draft;
      draft.complete(table, name);
      const std::string text = fmt::format("\"{}\"", choice);
      draft.set(table, name, key.type == ValueType::names ? fmt::format("[{}]", text) : text);
      expect_message(message_of<InputError>(draft.text()),
                     fmt::format("p.toml:{}: {} {} '{}' is not available yet; available are {}",
                                 draft.line(table, name), written(*find_table(table)), name, choice,
                                 split_words(key.choices)[0]),
                     {});
    }
  }
}

TEST(ProblemKeys, EveryRangeHasItsEnds) {
  int ranges = 0;
  for (const Key& key : problem_keys()) {
    const std::string table(key.table), name(key.name);
    const bool integer = key.type == ValueType::integer;
    if (!integer && key.type != ValueType::number) continue;
    const auto accepts = [&](double value) {
      Draft draft;
      draft.complete(table, name);
      draft.set(table, name,
                integer ? fmt::format("{:.0f}", value) : fmt::format("{:.17f}", value));
      try {
        (void)parse(draft.text());
        return true;
      } catch (const InputError& error) {
        const std::string head =
            fmt::format("p.toml:{}: [{}] {} is ", draft.line(table, name), table, name);
        expect_message(error.what(), head, {"it must be " + describe_value(key)});
        return false;
      }
    };
    const double step = integer ? 1 : 1e-9;
    if (std::isfinite(key.range.low)) {
      ++ranges;
      EXPECT_EQ(accepts(key.range.low), !key.range.low_open) << name;
      EXPECT_TRUE(accepts(key.range.low + step)) << name;
      EXPECT_FALSE(accepts(key.range.low - step)) << name;
    }
    if (std::isfinite(key.range.high)) {
      EXPECT_EQ(accepts(key.range.high), !key.range.high_open) << name;
      EXPECT_TRUE(accepts(key.range.high - step)) << name;
      EXPECT_FALSE(accepts(key.range.high + step)) << name;
    }
  }
  EXPECT_EQ(ranges, 22);
}

}  // namespace
}  // namespace limes
