#include "limes/study/problem.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "limes/core/error.h"
#include "limes/study/problem_keys.h"

namespace limes {
namespace {

// clang-format off
constexpr std::string_view full = R"(title = "Everything"

[units]
length = "mm"
force = "N"

[mesh]
file = "plate.obj"
scheme = "linear"
levels = 2
placement = "scheme"

[model]
kind = "plane-strain"
boundary = "phantom"
kinks = false
quadrature_points = 4
quadrature_depth = 6

[[material]]
young = 70e3
poisson = 0.33

[[material]]
where = "group:stiff"
young = 210000
poisson = 0
thickness = 2.5

[periodic]
gradient = [[1, 0.05], [0.05, 1.0]]

[[support]]
where = "x == 0"
fix = ["ux", "uz"]

[[support]]
where = "vertex:3"
fix = ["uy"]

[[load]]
where = "all"
force_per_area = [0, "-9.81 * y", 1.5]

[[load]]
where = "boundary"
force_per_length = ["x", 2]

[[load]]
where = "vertex:0"
force = [1, 2]

[[load]]
where = "part:left"
force_per_volume = [0, 0, -1]

[[load]]
where = "not x == 0"
pressure = "2 * z"

[[probe]]
name = "corner"
at = [1, 2.5]

[[probe]]
name = "top"
at = [1, 2, -3]
)";
// clang-format on

Problem parse(std::string_view text, const std::vector<std::string>& overrides = {}) {
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

void expect_message(const std::string& message, std::string_view beginning,
                    const std::vector<std::string>& parts) {
  EXPECT_EQ(message.substr(0, beginning.size()), beginning);
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks " << part;
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

TEST(Problem, ReadsEverything) {
  const Problem p = parse(full);
  EXPECT_EQ(p.file, "p.toml");
  EXPECT_EQ(p.title, "Everything");
  EXPECT_EQ(p.units.length, "mm");
  EXPECT_EQ(p.units.force, "N");

  EXPECT_EQ(p.mesh.file, "plate.obj");
  EXPECT_EQ(p.mesh.scheme, "linear");
  EXPECT_EQ(p.mesh.levels, 2);
  EXPECT_EQ(p.mesh.line, 7);

  EXPECT_EQ(p.model.kind, ModelKind::plane_strain);
  EXPECT_EQ(p.model.boundary, FieldBoundary::phantom);
  EXPECT_FALSE(p.model.kinks);
  EXPECT_EQ(p.model.quadrature_points, 4);
  EXPECT_EQ(p.model.quadrature_depth, 6);
  EXPECT_EQ(p.model.line, 13);

  ASSERT_EQ(p.materials.size(), 2U);
  EXPECT_FALSE(p.materials[0].where);
  EXPECT_EQ(p.materials[0].young, 70e3);
  EXPECT_EQ(p.materials[0].poisson, 0.33);
  EXPECT_EQ(p.materials[0].thickness, 1);
  EXPECT_EQ(p.materials[0].line, 20);
  EXPECT_EQ(p.materials[1].where, "group:stiff");
  EXPECT_EQ(p.materials[1].young, 210000);
  EXPECT_EQ(p.materials[1].poisson, 0);
  EXPECT_EQ(p.materials[1].thickness, 2.5);
  EXPECT_EQ(p.materials[1].line, 24);
  EXPECT_EQ(p.materials[1].where_line, 25);

  ASSERT_TRUE(p.periodic);
  EXPECT_EQ(p.periodic->gradient(0, 0), 1);
  EXPECT_EQ(p.periodic->gradient(0, 1), 0.05);
  EXPECT_EQ(p.periodic->gradient(1, 0), 0.05);
  EXPECT_EQ(p.periodic->gradient(1, 1), 1);
  EXPECT_EQ(p.periodic->line, 30);

  ASSERT_EQ(p.supports.size(), 2U);
  EXPECT_EQ(p.supports[0].where, "x == 0");
  EXPECT_EQ(p.supports[0].fix, (std::array{true, false, true}));
  EXPECT_EQ(p.supports[0].line, 33);
  EXPECT_EQ(p.supports[0].where_line, 34);
  EXPECT_EQ(p.supports[1].fix, (std::array{false, true, false}));

  ASSERT_EQ(p.probes.size(), 2U);
  EXPECT_EQ(p.probes[0].name, "corner");
  EXPECT_EQ(p.probes[0].at, Vec3(1, 2.5, 0));
  EXPECT_EQ(p.probes[1].at, Vec3(1, 2, -3));
}

TEST(Problem, ReadsEveryKindOfLoad) {
  const Problem p = parse(full);
  const Vec3 x(3, 5, 7);
  const auto value = [&](std::size_t load) {
    const auto& v = p.loads[load].value;
    return Vec3(v[0](x), v[1](x), v[2](x));
  };
  ASSERT_EQ(p.loads.size(), 5U);
  EXPECT_EQ(p.loads[0].kind, LoadKind::force_per_area);
  EXPECT_EQ(value(0), Vec3(0, -9.81 * 5, 1.5));
  EXPECT_TRUE(p.loads[0].value[0].is_zero());
  EXPECT_EQ(p.loads[0].line, 41);
  EXPECT_EQ(p.loads[0].where_line, 42);
  EXPECT_EQ(p.loads[1].kind, LoadKind::force_per_length);
  EXPECT_EQ(value(1), Vec3(3, 2, 0));
  EXPECT_TRUE(p.loads[1].value[2].is_zero());
  EXPECT_EQ(p.loads[2].kind, LoadKind::force);
  EXPECT_EQ(value(2), Vec3(1, 2, 0));
  EXPECT_EQ(p.loads[3].kind, LoadKind::force_per_volume);
  EXPECT_EQ(value(3), Vec3(0, 0, -1));
  EXPECT_EQ(p.loads[4].kind, LoadKind::pressure);
  EXPECT_EQ(value(4), Vec3(14, 0, 0));
}

TEST(Problem, TheSmallestOneHasTheDefaultsOfTheTable) {
  const Problem p = parse(Draft().text());
  // what the structures hold when a key is absent, as the table says it
  const std::map<std::string, std::string> held{
      {"mesh scheme", p.mesh.scheme},
      {"mesh levels", fmt::format("{}", p.mesh.levels)},
      {"mesh placement", "scheme"},
      {"model boundary", p.model.boundary == FieldBoundary::free ? "free" : "phantom"},
      {"model kinks", p.model.kinks ? "true" : "false"},
      {"model quadrature_points", fmt::format("{}", p.model.quadrature_points)},
      {"model quadrature_depth", fmt::format("{}", p.model.quadrature_depth)},
      {"material thickness", fmt::format("{}", p.materials.at(0).thickness)}};
  for (const Key& key : problem_keys()) {
    const std::string name = std::string(key.table) + " " + std::string(key.name);
    if (held.count(name))
      EXPECT_EQ(held.at(name), key.initial) << name;
    else
      EXPECT_EQ(key.initial, "") << name << " is not compared with the structures";
  }
  EXPECT_EQ(p.title, "");
  EXPECT_FALSE(p.periodic);
  EXPECT_TRUE(p.loads.empty());
  EXPECT_TRUE(p.probes.empty());
}

// Properties of every key of the schema.

TEST(ProblemKeys, EveryAvailableKeyIsInTheFullExample) {
  std::set<std::string> seen;
  std::istringstream lines{std::string(full)};
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
    EXPECT_FALSE(describe_value(key).empty()) << key.name;
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
    std::string misspelt = name;
    misspelt.insert(misspelt.size() / 2, "q");
    draft.set(table, misspelt, "1");
    expect_message(message_of<InputError>(draft.text()),
                   fmt::format("p.toml:{}: ", draft.line(table, misspelt)),
                   {"has no key '" + misspelt + "'; ", "'" + name + "'"});
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
    const std::string draft = Draft().text() + "[" + misspelt + "]\n";
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
                   {"available are title, units, mesh, model, material"});
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
      draft.set(table, name, key.type == ValueType::names ? "[" + text + "]" : text);
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
  EXPECT_EQ(ranges, 6);
}

// Single messages.

struct Wrong {
  std::string table, key, value;
  std::vector<std::string> parts;
};

TEST(Problem, SaysWhatIsWrongWithAValue) {
  const std::vector<Wrong> all{
      {"mesh", "levels", "2.0", {"is 2", "must be an integer from 0 to 12"}},
      {"mesh", "levels", "99999999999", {"is 99999999999", "an integer from 0 to 12"}},
      {"mesh", "levels", "\"2\"", {"is '2'", "an integer"}},
      {"mesh", "file", "\"\"", {"is empty"}},
      {"mesh", "file", "\"  \"", {"is empty"}},
      {"mesh", "scheme", "\"catmul-clark\"", {"'catmul-clark'; did you mean 'catmull-clark'?"}},
      {"mesh", "scheme", "\"what\"", {"known are catmull-clark, "}},
      {"model", "kind", "\"plane stress\"", {"did you mean 'plane-stress'?"}},
      {"model", "kind", "\"Plane-Strain\"", {"did you mean 'plane-strain'?"}},
      {"model", "kinks", "1", {"is 1; it must be true or false"}},
      {"material", "young", "inf", {"is inf; it must be finite"}},
      {"material", "young", "nan", {"must be finite"}},
      {"material", "poisson", "0.5", {"is 0.5", "between -1 and 0.5, both excluded"}},
      {"material", "poisson", "true", {"is true; it must be a number"}},
      {"material", "where", "\"grup:a\"", {"did you mean 'group'?"}},
      {"support", "fix", "[\"ux\", \"ux\"]", {"has 'ux' twice"}},
      {"support", "fix", "[\"u\"]", {"is 'u'", "ux"}},
      {"support", "fix", "\"ux\"", {"is 'ux'; it must be a list of ux, uy, uz"}},
      {"support", "where", "\"\"", {"an empty text selects nothing"}},
      {"support", "where", "\"x = 0\"", {"character 3: '=' assigns nothing here; == compares"}},
      {"support", "where", "\"bondary\"", {"did you mean 'boundary'?"}},
      {"support", "where", "\"vertex:-1\"", {"'-1' is no vertex"}},
      {"support", "where", "\"vertex:1.5\"", {"'1.5' is no vertex"}},
      {"support", "where", "\"group: \"", {"lacks a name"}},
      {"load", "force", "[1]", {"a list of 1", "two or three numbers or formulas"}},
      {"load", "force", "[1, 2, 3, 4]", {"a list of 4"}},
      {"load", "force", "[1, \"2 * q\"]", {"unknown name 'q'; known are x, y, z"}},
      {"load", "force", "[1, true]", {"is true"}},
      {"load", "force", "[1, inf]", {"must be finite"}},
      {"load", "pressure", "[1, 2]", {"a list of 2; it must be a number or a formula"}},
      {"load", "pressure", "\"1 +\"", {"character 4: the formula ends"}},
      {"probe", "at", "[1, \"x\"]", {"is 'x'; it must be two or three numbers"}},
      {"periodic", "gradient", "[[1, 0, 0], [0, 1, 0]]", {"a list of 3; it must be 2 x 2 numbers"}},
      {"periodic", "gradient", "[1, 0, 0, 1]", {"a list of 4; it must be 2 x 2 numbers"}},
      {"periodic", "gradient", "[[1, 2], [1, 2]]", {"has the determinant 0"}},
      {"periodic", "gradient", "[[0, 1], [1, 0]]", {"has the determinant -1"}},
      {"units", "length", "1", {"is 1; it must be text"}},
  };
  for (const Wrong& w : all) {
    Draft draft;
    draft.complete(w.table, w.key);
    draft.set(w.table, w.key, w.value);
    expect_message(message_of<InputError>(draft.text()),
                   fmt::format("p.toml:{}: {} {}", draft.line(w.table, w.key),
                               written(*find_table(w.table)), w.key),
                   w.parts);
  }
}

TEST(Problem, PointsAtTheEntryInAListOverSeveralLines) {
  const std::string text =
      Draft().text() + "[[load]]\nwhere = \"all\"\nforce = [\n  1,\n  \"zz\",\n]\n";
  const auto lines = std::count(text.begin(), text.end(), '\n');
  expect_message(message_of<InputError>(text), fmt::format("p.toml:{}: ", lines - 1), {"'zz'"});
}

TEST(Problem, ALoadHasExactlyOneQuantity) {
  Draft none;
  none.set("load", "where", "\"all\"");
  expect_message(message_of<InputError>(none.text()),
                 fmt::format("p.toml:{}: [[load]] has none of force, force_per_length, ",
                             none.line("load", "")),
                 {"exactly one is right"});
  Draft two = none;
  two.set("load", "force", "[1, 2]");
  two.set("load", "pressure", "1");
  expect_message(
      message_of<InputError>(two.text()),
      fmt::format("p.toml:{}: [[load]] has both force and pressure", two.line("load", "pressure")),
      {});
}

TEST(Problem, TablesHaveTheirForm) {
  const std::string base = Draft().text();
  const auto line = std::count(base.begin(), base.end(), '\n') + 1;
  const auto expect = [&](const std::string& extra, const std::string& words) {
    expect_message(message_of<InputError>(base + extra), fmt::format("p.toml:{}: {}", line, words),
                   {});
  };
  expect("[load]\nwhere=\"all\"\nforce=[1, 2]\n", "there may be several [[load]]; write [[load]]");
  expect("[[units]]\nlength=\"m\"\n", "units is no table; write [units]");
  expect("[[material]]\n", "Error while parsing");  // TOML's own: [material] stands above
  const auto top = [&](const std::string& first, const std::string& words) {
    expect_message(message_of<InputError>(first + "\n" + base), "p.toml:1: " + words, {});
  };
  top("load = []", "load is an empty list");
  top("load = [1]", "load is a list of tables; write [[load]]");
  top("probe = 5", "probe is no table; write [probe]");
  top("mehs = 5", "a problem has no key 'mehs'; did you mean 'mesh'?");
}

TEST(Problem, MaterialMayBeOneOrSeveral) {
  Draft draft;
  EXPECT_EQ(parse(draft.text()).materials.size(), 1U);
  draft.erase("material");
  const std::string rest = draft.text();
  const std::string a = "[[material]]\nyoung = 1\npoisson = 0\n";
  EXPECT_EQ(parse(rest + a).materials.size(), 1U);
  EXPECT_EQ(parse(rest + a + a + "where = \"group:b\"\n").materials.size(), 2U);
  const auto lines = std::count(rest.begin(), rest.end(), '\n');
  expect_message(message_of<InputError>(rest + a + a), fmt::format("p.toml:{}: ", lines + 4),
                 {"has no where", fmt::format("line {}", lines + 1)});
}

TEST(Problem, ProbeNamesDiffer) {
  const std::string base = Draft().text();
  const auto n = std::count(base.begin(), base.end(), '\n');
  const std::string probe = "[[probe]]\nname = \"a\"\nat = [0, 0]\n";
  expect_message(message_of<InputError>(base + probe + probe), fmt::format("p.toml:{}: ", n + 5),
                 {"name 'a' is taken", fmt::format("line {}", n + 1)});
}

TEST(Problem, SomethingHoldsTheBody) {
  Draft draft;
  draft.erase("support");
  expect_message(message_of<InputError>(draft.text()), "p.toml: there is no [[support]]", {});
  draft.set("periodic", "gradient", "[[1, 0], [0, 1]]");
  EXPECT_NO_THROW((void)parse(draft.text()));
}

TEST(Problem, TomlErrorsHaveTheirLine) {
  const std::vector<std::pair<std::string, int>> all{{"title = \"a\"\ntitle = \"b\"\n", 2},
                                                     {"[mesh]\n\n[mesh]\n", 3},
                                                     {"title = \n", 1},
                                                     {"title = \"a", 1},
                                                     {"[[load]]\n[load]\n", 2},
                                                     {"\n\nx = 1e999\n", 3},
                                                     {"a = 99999999999999999999\n", 1},
                                                     {"title = 'a'\nb = '\xff'\n", 2},
                                                     {"title = \"a\\qb\"\n", 1},
                                                     {"\"a\\nb\" = 1\n\"a\\nb\" = 1\n", 2},
                                                     {"= 3\n", 1}};
  for (const auto& [text, line] : all)
    expect_message(message_of<InputError>(text), fmt::format("p.toml:{}: ", line), {});
}

// Overrides.

TEST(Overrides, ChangeAndAddValues) {
  const Problem p =
      parse(full, {"title=Another", "mesh.levels=5", "mesh.scheme = catmull-clark",
                   "units.length=m", "material.1.young=2", "periodic.gradient=[[2,0],[0,3]]",
                   "probe.0.at.1=-7", "periodic.gradient.1.0=0.5", "support.0.where=x == 1",
                   "load.0.force_per_area=[0,0,-1]", "load.4.pressure=3 * x", "model.kinks=true",
                   "material.0.thickness=9", "support.1.fix=[\"ux\"]",
                   "load.1.force_per_length.1=y", "mesh.levels=6"});
  EXPECT_EQ(p.title, "Another");
  EXPECT_EQ(p.mesh.levels, 6) << "the last one holds";
  EXPECT_EQ(p.mesh.scheme, "catmull-clark");
  EXPECT_EQ(p.units.length, "m");
  EXPECT_EQ(p.materials[1].young, 2);
  EXPECT_EQ(p.materials[0].thickness, 9) << "a key the file does not have";
  EXPECT_EQ(p.periodic->gradient(0, 0), 2);
  EXPECT_EQ(p.periodic->gradient(1, 0), 0.5);
  EXPECT_EQ(p.probes[0].at, Vec3(1, -7, 0));
  EXPECT_EQ(p.supports[0].where, "x == 1");
  EXPECT_EQ(p.supports[0].where_line, 0);
  EXPECT_EQ(p.supports[0].line, 33);
  EXPECT_EQ(p.supports[1].fix, (std::array{true, false, false}));
  EXPECT_EQ(p.loads[0].value[2](Vec3::Zero()), -1);
  EXPECT_EQ(p.loads[4].value[0](Vec3(2, 0, 0)), 6);
  EXPECT_EQ(p.loads[1].value[1](Vec3(0, 4, 0)), 4);
  EXPECT_TRUE(p.model.kinks);
}

TEST(Overrides, LeaveOutTheNumberOfTheOnlyTable) {
  const std::string single = Draft().text();
  EXPECT_EQ(parse(single, {"material.young=2"}).materials[0].young, 2);
  EXPECT_EQ(parse(single, {"material.0.young=2"}).materials[0].young, 2);
  EXPECT_EQ(parse(single, {"support.where=y == 0"}).supports[0].where, "y == 0");
  Draft draft;
  draft.erase("material");
  EXPECT_EQ(parse(draft.text(), {"material.young=2", "material.poisson=0"}).materials[0].young, 2)
      << "the whole table from overrides";
  EXPECT_EQ(parse(draft.text() + "[[material]]\nyoung=1\npoisson=0\n", {"material.young=3"})
                .materials[0]
                .young,
            3);
}

TEST(Overrides, AddATable) {
  const Problem p = parse(Draft().text(), {"periodic.gradient=[[1, 0.1], [0, 1]]"});
  ASSERT_TRUE(p.periodic);
  EXPECT_EQ(p.periodic->gradient(0, 1), 0.1);
  EXPECT_EQ(p.periodic->line, 0);
}

TEST(Overrides, BareStringsMayHoldAnything) {
  const std::string base = Draft().text();
  EXPECT_EQ(parse(base, {"title=a \"b\" \\ = # c"}).title, "a \"b\" \\ = # c");
  EXPECT_EQ(parse(base, {"title=\"quoted\""}).title, "quoted");
  EXPECT_EQ(parse(base, {"title=1 2"}).title, "1 2");
  EXPECT_EQ(parse(base, {"title=a\nfile = 1"}).title, "a\nfile = 1") << "no second line of TOML";
  EXPECT_EQ(parse(base, {"mesh.file=\xc3\xa4.obj"}).mesh.file, "\xc3\xa4.obj");
}

struct WrongOverride {
  std::string text;
  std::string beginning;
  std::vector<std::string> parts;
};

TEST(Overrides, PathsThatDoNotExistAreWrongUsage) {
  const std::vector<WrongOverride> all{
      {"mesh.levels", "--set 'mesh.levels': ", {"there is no '='"}},
      {"=3", "--set : ", {"a problem has no ''"}},
      {"mehs.levels=3", "--set mehs.levels: ", {"no 'mehs'; did you mean 'mesh'?"}},
      {"mesh.level=3", "--set mesh.level: ", {"[mesh] has no key 'level'; did you mean 'levels'?"}},
      {"levels=3", "--set levels: ", {"a problem has no 'levels'"}},
      {"mesh=3", "--set mesh: ", {"[mesh] is a table; name one of its keys file, scheme"}},
      {"mesh.=3", "--set mesh.: ", {"[mesh] has no key ''"}},
      {"mesh.levels.0=3", "--set mesh.levels.0: ", {"there is no list"}},
      {"mesh.0.levels=3", "--set mesh.0.levels: ", {"[mesh] has no key '0'"}},
      {"title.0=3", "--set title.0: ", {"there is no list"}},
      {"load.5.force=[1, 2]",
       "--set load.5.force: ",
       {"no entry 5 of [[load]]; they count from 0 to 4"}},
      {"load.-1.force=[1, 2]", "--set load.-1.force: ", {"no entry -1"}},
      {"load.force=[1, 2]",
       "--set load.force: ",
       {"there are 5 tables [[load]]; right is load.0 to load.4"}},
      {"load.0.forse=[1, 2]", "--set load.0.forse: ", {"did you mean 'force'?"}},
      {"load.0.force.0=1", "--set load.0.force.0: ", {"the file has no 'force'"}},
      {"units.length.0=1", "--set units.length.0: ", {"there is no list"}},
      {"material.0.where.0=1", "--set material.0.where.0: ", {"the file has no 'where'"}},
      {"load.0=1", "--set load.0: ", {"[[load]] is a table; name one of its keys"}},
      {"load.0.moment=[1, 2]", "--set load.0.moment: ", {"not available yet"}},
      {"probe.0.at.2=1",
       "--set probe.0.at.2: ",
       {"no entry 2 of the list; they count from 0 to 1"}},
      {"probe.0.at.q=1", "--set probe.0.at.q: ", {"'q' is no number of an entry"}},
      {"adapt.mark=0.5", "--set adapt.mark: ", {"[adapt] is not available yet"}},
      {"geometry.kind=3", "--set geometry.kind: ", {"[geometry] is not available yet"}},
      {"a\nb=1", "--set a?b: ", {"a problem has no 'a?b'"}},
      {"title=\xff", "--set ", {"no valid UTF-8"}},
  };
  for (const WrongOverride& w : all)
    expect_message(message_of<UsageError>(full, {w.text}), w.beginning, w.parts);
  expect_message(message_of<UsageError>(Draft().text(), {"probe.0.at=[1, 2]"}),
                 "--set probe.0.at: the file has no [[probe]]", {});
  expect_message(message_of<UsageError>(Draft().text(), {"material.1.young=1"}),
                 "--set material.1.young: there is no entry 1", {});
}

TEST(Overrides, ValuesThatDoNotFitNameTheOverride) {
  const std::vector<WrongOverride> all{
      {"mesh.levels=99",
       "--set mesh.levels: ",
       {"[mesh] levels is 99; it must be an integer from 0 to 12"}},
      {"mesh.levels=two", "--set mesh.levels: ", {"is 'two'"}},
      {"mesh.levels=", "--set mesh.levels: ", {"is ''"}},
      {"mesh.scheme=catmul-clark", "--set mesh.scheme: ", {"did you mean 'catmull-clark'?"}},
      {"material.0.young=-1", "--set material.0.young: ", {"is -1; it must be a number > 0"}},
      {"load.0.force_per_area=[1, q]", "--set load.0.force_per_area: ", {"is '[1, q]'"}},
      {"load.0.force_per_area=[1, \"q\"]", "--set load.0.force_per_area: ", {"unknown name 'q'"}},
      {"load.0.force_per_area.1=q", "--set load.0.force_per_area.1: ", {"unknown name 'q'"}},
      {"load.0.pressure=1", "--set load.0.pressure: ", {"has both force_per_area and pressure"}},
      {"support.0.where=bondary", "--set support.0.where: ", {"did you mean 'boundary'?"}},
      {"probe.1.name=corner", "--set probe.1.name: ", {"'corner' is taken"}},
      {"model.kind=mitc4", "--set model.kind: ", {"not available yet"}},
      {"periodic.gradient=[[0, 0], [0, 0]]", "--set periodic.gradient: ", {"determinant"}},
      {"title=5", "--set title: ", {"is 5; it must be text"}},
  };
  for (const WrongOverride& w : all)
    expect_message(message_of<UsageError>(full, {w.text}), w.beginning, w.parts);
}

TEST(Overrides, WhatTheFileSaysWrongStaysTheFilesMistake) {
  expect_message(message_of<InputError>("mesh = 5\n", {"mesh.levels=3"}), "p.toml:1: ", {"mesh"});
  Draft draft;
  draft.erase("material");
  expect_message(message_of<InputError>("material = [1]\n" + draft.text(), {"material.young=3"}),
                 "p.toml:1: ", {"material is a list of tables"});
}

// Files.

class ProblemFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              fmt::format("limes_problem_{}", testing::UnitTest::GetInstance()->random_seed() +
                                                  static_cast<long>(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string message(const std::filesystem::path& file) {
    try {
      (void)read_problem(file);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << file << " was read";
    return {};
  }
  std::filesystem::path folder_;
};

TEST_F(ProblemFile, IsReadFromDisk) {
  const auto file = folder_ / "a.toml";
  std::ofstream(file) << full;
  EXPECT_EQ(read_problem(file).title, "Everything");
  EXPECT_EQ(read_problem(file).file, file);
  const std::vector<std::string> overrides{"mesh.levels=3"};
  EXPECT_EQ(read_problem(file, overrides).mesh.levels, 3);
}

TEST_F(ProblemFile, MayHaveWindowsLinesAndAByteOrderMark) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : Draft().text())
    text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parse(text).mesh.file, "m.obj");
}

TEST_F(ProblemFile, MustBeAFileOfReasonableSize) {
  EXPECT_NE(message(folder_ / "none.toml").find("none.toml: no such file"), std::string::npos);
  EXPECT_NE(message(folder_).find("is a directory"), std::string::npos);
  const auto large = folder_ / "large.toml";
  std::ofstream(large) << "a";
  std::filesystem::resize_file(large, (16U << 20U) + 1);
  EXPECT_NE(message(large).find("larger than 16 MiB"), std::string::npos);
  EXPECT_NE(message("/dev/null").find("no regular file"), std::string::npos);
}

}  // namespace
}  // namespace limes
