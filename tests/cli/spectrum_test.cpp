#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "limes/subdiv/schemes.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;

TEST(SpectrumCommand, PrintsJsonOnly) {
  const Result result =
      run_limes({"spectrum", "--scheme", "catmull-clark", "--valence", "3..5", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json results = Json::parse(result.out)["results"];
  ASSERT_EQ(results.size(), 3U);
  const Json& five = results[2];
  EXPECT_EQ(five["valence"], 5);
  EXPECT_EQ(five["eigenvalues"][0]["block"], 0);
  EXPECT_NEAR(five["eigenvalues"][0]["value"], 1, 1e-12);
  EXPECT_NEAR(five["subdominant"], 0.549988, 1e-6);  // [halstead_1993]
  EXPECT_EQ(five["c1"], true);
  EXPECT_GT(five["curvature_ratio"], 1);
  EXPECT_NEAR(five["masks"][0]["limit"], 0.5, 1e-12);  // n / (n + 5)
}

TEST(SpectrumCommand, KnowsEveryScheme) {
  for (const Scheme& s : all_schemes()) {
    const Result result =
        run_limes({"spectrum", "--scheme", std::string(s.name), "--valence", "6"});
    EXPECT_EQ(result.exit_code, 0) << s.name << result.err;
    EXPECT_NE(result.out.find("SUBDOMINANT"), std::string::npos);
  }
}

/// [velho_quasi48], Figure 5: polygons of 3, 4, 5 sides get centres of valence 6, 8, 10.
TEST(SpectrumCommand, SaysWhenPatternsRepeat) {
  const Result result =
      run_limes({"spectrum", "--scheme", "quasi-four-eight", "--valence", "3..5", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json patterns = Json::parse(result.out)["patterns"];
  ASSERT_EQ(patterns["around"].size(), 6U);
  for (const Json& p : patterns["around"]) {
    EXPECT_EQ(p["valence"], 2 * p["control_valence"].get<int>());
    EXPECT_EQ(p["period"], 1);
    EXPECT_EQ(p["regular"], true);
    EXPECT_LT(p["repeats_after"].get<int>(), 10);
  }
  EXPECT_EQ(patterns["around"][0]["mesh"], "polygon");
  EXPECT_EQ(patterns["around"][1]["mesh"], "star");
  const Result text = run_limes({"spectrum", "--scheme", "quasi-four-eight", "--valence", "4..5"});
  EXPECT_NE(text.out.find("REPEATS AFTER PASS"), std::string::npos);
  for (const char* scheme : {"loop", "four-eight"})
    EXPECT_FALSE(
        Json::parse(run_limes({"spectrum", "--scheme", scheme, "--valence", "6", "--json"}).out)
            .contains("patterns"));
}

TEST(SpectrumCommand, DrawsCharacteristicMaps) {
  const TempFolder folder;
  const Result result =
      run_limes({"spectrum", "--scheme", "loop", "--valence", "3..6", "-o", folder / "maps.svg"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string svg = read_file(folder / "maps.svg");
  EXPECT_NE(svg.find("valence 6"), std::string::npos);
}

TEST(SpectrumCommand, RefusesWrongUsage) {
  const auto run = [](const char* scheme, const char* valence,
                      const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"spectrum", "--scheme", scheme, "--valence", valence};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_limes(arguments);
  };
  expect_failure(run("lop", "3"), 2, "there is no scheme 'lop'");
  for (const char* valence : {"2", "x", "5..3", "3..", "..4", "1..900", "-3", ""})
    expect_failure(run("loop", valence), 2, "--valence");
  expect_failure(run("loop", "3", {"--tension", "1"}), 2, "--tension: loop has no such option");
  expect_failure(run("loop", "3", {"--weights", "quarters"}), 2, "known are standard, warren");
  expect_failure(run("sqrt3", "3", {"--weights", "warren"}), 2,
                 "--weights: sqrt3 has no such option");
  expect_failure(run("loop", "3", {"-o", "maps.pdf"}), 2, "--output");
  expect_failure(run("loop", "3", {"-o", "/nonexistent/maps.svg"}), 5, "/nonexistent");
}

TEST(SchemesCommand, PrintsTheRulesOfAScheme) {
  const Result text = run_limes({"schemes", "catmull-clark", "--valence", "5"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  for (const char* part : {"1/64 of", "6  36  6", "valence 5: vertex point", "13/20", "LIMIT ROWS"})
    EXPECT_NE(text.out.find(part), std::string::npos) << part;
  const Result result = run_limes({"schemes", "catmull-clark", "--valence", "5", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["regular_valence"], 4);
  EXPECT_EQ(json["masks"][0]["weights"].size(), 25U);
  ASSERT_EQ(json["limits"].size(), 2U);
  // [halstead_1993]: n^2, 4 and 1 over n (n + 5).
  const Json& five = json["limits"][1]["weights"];
  EXPECT_EQ(five[0]["fraction"], "1/2");
  EXPECT_EQ(five[1]["fraction"], "2/25");
  EXPECT_EQ(five[6]["fraction"], "1/50");
}

TEST(SchemesCommand, KnowsEveryScheme) {
  for (const Scheme& s : all_schemes()) {
    const Result result = run_limes({"schemes", std::string(s.name), "--valence", "6", "--json"});
    ASSERT_EQ(result.exit_code, 0) << s.name << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_FALSE(json["rules"].empty()) << s.name;
    EXPECT_FALSE(json["masks"].empty()) << s.name;
    EXPECT_EQ(run_limes({"schemes", std::string(s.name)}).exit_code, 0) << s.name;
  }
  const Json curve = Json::parse(run_limes({"schemes", "chaikin", "--json"}).out);
  EXPECT_EQ(curve["mask"], Json::parse("[0.25, 0.75, 0.75, 0.25]"));
}

std::string symbol(const std::vector<std::string>& scheme) {
  std::vector<std::string> arguments{"schemes", "--json"};
  arguments.insert(arguments.end(), scheme.begin(), scheme.end());
  const Result result = run_limes(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out)["symbol"];
}

/// (1 + z)^(degree + 1) / 2^degree [lane_riesenfeld_1980], its lowest power z^first.
std::string lane_riesenfeld_symbol(int degree, int first) {
  std::string terms;
  std::int64_t binomial = 1;
  for (int k = 0; k <= degree + 1; ++k) {
    const int power = first + k;
    std::string term = power == 0 ? "" : power == 1 ? "z" : "z^" + std::to_string(power);
    if (binomial != 1 || term.empty())
      term = std::to_string(binomial) + (term.empty() ? "" : " ") + term;
    terms += (k == 0 ? "" : " + ") + term;
    binomial = binomial * (degree + 1 - k) / (k + 1);
  }
  return "(" + terms + ") / " + std::to_string(std::int64_t{1} << degree);
}

TEST(SchemesCommand, PrintsTheSymbolsOfCurveSchemes) {
  EXPECT_EQ(symbol({"chaikin"}), "(z^-1 + 3 + 3 z + z^2) / 4");
  EXPECT_EQ(symbol({"lane-riesenfeld:3"}), "(z^-2 + 4 z^-1 + 6 + 4 z + z^2) / 8");
  for (const int degree : {1, 2, 4, 7, 16, 20})
    EXPECT_EQ(symbol({"lane-riesenfeld:" + std::to_string(degree)}),
              lane_riesenfeld_symbol(degree, -((degree + 1) / 2)));
  // [dyn_1987]: omega = 1/16, and two others.
  EXPECT_EQ(symbol({"four-point"}), "(-z^-3 + 9 z^-1 + 16 + 9 z - z^3) / 16");
  EXPECT_EQ(symbol({"four-point", "--tension", "0"}), "(z^-1 + 2 + z) / 2");
  EXPECT_EQ(symbol({"four-point", "--tension", "0.8"}), "(-z^-3 + 11 z^-1 + 20 + 11 z - z^3) / 20");
  const Result text = run_limes({"schemes", "chaikin"});
  EXPECT_NE(text.out.find("\nsymbol: (z^-1 + 3 + 3 z + z^2) / 4\n"), std::string::npos) << text.out;
}

TEST(SchemesCommand, RefusesWrongUsage) {
  expect_failure(run_limes({"schemes", "lop"}), 2, "there is no scheme 'lop'");
  expect_failure(run_limes({"schemes", "--valence", "5"}), 2, "--valence needs a scheme");
  expect_failure(run_limes({"schemes", "--tension", "1"}), 2, "--tension needs a scheme");
  expect_failure(run_limes({"schemes", "loop", "--valence", "2"}), 2, "3 to 100 are");
  expect_failure(run_limes({"schemes", "four-eight", "--valence", "5"}), 2, "even ones");
  expect_failure(run_limes({"schemes", "loop", "--tension", "1"}), 2, "loop has no such option");
  expect_failure(run_limes({"schemes", "chaikin", "--valence", "4"}), 2, "no such option");
  expect_failure(run_limes({"schemes", "chaikin", "--tension", "1"}), 2, "no such option");
}

TEST(RefineCommand, RefinesCurves) {
  const TempFolder folder;
  const Result result = run_limes({"refine", data_file("polygon.obj"), "-o", folder / "c.obj",
                                   "--scheme", "four-point", "--levels", "2", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["curves"], 2);
  EXPECT_EQ(json["vertices"], 6 * 4 + (5 - 1) * 4 + 1);
  EXPECT_NE(read_file(folder / "c.obj").find("\nl 1 2 3"), std::string::npos);
}

TEST(RefineCommand, TellsMeshesFromCurves) {
  const TempFolder folder;
  const auto run = [&](const std::string& file, const char* scheme,
                       const std::vector<std::string>& more = {}, const char* out = "c.obj",
                       const char* levels = "1") {
    std::vector<std::string> arguments{"refine",   file,   "-o",       folder / out,
                                       "--scheme", scheme, "--levels", levels};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_limes(arguments);
  };
  const std::string polygon = data_file("polygon.obj"), cube = data_file("cube.obj");
  expect_failure(run(polygon, "loop"), 3, "polylines and no faces");
  expect_failure(run(cube, "chaikin"), 3, "no polylines");
  for (const char* option :
       {"--boundary", "--corners", "--tags", "--split", "--weights", "--tension"})
    expect_failure(run(polygon, "chaikin", {option, "1"}), 2,
                   std::string(option) + ": chaikin has no such option");
  expect_failure(run(polygon, "lane-riesenfeld:0"), 2, "lane-riesenfeld");
  expect_failure(run(polygon, "chaikin", {"--tension", "1"}), 2, "--tension");
  expect_failure(run(polygon, "four-point", {"--tension", "9"}), 2, "--tension");
  expect_failure(run(polygon, "chaikin", {"--boundary", "edges"}), 2, "--boundary");
  expect_failure(run(polygon, "chaikin", {"--limit"}), 2, "--limit");
  expect_failure(run(polygon, "chaikin", {}, "c.ply"), 2, "--output");
  expect_failure(run(polygon, "chaikin", {}, "c.obj", "60"), 3, "level");
  expect_failure(run(folder.file("two.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "chaikin"), 3,
                 "an open polyline with 2 points; chaikin needs 3");
  expect_failure(run(folder.file("bad.obj", "v 0 0 0\nl 1 7\n"), "chaikin"), 3,
                 "bad.obj:2: vertex 7 does not exist");
  EXPECT_EQ(folder.list().size(), 2U);
}

}  // namespace
}  // namespace limes::test
