// docs/problem-file.md says what the schema says, and its example is a problem.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "limes/problem/expression_syntax.h"
#include "limes/problem/problem.h"
#include "limes/problem/problem_keys.h"

namespace limes {
namespace {

using namespace problem_file;

std::string manual() {
  std::ifstream file(LIMES_TEST_DATA_DIR "/../../docs/problem-file.md");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string heading(const Table& table) {
  const std::string name(table.name);
  if (table.form == TableForm::single_or_list)
    return fmt::format("### `[{0}]` or `[[{0}]]`: {1}", name, table.help);
  return fmt::format("### `{}`: {}", written(table), table.help);
}

std::string row(const Key& key) {
  // the list of schemes grows without this page
  const bool scheme = key.table == "mesh" && key.name == "scheme";
  const std::string value = scheme ? "a name that `limes schemes` lists" : describe_value(key);
  const std::string initial = key.need == Need::required ? "required"
                              : key.need == Need::one_of ? "one of these"
                              : key.initial.empty()      ? ""
                                                         : fmt::format("`{}`", key.initial);
  return fmt::format("| `{}` | {} | {} | {} |", key.name, value, initial, key.help);
}

/// The chapter of the keys, as the schema has it.
std::string expected_keys() {
  std::string text = "### At the top\n\n";
  const std::string head = "| key | value | default | meaning |\n|---|---|---|---|\n";
  const auto rows = [&](std::string_view table) {
    text += head;
    for (const Key& key : problem_keys())
      if (key.table == table && key.need != Need::later) text += row(key) + "\n";
    text += "\n";
  };
  rows("");
  for (const Table& table : problem_tables()) {
    if (table.need == Need::later) continue;
    text += heading(table) + (table.need == Need::required ? " (required)" : "") + "\n\n";
    rows(table.name);
  }
  text += "### Not available yet\n\n";
  for (const Table& table : problem_tables())
    if (table.need == Need::later) text += fmt::format("- `{}`: {}\n", written(table), table.help);
  for (const Key& key : problem_keys()) {
    if (key.later_choices.empty() && key.need != Need::later) continue;
    const auto choices = split_words(key.later_choices);
    const std::string what =
        choices.empty() ? std::string(key.help) : fmt::format("`{}`", fmt::join(choices, "`, `"));
    text += fmt::format("- `{} {}`: {}\n", written(*find_table(key.table)), key.name, what);
  }
  return text + "\n";
}

TEST(ProblemManual, ItsKeysAreThoseOfTheSchema) {
  const std::string text = manual();
  const std::size_t begin = text.find("### At the top");
  const std::size_t end = text.find("## Shells");
  ASSERT_LT(begin, end);
  ASSERT_NE(end, std::string::npos);
  EXPECT_EQ(text.substr(begin, end - begin), expected_keys())
      << "docs/problem-file.md must read as the second text from '### At the top' to '## "
         "Shells'";
}

TEST(ProblemManual, ItsFunctionsAreThoseOfFormulas) {
  std::vector<std::string_view> names;
  for (const FormulaFunction& f : formula_functions)
    names.push_back(f.name);
  EXPECT_NE(manual().find(fmt::format("| functions | `{}` |\n", fmt::join(names, " "))),
            std::string::npos)
      << fmt::format("{}", fmt::join(names, " "));
}

TEST(ProblemManual, ItsExampleIsAProblem) {
  const std::string text = manual();
  const std::size_t fence = text.find("```toml\n");
  ASSERT_NE(fence, std::string::npos);
  const std::size_t begin = text.find('\n', fence) + 1;
  const Problem p = parse_problem(text.substr(begin, text.find("```", begin) - begin), "doc.toml");
  EXPECT_EQ(p.title, "Plate with a stiff inlay");
  EXPECT_EQ(p.materials.size(), 2U);
  EXPECT_EQ(p.supports.size(), 2U);
  EXPECT_EQ(p.loads.size(), 2U);
  EXPECT_EQ(p.loads[0].value[0](Vec3(100, 25, 0)), 7.5);
  EXPECT_EQ(p.probes.size(), 1U);
}

// Every line of the manual that begins with --set, applied to its example.
TEST(ProblemManual, ItsOverridesFitItsExample) {
  const std::string text = manual();
  const std::size_t fence = text.find("```toml\n");
  const std::size_t begin = text.find('\n', fence) + 1;
  const std::string example = text.substr(begin, text.find("```", begin) - begin);
  int count = 0;
  for (std::size_t at = text.find("## Overrides");
       (at = text.find("\n--set ", at)) != std::string::npos;) {
    at += 7;
    std::string argument = text.substr(at, text.find('\n', at) - at);
    argument = argument[0] == '\'' ? argument.substr(1, argument.find('\'', 1) - 1)
                                   : argument.substr(0, argument.find(' '));
    if (argument.find('=') == std::string::npos) continue;  // a message
    const std::vector<std::string> overrides{argument};
    EXPECT_NO_THROW((void)parse_problem(example, "doc.toml", overrides)) << argument;
    ++count;
  }
  EXPECT_EQ(count, 5);
}

}  // namespace
}  // namespace limes
