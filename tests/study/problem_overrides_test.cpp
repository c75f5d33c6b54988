#include "limes/problem/problem_overrides.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "limes/core/error.h"
#include "study/problem_draft.h"

namespace limes {
namespace {

TEST(Overrides, ChangeAndAddValues) {
  const Problem p =
      parse(full(), {"title=Another", "mesh.levels=5", "mesh.scheme = catmull-clark",
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
  EXPECT_EQ(p.supports[0].origin.of("where").line, 0);
  EXPECT_EQ(p.supports[0].origin.table.line, 33);
  EXPECT_EQ(p.supports[0].origin.of("where").text, "--set support.0.where");
  EXPECT_EQ(place_of_value(p.loads[1]).text, "--set load.1.force_per_length.1") << "one entry";
  EXPECT_EQ(p.supports[1].fix, (std::array{true, false, false, false, false, false}));
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
  EXPECT_EQ(p.periodic->origin.table.line, 0);
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
      {"title.a\nb=1", "--set title.a?b: ", {"there is no list whose entry 'a?b' could be set"}},
      {"material.0.where.0=1", "--set material.0.where.0: ", {"the file has no 'where'"}},
      {"load.0=1", "--set load.0: ", {"[[load]] is a table; name one of its keys"}},
      {"probe.0.at.2=1",
       "--set probe.0.at.2: ",
       {"no entry 2 of the list; they count from 0 to 1"}},
      {"probe.0.at.q=1", "--set probe.0.at.q: ", {"'q' is no number of an entry"}},
      {"a\nb=1", "--set a?b: ", {"a problem has no 'a?b'"}},
      {"title=\xff", "--set ", {"no valid UTF-8"}},
  };
  for (const WrongOverride& w : all)
    expect_message(message_of<UsageError>(full(), {w.text}), w.beginning, w.parts);
  expect_message(message_of<UsageError>(Draft().text(), {"probe.0.at=[1, 2]"}),
                 "--set probe.0.at: the file has no [[probe]]", {});
  expect_message(message_of<UsageError>(Draft().text(), {"material.1.young=1"}),
                 "--set material.1.young: there is no entry 1", {});
}

TEST(Overrides, ValuesThatDoNotFitNameTheOverride) {
  const std::vector<WrongOverride> all{
      {"adapt.mark=0.5", "--set adapt.mark: ", {"is 0.5; it must be one of doerfler"}},
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
      {"model.kind=kirchhoff-love", "--set model.kind: ", {"not available yet"}},
      {"periodic.gradient=[[0, 0], [0, 0]]", "--set periodic.gradient: ", {"determinant"}},
      {"title=5", "--set title: ", {"is 5; it must be text"}},
  };
  for (const WrongOverride& w : all)
    expect_message(message_of<UsageError>(full(), {w.text}), w.beginning, w.parts);
}

TEST(Overrides, WhatTheFileSaysWrongStaysTheFilesMistake) {
  expect_message(message_of<InputError>("mesh = 5\n", {"mesh.levels=3"}), "p.toml:1: ", {"mesh"});
  Draft draft;
  draft.erase("material");
  expect_message(message_of<InputError>("material = [1]\n" + draft.text(), {"material.young=3"}),
                 "p.toml:1: ", {"material is a list of tables"});
}
}  // namespace
}  // namespace limes
