#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;

Json info(const std::string& mesh) {
  const Result result = run_limes({"info", mesh, "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out);
}

TEST(Info, CountsACube) {
  const Json json = info(data_file("cube.obj"));
  EXPECT_EQ(json["vertices"], 8);
  EXPECT_EQ(json["edges"], 12);
  EXPECT_EQ(json["faces"], 6);
  EXPECT_EQ(json["components"], 1);
  EXPECT_EQ(json["boundary_loops"], 0);
  EXPECT_EQ(json["euler"], 2);
  EXPECT_EQ(json["valence_interior"], (Json{{"3", 8}}));
  EXPECT_EQ(json["valence_boundary"], Json::object());
  EXPECT_EQ(json["defects"], Json::array());
  EXPECT_EQ(json["tags"]["creases"], 0);
}

TEST(Info, CountsABoundaryAndTags) {
  const TempFolder folder;
  const Json json = info(
      folder.file("m.obj",
                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nt interpolateboundary 1/0/0 1\n"
                  "t crease 2/1/0 0 1 2.5\nt corner 1/1/0 3 4\n"));
  EXPECT_EQ(json["boundary_loops"], 1);
  EXPECT_EQ(json["valence_boundary"], (Json{{"2", 4}}));
  EXPECT_EQ(json["tags"]["creases"], 1);
  EXPECT_EQ(json["tags"]["corners"], 1);
  EXPECT_EQ(json["tags"]["boundary"], "edges-and-corners");
}

TEST(Info, DefectsAreNoError) {
  const TempFolder folder;
  const std::string fan = folder.file(
      "fan.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  const Json defects = info(fan)["defects"];
  ASSERT_GE(defects.size(), 1U);
  EXPECT_EQ(defects[0]["kind"], "non-manifold-edge");
  EXPECT_EQ(defects[0]["faces"], (Json{0, 1, 2}));
  EXPECT_EQ(defects[0]["vertices"], (Json{0, 1}));
  EXPECT_EQ(defects[0]["line"], 6);
  EXPECT_TRUE(defects[0]["message"].is_string());
  const Result text = run_limes({"info", fan});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.out.find("non-manifold-edge"), std::string::npos);
}

TEST(Info, WhatCannotBeParsedIsBadInput) {
  const TempFolder folder;
  expect_failure(run_limes({"info", folder.file("m.obj", "v 1 2\n"), "--json"}), 3, "m.obj:1:");
  expect_failure(run_limes({"info", folder / "none.obj"}), 3, "no such file");
  expect_failure(run_limes({"info", folder / "none"}), 3, "no such file");
  expect_failure(run_limes({"info", folder / ""}), 3, "is a directory");
  expect_failure(run_limes({"info", folder.file("m.xyz", "1 2 3\n")}), 3, "cannot be read");
}

TEST(Info, NamesThatAreNoUtf8StillGiveJson) {
  const TempFolder folder;
  const Json json = info(folder.file("m.obj", "g caf\xe9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(json["groups"].size(), 1U);
}

}  // namespace
}  // namespace limes::test
