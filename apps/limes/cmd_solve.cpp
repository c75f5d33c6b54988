#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.h"
#include "files.h"
#include "help.h"
#include "limes/core/error.h"
#include "limes/study/run.h"
#include "memory.h"
#include "problem_size.h"
#include "run.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct SolveCommand {
  std::filesystem::path problem;
  std::filesystem::path output;
  std::vector<std::string> overrides;
  RunOptions run;
  bool repair = false;
  bool resume = false;

  void operator()() const;
  [[nodiscard]] std::string repeated() const;
  /// What follows once a result is there; `current` has the time since the start.
  template <class Result>
  void hand_over(Result result, const Run& current) const;
};

std::string shown(double value) {
  return fmt::format("{:.8g}", value);
}

/// As a shell reads it back: in quotes if a letter could mean something.
std::string shell_word(const std::string& text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string summary(const std::vector<SolutionCheck>& checks) {
  std::string text;
  for (const SolutionCheck& c : checks)
    text += fmt::format("check {}: {:.2e} {}, at most {:.2g}\n", c.name, c.value,
                        c.passed() ? "passed" : "FAILED", c.limit);
  return text;
}

/// A line per step of an adaptive run.
std::string steps_summary(const std::optional<AdaptiveRun>& run) {
  if (!run) return {};
  std::string text = "step  unknowns   energy           error estimate   of the norm";
  const bool reference = run->history.steps.front().true_error.has_value();
  const bool finer = run->history.steps.front().finer_error.has_value();
  if (reference) text += "   effectivity";
  if (finer) text += "   effectivity against finer";
  text += '\n';
  int number = 0;
  for (const AdaptStep& s : run->history.steps) {
    text += fmt::format("{:>4}  {:>8}   {:<14.8g}   {:<14.4g}   {:>8.3g} %", number++, s.dofs,
                        s.strain_energy, s.error_estimate, 100 * s.relative_error);
    if (reference)
      text += s.effectivity ? fmt::format("   {:>11.3f}", *s.effectivity) : std::string(14, ' ');
    if (s.finer_effectivity) text += fmt::format("   {:>13.3f}", *s.finer_effectivity);
    text += '\n';
  }
  return text + end_of(*run) + "\n";
}

/// The numbers that people look at first.
std::string summary(const PlaneResult& result) {
  std::string text = steps_summary(result.adaptive);
  text += fmt::format("{} unknowns, {} elements, strain energy {}\n", result.solution.num_unknowns,
                      result.model.space->elements().size(), shown(result.solution.strain_energy));
  if (result.solution.homogenised) {
    const Mat3& C = result.solution.homogenised->stiffness;
    text += "effective stiffness (xx, yy, xy)\n";
    for (int i = 0; i < 3; ++i)
      text += fmt::format("  {:>15.8g} {:>15.8g} {:>15.8g}\n", C(i, 0), C(i, 1), C(i, 2));
  }
  for (const ProbeResult& p : result.probes)
    text += fmt::format("probe {}: displacement ({}, {}), stress ({}, {}, {})\n", p.name,
                        shown(p.state.u.x()), shown(p.state.u.y()), shown(p.state.stress(0)),
                        shown(p.state.stress(1)), shown(p.state.stress(2)));
  for (const PlaneSolution::Reaction& r : result.solution.reactions)
    text += fmt::format("reaction at {}: force ({}, {}), moment {}\n", r.where, shown(r.force(0)),
                        shown(r.force(1)), shown(r.force(2)));
  return text + summary(result.checks);
}

std::string shown(const Vec3& v) {
  return fmt::format("({}, {}, {})", shown(v.x()), shown(v.y()), shown(v.z()));
}

std::string summary(const ShellResult& result) {
  std::string text = steps_summary(result.adaptive);
  text +=
      fmt::format("{} unknowns, {} elements, strain energy {}\n", result.solution.num_unknowns,
                  result.model.mesh->topology.num_faces(), shown(result.solution.strain_energy));
  for (const ShellProbe& p : result.probes)
    text += fmt::format("probe {}: displacement {}, rotation {} rad\n", p.name,
                        shown(p.displacement), shown(p.rotation));
  for (const ShellSolution::Reaction& r : result.solution.reactions)
    text += fmt::format("reaction at {}: force {}, moment {}\n", r.where, shown(r.resultant.force),
                        shown(r.resultant.moment));
  return text + summary(result.checks);
}

std::string summary(const PoissonResult& result) {
  std::string text = steps_summary(result.adaptive);
  text += fmt::format("{} unknowns, {} elements, energy {}\n", result.solution.num_unknowns,
                      result.model.space->elements().size(), shown(result.solution.strain_energy));
  for (const PoissonProbe& p : result.probes)
    text += fmt::format("probe {}: value {}, gradient ({}, {})\n", p.name, shown(p.state.value),
                        shown(p.state.gradient.x()), shown(p.state.gradient.y()));
  for (const PoissonSolution::Reaction& r : result.solution.reactions)
    text += fmt::format("flux at {}: {}\n", r.where, shown(r.flux));
  return text + summary(result.checks);
}

/// Names the checks that failed, after the results were written: they may still tell why.
void require_passed(const std::filesystem::path& problem,
                    const std::vector<SolutionCheck>& checks) {
  std::string failed;
  for (const SolutionCheck& c : checks)
    if (!c.passed())
      failed += fmt::format("{}{} is {:.2e}, at most {:.2g} is good", failed.empty() ? "" : "; ",
                            c.name, c.value, c.limit);
  if (!failed.empty())
    throw SolverError("{}: a check of the solution failed: {}", problem.string(), failed);
}

/// Names the problem in what a numerical method says.
template <class Work>
auto naming_problem(const std::filesystem::path& problem, const Work& work) {
  try {
    return work();
  } catch (const SolverError& error) {
    throw SolverError("{}: {}", problem.string(), error.what());
  }
}

/// The command without what only says where the results go and how the work is done.
std::string SolveCommand::repeated() const {
  std::string text = "limes solve " + shell_word(problem.string());
  for (const std::string& change : overrides)
    text += " --set " + shell_word(change);
  if (repair) text += " --repair";
  return text;
}

template <class Result>
void SolveCommand::hand_over(Result result, const Run& current) const {
  for (const std::string& r : result.model.remarks)
    remark(r);
  result.timings.emplace_back("total", current.seconds());
  result.peak_memory = peak_memory();
  result.made_by = fmt::format("Made by limes {}: {}", version(), repeated());
  if (!output.empty()) write_results(output, result);
  if (run.json)
    print_object(result_json(result));
  else
    print(summary(result) +
          (output.empty() ? ""
                          : fmt::format("results in {}: report.html, result.vtu, result.json\n",
                                        output.string())));
  require_passed(problem, result.checks);
}

void SolveCommand::operator()() const {
  const Run current(run);
  if (resume && output.empty())
    throw UsageError("--resume: name the folder of the run that was interrupted, -o DIR");
  check_output_folder(output);
  Problem settings = read_problem(problem, overrides);
  if (resume && !settings.adapt)
    throw UsageError("--resume: {} has no [adapt], whose steps could be resumed", problem.string());
  if (settings.adapt && !output.empty()) {
    settings.adapt->state = output / "adapt-state.json";
    settings.adapt->resume = resume;
  }
  std::optional<Progress> progress;
  const auto on_phase = [&](std::string_view phase) {
    progress.reset();
    progress.emplace(fmt::format("{}: {}", problem.string(), phase));
  };
  const auto solve_with = [&](const auto& solver) {
    const ModelOptions options{.repair = repair,
                               .check_size = [&](const Problem& checked, const Mesh& control) {
                                 require_feasible(checked, control, current.memory_limit());
                               }};
    auto result = naming_problem(problem, [&] { return solver(settings, options, on_phase); });
    progress.reset();
    hand_over(std::move(result), current);
  };
  if (settings.model.kind == ModelKind::mitc4)
    solve_with([](const auto&... arguments) { return run_shell_problem(arguments...); });
  else if (settings.model.kind == ModelKind::poisson)
    solve_with(run_poisson_problem);
  else
    solve_with(run_problem);
}

}  // namespace

void add_solve(CLI::App& program) {
  const auto command = std::make_shared<SolveCommand>();
  CLI::App& app = *program.add_subcommand("solve", "Solve the problem of a file");
  app.add_option("PROBLEM.toml", command->problem, "Problem file, see docs/problem-file.md")
      ->required()
      ->option_text(" ")
      ->group(files_group);
  app.add_option("-o,--output", command->output,
                 "Folder for report.html, result.vtu, result.json and pictures")
      ->option_text("DIR")
      ->group(files_group);
  app.add_option("--set", command->overrides,
                 "Change a value of the file: mesh.levels=3, load.0.force_per_area=[0,-1]")
      ->option_text("KEY=VALUE ...")
      ->group(work_group);
  app.add_flag("--resume", command->resume,
               "Go on with the adaptive run that was interrupted in DIR")
      ->group(work_group);
  app.add_flag("--repair", command->repair, "Mend the mesh where that is possible, and say how")
      ->group(files_group);
  add_run_options(app, command->run);
  app.footer("  limes solve block.toml -o block --set mesh.levels=2");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
