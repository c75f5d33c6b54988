#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/study/approximation_study.h"
#include "limes/study/refinement_study.h"
#include "memory.h"
#include "problem_size.h"
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
  void study_approximation(const toml::table& document) const;
  void study_refinement(const toml::table& document) const;
};

void print_timed(nlohmann::ordered_json object, const Run& current) {
  object["seconds"] = current.seconds();
  object["peak_memory"] = peak_memory();
  print_object(object);
}

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

void write_files(const std::filesystem::path& folder, const std::vector<ReportFile>& all) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError("{}: {}", folder.string(), error.message());
  AtomicFiles files;
  for (const ReportFile& file : all)
    files.add(folder / file.name).write(file.bytes);
  files.commit();
}

void StudyCommand::study_approximation(const toml::table& document) const {
  const Run current(run);
  const ApproximationStudy plan = read_approximation_study(document, study);
  ErrorTable table;
  {
    const Progress progress(fmt::format("studying {}", study.string()));
    table = limes::run(plan);
  }
  if (!output.empty()) write_files(output, {{"table.csv", to_csv(table)}});
  if (run.json) {
    print_timed(json_table(table), current);
    return;
  }
  print((plan.title.empty() ? "" : plan.title + "\n") + text_table(table));
}

void StudyCommand::study_refinement(const toml::table& document) const {
  const Run current(run);
  const RefinementStudy plan = read_refinement_study(document, study);
  std::optional<Progress> progress;
  const auto on_run = [&](const std::string& name) {
    progress.emplace(fmt::format("solving {}", name));
  };
  const auto check_size = [&](const Problem& problem, const Mesh& control) {
    require_feasible(problem, control, current.memory_limit());
  };
  const std::vector<RefinementCurve> curves =
      limes::run(plan, on_run, {.repair = false, .check_size = check_size});
  progress.reset();
  if (!output.empty()) write_files(output, study_files(plan, curves));
  if (run.json) {
    print_timed(to_json(plan, curves), current);
    return;
  }
  const Table table = to_table(plan, curves);
  std::vector<std::vector<std::string>> rows{table.header};
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  print((plan.title.empty() ? "" : plan.title + "\n") + format_table(rows));
}

void StudyCommand::operator()() const {
  if (!output.empty()) check_output_folder(output);
  const toml::table document = parse_toml(read_toml_text(study), study);
  if (document.contains("refinement"))
    study_refinement(document);
  else if (document.contains("approximation"))
    study_approximation(document);
  else
    throw InputError("{}: a study has the table [approximation] or [refinement]; here is neither",
                     study.string());
}

}  // namespace

void add_study(CLI::App& program) {
  const auto command = std::make_shared<StudyCommand>();
  CLI::App& app = *program.add_subcommand(
      "study", "Measure errors by step width or strategy, beside published ones");
  app.add_option("STUDY", command->study, "Study to read, .toml")->required()->option_text(" ");
  app.add_option("-o,--output", command->output,
                 "Folder to write the table, plots and pictures into")
      ->option_text("DIR")
      ->group(files_group);
  add_run_options(app, command->run);
  app.footer(
      "Studies: [approximation] of a graph or a sphere by the scheme kobbelt; [refinement] of a "
      "shell by several strategies.\n\n"
      "  limes study data/graph_study.toml\n"
      "  limes study data/hole_study.toml -o DIR");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
