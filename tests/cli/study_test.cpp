#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace limes::test {
namespace {

namespace fs = std::filesystem;

std::string two_strategies() {
  return "title = \"Two\"\n[refinement]\nproblem = \"" + data_file("roof.toml") +
         "\"\nprobe = \"free edge\"\nreference_energy = 1208.89\n"
         "[[strategy]]\nname = \"uniform, plain\"\nlevels = [2, 3]\n"
         "[[strategy]]\nname = \"adaptive\"\nset = [\"mesh.levels=2\", \"adapt.max_dofs=300\"]\n";
}

TEST(Study, WritesTableDiagramsAndPictures) {
  TempFolder folder;
  const std::string study = folder.file("two.toml", two_strategies());
  const fs::path out = fs::path(study).parent_path() / "out";
  const Result result = run_limes({"study", study, "-o", out.string(), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  const auto& uniform = json["strategies"]["uniform, plain"];
  ASSERT_EQ(uniform.size(), 2U);
  EXPECT_EQ(uniform[1]["elements"], 64);
  EXPECT_LT(uniform[1]["energy_error"], uniform[0]["energy_error"]);
  EXPECT_GT(json["strategies"]["adaptive"].size(), 1U);
  EXPECT_NEAR(json["strategies"]["adaptive"][0]["energy"].get<double>(),
              uniform[0]["energy"].get<double>(), 1e-8);
  for (const char* name :
       {"displacement.svg", "energy-error.svg", "report.html", "uniform--plain-start.png",
        "uniform--plain-final.png", "adaptive-start.png", "adaptive-final.png"})
    EXPECT_GT(fs::file_size(out / name), 1000U) << name;
  std::ifstream table(out / "table.csv");
  std::string head, first;
  std::getline(table, head);
  std::getline(table, first);
  EXPECT_EQ(head, "strategy,unknowns,elements,energy,displacement,energy error");
  EXPECT_EQ(first.substr(0, 17), "\"uniform, plain\",") << first;
}

TEST(Study, FailsBeforeItSolves) {
  TempFolder folder;
  const std::string study = folder.file("two.toml", two_strategies());
  const std::string file = folder.file("a-file", "");
  expect_failure(run_limes({"study", study, "-o", file}), 5, "it is a file; a folder is right");
  std::string large = two_strategies();
  large.replace(large.find("[2, 3]"), 6, "[2, 12]");
  const std::string too_fine = folder.file("large.toml", large);
  expect_failure(
      run_limes({"study", too_fine, "--memory-limit", "1G"}), 3,
      too_fine + ":6: strategy 'uniform, plain': --set mesh.levels: level 8 would have ");
  std::string nowhere = two_strategies();
  nowhere.replace(nowhere.find("\"mesh.levels=2\""), 15, "\"load.0.where=x > 1e9\"");
  const std::string missed = folder.file("missed.toml", nowhere);
  expect_failure(run_limes({"study", missed}), 3,
                 missed + ":9: strategy 'adaptive': --set load.0.where: where = 'x > 1e9' selects");
  expect_failure(run_limes({"study", data_file("roof.toml")}), 3,
                 "[approximation] or [refinement]");
}

}  // namespace
}  // namespace limes::test
