#include "limes/problem/problem.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "limes/core/error.h"
#include "study/problem_draft.h"

namespace limes {
namespace {

TEST(Problem, ReadsEverything) {
  const Problem p = parse(full());
  EXPECT_EQ(p.file, "p.toml");
  EXPECT_EQ(p.title, "Everything");
  EXPECT_EQ(p.units.length, "mm");
  EXPECT_EQ(p.units.force, "N");

  EXPECT_EQ(p.mesh.file, "plate.obj");
  EXPECT_EQ(p.mesh.scheme, "linear");
  EXPECT_EQ(p.mesh.levels, 2);
  EXPECT_EQ(p.mesh.origin.table.line, 7);

  EXPECT_EQ(p.model.kind, ModelKind::plane_strain);
  EXPECT_EQ(p.model.boundary, FieldBoundary::phantom);
  EXPECT_FALSE(p.model.kinks);
  EXPECT_EQ(p.model.quadrature_points, 4);
  EXPECT_EQ(p.model.quadrature_depth, 6);
  EXPECT_EQ(p.model.origin.table.line, 13);

  ASSERT_EQ(p.materials.size(), 2U);
  EXPECT_FALSE(p.materials[0].where);
  EXPECT_EQ(p.materials[0].young, 70e3);
  EXPECT_EQ(p.materials[0].poisson, 0.33);
  EXPECT_EQ(p.materials[0].thickness, 1);
  EXPECT_EQ(p.materials[0].origin.table.line, 20);
  EXPECT_EQ(p.materials[1].where, "group:stiff");
  EXPECT_EQ(p.materials[1].young, 210000);
  EXPECT_EQ(p.materials[1].poisson, 0);
  EXPECT_EQ(p.materials[1].thickness, 2.5);
  EXPECT_EQ(p.materials[1].origin.table.line, 24);
  EXPECT_EQ(p.materials[1].origin.of("where").line, 25);

  ASSERT_TRUE(p.periodic);
  EXPECT_EQ(p.periodic->gradient(0, 0), 1);
  EXPECT_EQ(p.periodic->gradient(0, 1), 0.05);
  EXPECT_EQ(p.periodic->gradient(1, 0), 0.05);
  EXPECT_EQ(p.periodic->gradient(1, 1), 1);
  EXPECT_EQ(p.periodic->origin.table.line, 30);

  ASSERT_EQ(p.supports.size(), 2U);
  EXPECT_EQ(p.supports[0].where, "x == 0");
  EXPECT_EQ(p.supports[0].fix, (std::array{true, false, true, false, false, false}));
  EXPECT_EQ(p.supports[0].origin.table.line, 33);
  EXPECT_EQ(p.supports[0].origin.of("where").line, 34);
  EXPECT_EQ(p.supports[1].fix, (std::array{false, true, false, false, false, false}));

  ASSERT_EQ(p.probes.size(), 2U);
  EXPECT_EQ(p.probes[0].name, "corner");
  EXPECT_EQ(p.probes[0].at, Vec3(1, 2.5, 0));
  EXPECT_EQ(p.probes[1].at, Vec3(1, 2, -3));
}

TEST(Problem, ReadsEveryKindOfLoad) {
  const Problem p = parse(full());
  const Vec3 x(3, 5, 7);
  const auto value = [&](std::size_t load) {
    const auto& v = p.loads[load].value;
    return Vec3(v[0](x), v[1](x), v[2](x));
  };
  ASSERT_EQ(p.loads.size(), 5U);
  EXPECT_EQ(p.loads[0].kind, LoadKind::force_per_area);
  EXPECT_EQ(value(0), Vec3(0, -9.81 * 5, 1.5));
  EXPECT_TRUE(p.loads[0].value[0].is_zero());
  EXPECT_EQ(p.loads[0].origin.table.line, 41);
  EXPECT_EQ(p.loads[0].origin.of("where").line, 42);
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

TEST(Problem, ReadsWhatOnlyShellsHave) {
  const Problem p = parse(full_shell());
  EXPECT_TRUE(p.mesh.exact);
  ASSERT_TRUE(p.geometry);
  EXPECT_EQ(p.geometry->kind, GeometrySettings::Kind::cylinder);
  EXPECT_EQ(p.geometry->point, Vec3(1, 2, 3));
  EXPECT_EQ(p.geometry->axis, Vec3(0, 1, 0));
  EXPECT_EQ(p.geometry->radius, 10);
  EXPECT_EQ(parse(full_graph()).geometry->height(Vec3(2, 3, 0)), 6);
  const Problem parts = parse(full_parts());
  ASSERT_EQ(parts.geometry_of_parts.size(), 3U);
  EXPECT_EQ(parts.geometry_of_parts[0].part, "floor");
  EXPECT_EQ(parts.geometry_of_parts[1].kind, GeometrySettings::Kind::cone);
  EXPECT_EQ(parts.geometry_of_parts[1].angle, 30);
  EXPECT_EQ(parts.geometry_of_parts[2].kind, GeometrySettings::Kind::torus);
  EXPECT_EQ(parts.geometry_of_parts[2].tube_radius, 0.5);
  EXPECT_EQ(parts.geometry->zero(Vec3(2, 3, 5)), 12);
  ASSERT_EQ(parts.curves.size(), 1U);
  EXPECT_EQ(parts.curves[0].surface.zero(Vec3(2, 3, 5)), 4);
  ASSERT_EQ(parts.seams.size(), 1U);
  EXPECT_EQ(parts.seams[0].parts, (std::vector<std::string>{"floor", "wall"}));
  EXPECT_EQ(p.model.kind, ModelKind::mitc4);
  EXPECT_EQ(p.model.shear_factor, 1);
  EXPECT_EQ(p.model.kink_angle, 45);
  EXPECT_TRUE(p.model.assumed_membrane);
  EXPECT_EQ(p.model.drilling, 0.25);
  EXPECT_TRUE(p.junctions);
  EXPECT_FALSE(parts.junctions);
  ASSERT_EQ(p.supports.size(), 2U);
  EXPECT_EQ(p.supports[0].kind, SupportKind::supported);
  EXPECT_TRUE(p.supports[0].hard);
  EXPECT_EQ(p.supports[1].kind, SupportKind::listed);
  EXPECT_EQ(p.supports[1].fix, (std::array{true, false, false, false, true, false}));
  EXPECT_EQ(p.loads.at(0).kind, LoadKind::moment);
}

TEST(Problem, ReadsPoissonsEquationAndAdaptiveRefinement) {
  const Problem p = parse(full_poisson());
  EXPECT_EQ(p.model.kind, ModelKind::poisson);
  EXPECT_EQ(p.materials.at(0).conductivity, 2.5);
  EXPECT_EQ(p.supports.at(0).kind, SupportKind::value);
  EXPECT_EQ(p.supports.at(0).value(Vec3(0, 2, 0)), 3);
  EXPECT_EQ(p.loads.at(0).kind, LoadKind::source);
  EXPECT_EQ(p.loads.at(0).value[0](Vec3(1, 0, 0)), std::sin(1.0));
  EXPECT_EQ(p.loads.at(1).kind, LoadKind::flux);
  EXPECT_EQ(p.loads.at(1).value[0](Vec3(1, 0, 0)), -3);
  ASSERT_TRUE(p.adapt);
  EXPECT_EQ(p.adapt->closure, Closure::conforming);
  EXPECT_EQ(p.adapt->mark, MarkingKind::fraction);
  EXPECT_EQ(p.adapt->share, 0.25);
  EXPECT_EQ(p.adapt->target_error, 0.01);
  EXPECT_EQ(p.adapt->max_dofs, 5000);
  EXPECT_EQ(p.adapt->max_steps, 12);
  EXPECT_EQ(p.adapt->max_seconds, 60);
  EXPECT_EQ(p.adapt->reference_energy, 1.5);
  EXPECT_EQ(p.adapt->reference_levels, 2);
  EXPECT_EQ(p.adapt->origin.table.line, 26);
}

TEST(Problem, RefusesWhatPoissonsEquationAndAdaptiveRefinementDoNotHave) {
  const std::string elastic = Draft().text();
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const auto expect = [](const std::string& text, const std::string& beginning,
                         const std::string& part) {
    expect_message(message_of<InputError>(text), beginning, {part});
  };
  const std::string& scalar = full_poisson();
  expect(changed(scalar, "value = \"1 + y\"", "fix = [\"ux\"]"), "p.toml:14: ", "right is value");
  expect(changed(scalar, "source = \"sin(x)\"", "force = [0, 0]"),
         "p.toml:18: ", "right is source or flux");
  expect(changed(scalar, "conductivity", "young"), "p.toml:12: ", "kind = \"poisson\"");
  expect(changed(scalar, "\"linear\"", "\"catmull-clark\""),
         "p.toml:26: ", "[mesh] scheme = \"linear\"");
  expect(scalar.substr(0, scalar.find("[adapt]")).replace(scalar.find("\"linear\""), 8, "\"loop\""),
         "p.toml:8: ", "[mesh] scheme = \"linear\"");
  expect(elastic + "[[load]]\nwhere = \"all\"\nsource = 1\n", "p.toml:11: ", "use forces");
  expect(elastic + "[[support]]\nwhere = \"all\"\nvalue = 1\n", "p.toml:11: ", "use fix");
  expect(elastic + "[adapt]\n", "p.toml:11: ", "[mesh] scheme = \"linear\"");
  expect(full() + "\n[adapt]\n", "p.toml:", "a periodic cell cannot be refined adaptively yet");
  expect(full_shell() + "\n[adapt]\n", "p.toml:", "\"linear\" or \"kobbelt\"");
  for (const char* needed : {"young", "poisson"}) {
    Draft draft;
    draft.erase("material", needed);
    expect(draft.text(),
           fmt::format("p.toml:{}: [material] {} is missing", draft.line("material", ""), needed),
           "required");
  }
}

TEST(Problem, WhatOnlyShellsHaveIsRefusedInThePlane) {
  const std::string text = Draft().text();
  for (const char* kind : {"sphere", "graph"})
    expect_message(message_of<InputError>(text + fmt::format("[geometry]\nkind = \"{}\"\n", kind)),
                   "p.toml:11: [geometry] ", {"is missing; a ", kind});
  const auto with = [&](const std::string& more) { return message_of<InputError>(text + more); };
  Draft tied;
  tied.set("mesh", "junctions", "\"tied\"");
  expect_message(
      message_of<InputError>(tied.text()),
      fmt::format("p.toml:{}: junctions are tied in shells", tied.line("mesh", "junctions")),
      {"mitc4"});
  expect_message(with("[geometry]\nkind = \"sphere\"\nradius = 1\n"),
                 "p.toml:11: [geometry] is for shells", {"mitc4"});
  expect_message(with("[[support]]\nwhere = \"all\"\nkind = \"clamped\"\n"),
                 "p.toml:13: [[support]] kind is for shells", {"use fix"});
  expect_message(with("[[support]]\nwhere = \"all\"\nfix = [\"rx\"]\n"),
                 "p.toml:13: plane models have no rotations", {"fix ux, uy or both"});
  expect_message(with("[[load]]\nwhere = \"all\"\nmoment = [0, 0, 1]\n"),
                 "p.toml:13: a moment is for shells", {"use forces"});
  expect_message(
      message_of<InputError>(full_shell() + "\n[periodic]\ngradient = [[1, 0.1], [0, 1]]\n"),
      "p.toml:", {"a periodic cell is plane"});
}

TEST(Problem, KeysOfAnotherKindAreRefused) {
  const std::string plane = Draft().text();
  for (const char* key :
       {"shear_factor = 1", "kink_angle = 20", "membrane = \"assumed\"", "drilling = 0.5"}) {
    std::string text = plane;
    text.insert(text.find("kind"), std::string(key) + "\n");
    expect_message(message_of<InputError>(text),
                   "p.toml:", {"is no key of kind = \"plane-stress\""});
  }
  for (const char* key : {"boundary = \"free\"", "kinks = true", "quadrature_points = 3"}) {
    std::string text = full_shell();
    text.insert(text.find("shear_factor"), std::string(key) + "\n");
    expect_message(message_of<InputError>(text), "p.toml:", {"is no key of kind = \"mitc4\""});
  }
  std::string text = full_graph();
  text.insert(text.find("height"), "radius = 1\n");
  expect_message(message_of<InputError>(text), "p.toml:9: [geometry] radius is no key of a graph",
                 {});
}

TEST(Problem, TheSmallestOneHasTheDefaultsOfTheTable) {
  const Problem p = parse(Draft().text());
  const GeometrySettings geometry;
  const AdaptSettings adapt;
  const auto vector = [](const Vec3& v) {
    return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
  };
  // what the structures hold when a key is absent, as the table says it
  const std::map<std::string, std::string> held{
      {"mesh scheme", p.mesh.scheme},
      {"mesh levels", fmt::format("{}", p.mesh.levels)},
      {"mesh placement", p.mesh.exact ? "exact" : "scheme"},
      {"mesh junctions", p.junctions ? "tied" : "refused"},
      {"mesh smooth_start", fmt::format("{}", p.mesh.smooth_start)},
      {"mesh smoothing", fmt::format("{}", p.mesh.smoothing)},
      {"model boundary", p.model.boundary == FieldBoundary::free ? "free" : "phantom"},
      {"model kinks", p.model.kinks ? "true" : "false"},
      {"model quadrature_points", fmt::format("{}", p.model.quadrature_points)},
      {"model quadrature_depth", fmt::format("{}", p.model.quadrature_depth)},
      {"geometry point", vector(geometry.point)},
      {"geometry axis", vector(geometry.axis)},
      {"model shear_factor", p.model.shear_factor == 5.0 / 6.0 ? "5/6" : "?"},
      {"model kink_angle", fmt::format("{}", p.model.kink_angle)},
      {"model drilling", fmt::format("{}", p.model.drilling)},
      {"model membrane", p.model.assumed_membrane ? "assumed" : "displacement"},
      {"support rotation", p.supports.at(0).hard ? "hard" : "soft"},
      {"material thickness", fmt::format("{}", p.materials.at(0).thickness)},
      {"material conductivity", fmt::format("{}", p.materials.at(0).conductivity)},
      {"adapt estimator",
       adapt.estimator == EstimatorKind::zienkiewicz_zhu ? "zienkiewicz-zhu" : "?"},
      {"adapt closure", adapt.closure == Closure::conforming ? "conforming" : "?"},
      {"adapt mark", adapt.mark == MarkingKind::doerfler ? "doerfler" : "?"},
      {"adapt share", fmt::format("{}", adapt.share)},
      {"adapt max_dofs", fmt::format("{}", adapt.max_dofs)},
      {"adapt max_steps", fmt::format("{}", adapt.max_steps)},
      {"adapt reference_levels", fmt::format("{}", adapt.reference_levels)}};
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
                 {"name 'a' is taken", fmt::format("line {}", n + 2)});
}

TEST(Problem, SomethingHoldsTheBody) {
  Draft draft;
  draft.erase("support");
  expect_message(message_of<InputError>(draft.text()), "p.toml: there is no [[support]]", {});
  draft.set("periodic", "gradient", "[[1, 0], [0, 1]]");
  EXPECT_NO_THROW((void)parse(draft.text()));
}

// Between tokens they are errors of TOML, which toml++ 3.3 finds by luck only, see study/toml.h.
TEST(Problem, EveryCharacterMayStandInTextsAndComments) {
  // U+E4, U+3B1, U+2603, U+2F00, U+3042, U+FC46, U+FE0F, U+FEFE, U+10FFFD
  for (const char* character :
       {"\xc3\xa4", "\xce\xb1", "\xe2\x98\x83", "\xe2\xbc\x80", "\xe3\x81\x82", "\xef\xb1\x86",
        "\xef\xb8\x8f", "\xef\xbb\xbe", "\xf4\x8f\xbf\xbd"}) {
    const std::string text =
        fmt::format("# {0}\ntitle = \"\"\"{0} \\\n {0}\"\"\"\n{1}", character, Draft().text());
    EXPECT_EQ(parse(text).title, fmt::format("{0} {0}", character));
    EXPECT_EQ(parse(text, {fmt::format("title={}!", character)}).title,
              std::string(character) + "!");
    for (const char* broken : {"a = 1\n{} \n", "a = 1\n{} = 2\n", "[a]\nb = {}\n", "a = 1\n[{}]\n",
                               "a = 1\nb = [ {} ]\n", "a = 1\nb {} = 2\n", "a = 1\nb = 2 {}\n"})
      expect_message(message_of<InputError>(fmt::format(fmt::runtime(broken), character)),
                     "p.toml:2: ", {});
  }
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
                                                     {"= 3\n", 1},
                                                     {"[?x]\n", 1},
                                                     {"\n[mesh]\n[\xc3\xa4]\nfile = 3\n", 3},
                                                     {"\n[[?", 2},
                                                     {"a = 1\n\xc3\xa4 = 1\n", 2},
                                                     {"a = { ? = 1 }\n", 1}};
  for (const auto& [text, line] : all)
    expect_message(message_of<InputError>(text), fmt::format("p.toml:{}: ", line), {});
}

}  // namespace
}  // namespace limes
