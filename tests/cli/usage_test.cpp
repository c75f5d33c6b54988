// Wrong usage, help, and the lists: what the program says before it touches a mesh.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "limes/io/io.h"
#include "limes/subdiv/schemes.h"

namespace limes::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

const Arguments refine_cube{"refine",   data_file("cube.obj"), "-o",       "/nonexistent/x.obj",
                            "--scheme", "catmull-clark",       "--levels", "1"};

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Usage, NeedsACommandThatExists) {
  expect_failure(run_limes({}), 2, "a command is missing");
  expect_failure(run_limes({"refin"}), 2, "there is no command 'refin'; did you mean refine?");
  expect_failure(run_limes({"frobnicate"}), 2, "known are info, refine");
}

TEST(Usage, NamesTheOptionThatIsWrong) {
  expect_failure(run_limes({"refine", "--levl", "3", "a.obj"}), 2, "did you mean --levels?");
  expect_failure(run_limes({"refine", "a.obj", "-o"}), 2, "--output needs a value");
  expect_failure(run_limes({"refine", "a.obj", "-o", "b.obj", "--levels", "1"}), 2,
                 "--scheme is required");
  expect_failure(run_limes({"refine", "-o", "b.obj", "--levels", "1", "--scheme", "linear"}), 2,
                 "MESH is required");
  expect_failure(run_limes(with(refine_cube, {"--levels", "2"})), 2, "more than once");
  expect_failure(run_limes(with(refine_cube, {"second.obj"})), 2, "'second.obj'");
}

TEST(Usage, ChecksEveryValue) {
  const auto refine = [](const char* scheme, const char* levels, const Arguments& more = {}) {
    return run_limes(with(
        {"refine", data_file("cube.obj"), "-o", "x.obj", "--scheme", scheme, "--levels", levels},
        more));
  };
  expect_failure(refine("catmul", "1"), 2, "there is no scheme 'catmul'; known are catmull-clark");
  for (const char* levels : {"-1", "x", "1.5", "", "99999999999", "0x2"})
    expect_failure(refine("linear", levels), 2, "--levels");
  expect_failure(refine("linear", "abc"), 2,
                 "--levels: 'abc' is no whole number; 0, 1 and so on are");
  expect_failure(refine("linear", "99999999999999999999"), 2,
                 "--levels: '99999999999999999999' is out of range; 0 to 2147483647 is right");
  for (const char* threads : {"0", "-2", "two"})
    expect_failure(refine("linear", "1", {"--threads", threads}), 2, "--threads");
  for (const char* size : {"0", "lots", "5X", "-1G", "G"})
    expect_failure(refine("linear", "1", {"--memory-limit", size}), 2, "--memory-limit");
  expect_failure(refine("catmull-clark", "1", {"--boundary", "smooth"}), 2,
                 "known are none, edges, edges-and-corners");
  expect_failure(refine("catmull-clark", "1", {"--weights", "warren"}), 2,
                 "known are standard, quarters");
}

TEST(Usage, AnEmptyValueIsNoValue) {
  expect_failure(run_limes({"info", ""}), 2, "MESH: the value is empty");
  expect_failure(run_limes({"solve", data_file("block.toml"), "-o", ""}), 2,
                 "--output: the value is empty");
  for (const char* option : {"--boundary", "--threads", "--memory-limit", "--tension"})
    expect_failure(run_limes(with(refine_cube, {option, ""})), 2,
                   std::string(option) + ": the value is empty");
}

TEST(Usage, RefusesOptionsOfOtherSchemes) {
  for (const char* option : {"--tension", "--corners", "--ring-pull"})
    expect_failure(run_limes(with(refine_cube, {option, "1"})), 2,
                   std::string(option) + ": catmull-clark has no such option");
  expect_failure(run_limes({"refine", data_file("cube.obj"), "-o", "x.obj", "--scheme", "linear",
                            "--levels", "1", "--boundary", "edges"}),
                 2, "--boundary: linear has no such option");
}

TEST(Usage, KnowsTheFormatsItCanWrite) {
  const Result result = run_limes(
      {"refine", data_file("cube.obj"), "-o", "cube.blend", "--scheme", "linear", "--levels", "0"});
  expect_failure(result, 2, "does not end in .obj, .off, .ply, .stl, .vtu");
}

TEST(Help, ShowsEveryOptionInItsGroup) {
  const Result result = run_limes({"refine", "--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* text :
       {"Usage: limes refine MESH -o FILE --scheme NAME --levels N [options]",
        "Files:", "Scheme:", "Running:", "--boundary RULE", "--tension W", "--corners RULE",
        "--limit", "--threads T", "--memory-limit SIZE", "--json", "--repair", "-h,--help"})
    EXPECT_NE(result.out.find(text), std::string::npos) << text;
  EXPECT_EQ(result.out.find("--ring-pull"), std::string::npos) << "no scheme has it yet";
}

TEST(Help, ListsEveryCommandAndTheExitCodes) {
  const Result result = run_limes({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* text : {"info", "refine", "schemes", "formats", "130 interrupted"})
    EXPECT_NE(result.out.find(text), std::string::npos) << text;
  EXPECT_EQ(run_limes({"--version"}).out.substr(0, 6), "limes ");
}

TEST(Lists, NameEverySchemeAndFormat) {
  const Result schemes = run_limes({"schemes"});
  const Json schemes_json = Json::parse(run_limes({"schemes", "--json"}).out);
  EXPECT_EQ(schemes_json["schemes"].size(), all_schemes().size());
  for (const Scheme& s : all_schemes())
    EXPECT_NE(schemes.out.find(s.name), std::string::npos) << s.name;

  const Result formats = run_limes({"formats"});
  const Json formats_json = Json::parse(run_limes({"formats", "--json"}).out);
  EXPECT_EQ(formats_json["formats"].size(), all_formats.size());
  for (const Format& f : all_formats)
    EXPECT_NE(formats.out.find(f.extension), std::string::npos) << f.extension;
}

}  // namespace
}  // namespace limes::test
