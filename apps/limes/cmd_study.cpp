#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/study/approximation_study.h"
#include "memory.h"
#include "run.h"
#include "table.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct StudyCommand {
  std::filesystem::path study;
  std::filesystem::path output;
  RunOptions run;

  void operator()() const;
};

std::string text_table(const ErrorTable& table) {
  std::vector<std::string> head{"h"};
  for (const ErrorColumn& c : table.columns) {
    head.insert(head.end(), {c.name, "ratio"});
    if (!c.printed.empty()) head.insert(head.end(), {"printed", "ratio"});
  }
  std::vector<std::vector<std::string>> rows{head};
  for (std::size_t i = 0; i < table.h.size(); ++i) {
    std::vector<std::string> row{fmt::format("{}", table.h[i])};
    for (const ErrorColumn& c : table.columns)
      for (const auto* errors : {&c.values, &c.printed}) {
        if (errors->empty()) continue;
        const bool there = i < errors->size();
        row.push_back(there ? fmt::format("{:.3e}", (*errors)[i]) : "");
        row.push_back(there && i > 0 ? fmt::format("{:.1f}", ErrorColumn::ratio(*errors, i)) : "");
      }
    rows.push_back(std::move(row));
  }
  return format_table(rows);
}

nlohmann::ordered_json json_table(const ErrorTable& table) {
  nlohmann::ordered_json columns = nlohmann::ordered_json::object();
  for (const ErrorColumn& c : table.columns) {
    std::vector<double> ratios;
    for (std::size_t i = 1; i < c.values.size(); ++i)
      ratios.push_back(ErrorColumn::ratio(c.values, i));
    columns[c.name] = {{"values", c.values}, {"ratios", ratios}, {"printed", c.printed}};
  }
  return {{"h", table.h}, {"errors", std::move(columns)}};
}

void StudyCommand::operator()() const {
  const Run current(run);
  const ApproximationStudy plan = read_approximation_study(study);
  ErrorTable table;
  {
    const Progress progress(fmt::format("studying {}", study.string()));
    table = limes::run(plan);
  }
  if (!output.empty()) {
    std::error_code error;
    std::filesystem::create_directories(output, error);
    if (error) throw OutputError("{}: {}", output.string(), error.message());
    AtomicFile file(output / "table.csv");
    file.write(to_csv(table));
    file.commit();
  }
  if (run.json) {
    nlohmann::ordered_json object = json_table(table);
    object["seconds"] = current.seconds();
    object["peak_memory"] = peak_memory();
    print_object(object);
    return;
  }
  print((plan.title.empty() ? "" : plan.title + "\n") + text_table(table));
}

}  // namespace

void add_study(CLI::App& program) {
  const auto command = std::make_shared<StudyCommand>();
  CLI::App& app =
      *program.add_subcommand("study", "Measure errors by step width, beside published ones");
  app.add_option("STUDY", command->study, "Study to read, .toml")->required()->option_text(" ");
  app.add_option("-o,--output", command->output, "Folder to write table.csv into")
      ->option_text("DIR")
      ->group(files_group);
  add_run_options(app, command->run);
  app.footer(
      "Studies so far: [approximation] of a graph or a sphere by the scheme kobbelt.\n\n"
      "  limes study data/graph_study.toml");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
