#include "limes/study/refinement_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "limes/core/error.h"
#include "limes/study/run.h"
#include "limes/study/toml_keys.h"

namespace limes {
namespace {

constexpr double any = std::numeric_limits<double>::max();

RefinementStrategy read_strategy(const toml::table& table, const RefinementStudy& study,
                                 const std::filesystem::path& usual_problem,
                                 const std::filesystem::path& file) {
  TomlKeys keys(table, "[[strategy]] ", file.string());
  RefinementStrategy out;
  out.name = keys.text("name", "");
  if (out.name.empty()) keys.fail("[[strategy]] name is missing");
  for (const RefinementStrategy& other : study.strategies)
    if (picture_name(other.name) == picture_name(out.name))
      keys.fail(
          fmt::format("strategies '{}' and '{}' have the same name for their pictures; names "
                      "must differ in letters or digits",
                      other.name, out.name));
  out.place = fmt::format("{}:{}", file.string(), table.source().begin.line);
  const std::string problem = keys.text("problem", "");
  out.problem = problem.empty() ? usual_problem : file.parent_path() / problem;
  if (out.problem.empty())
    keys.fail(fmt::format("strategy '{}' has no problem, nor has [refinement]", out.name));
  out.overrides = keys.texts("set");
  out.levels = keys.integers("levels", 0, 12);
  keys.require_no_others();
  return out;
}

int component_of(TomlKeys& keys) {
  const toml::node* const node = keys.take("component");
  const std::string name = keys.text("component", "z");
  const std::size_t i = std::string("xyz").find(name);
  if (name.size() != 1 || i == std::string::npos)
    keys.fail(*node, "[refinement] component must be \"x\", \"y\" or \"z\"");
  return static_cast<int>(i);
}

std::optional<double> optional_number(TomlKeys& keys, std::string_view key, double low) {
  const double value = keys.number(key, std::numeric_limits<double>::quiet_NaN(), low, any);
  if (value == 0)
    keys.fail(*keys.take(key), fmt::format("[refinement] {} is 0; errors are relative to it", key));
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

RefinementPoint point_of(const RefinementStudy& study, const ShellModel& model,
                         const ShellSolution& solution) {
  for (const ShellProbe& p : probe(model, solution))
    if (p.name == study.probe)
      return {solution.num_unknowns, model.mesh->topology.num_faces(), solution.strain_energy,
              p.displacement(study.component)};
  throw InputError("{}: there is no [[probe]] '{}', which the study names",
                   model.problem.file.string(), study.probe);
}

}  // namespace

RefinementStudy read_refinement_study(const toml::table& document,
                                      const std::filesystem::path& file) {
  TomlKeys top(document, "", file.string());
  RefinementStudy study;
  study.title = top.text("title", "");
  const toml::node* const node = top.take("refinement");
  const toml::node* const list = top.take("strategy");
  top.require_no_others();
  if (!node || !node->is_table())
    throw InputError("{}: [refinement] is missing: what is compared", file.string());
  TomlKeys keys(*node->as_table(), "[refinement] ", file.string());
  const std::string problem = keys.text("problem", "");
  study.probe = keys.text("probe", "");
  if (study.probe.empty())
    keys.fail("[refinement] probe is missing: the name of a [[probe]] of the problem");
  study.component = component_of(keys);
  study.reference_energy = optional_number(keys, "reference_energy", 0);
  study.reference_displacement = optional_number(keys, "reference_displacement", -any);
  keys.require_no_others();
  if (!list || !list->is_array_of_tables())
    throw InputError("{}: [[strategy]] is missing: a way to refine", file.string());
  for (const toml::node& one : *list->as_array())
    study.strategies.push_back(read_strategy(
        *one.as_table(), study, problem.empty() ? "" : file.parent_path() / problem, file));
  return study;
}

namespace {

/// Work on a problem with the changes of a strategy, which the study's line is to blame for.
template <class Work>
auto with_overrides(const RefinementStrategy& strategy, const Work& work) {
  try {
    return work();
  } catch (const UsageError& error) {
    throw InputError("{}: strategy '{}': {}", strategy.place, strategy.name, error.what());
  } catch (const SolverError& error) {
    throw SolverError("{}: strategy '{}': {}", strategy.place, strategy.name, error.what());
  }
}

Problem problem_of(const RefinementStudy& study, const RefinementStrategy& strategy,
                   const std::optional<int>& level) {
  const auto fail = [&](const std::string& what) {
    throw InputError("{}: strategy '{}': {}", strategy.place, strategy.name, what);
  };
  std::vector<std::string> overrides = strategy.overrides;
  if (level) overrides.push_back(fmt::format("mesh.levels={}", *level));
  Problem problem =
      with_overrides(strategy, [&] { return read_problem(strategy.problem, overrides); });
  if (problem.model.kind != ModelKind::mitc4)
    fail(fmt::format("{} is no shell; a [refinement] study compares shells, kind \"mitc4\"",
                     problem.file.string()));
  if (std::none_of(problem.probes.begin(), problem.probes.end(),
                   [&](const ProbeSettings& p) { return p.name == study.probe; }))
    fail(fmt::format("{} has no [[probe]] '{}'", problem.file.string(), study.probe));
  if (level)
    problem.adapt.reset();
  else if (!problem.adapt)
    fail(fmt::format("there are no levels, and no [adapt] in {}", problem.file.string()));
  return problem;
}

void require_passed(const RefinementStrategy& strategy, const ShellResult& result) {
  for (const SolutionCheck& c : result.checks)
    if (!c.passed())
      throw SolverError(
          "{}: strategy '{}': a check of the solution failed: {} is {:.2e}, at most "
          "{:.2g} is good",
          strategy.place, strategy.name, c.name, c.value, c.limit);
}

/// Names the strategy whose problem is refused.
void check_size(const RefinementStrategy& strategy, const Problem& problem,
                const ModelOptions& options) {
  if (!options.check_size) return;
  ModelOptions named = options;
  named.check_size = [&](const Problem& p, const Mesh& control) {
    try {
      options.check_size(p, control);
    } catch (const InputError& error) {
      throw InputError("{}: strategy '{}': {}", strategy.place, strategy.name, error.what());
    }
  };
  (void)read_control_mesh(problem, named);
}

}  // namespace

std::vector<RefinementCurve> run(const RefinementStudy& study,
                                 const std::function<void(const std::string&)>& on_run,
                                 const ModelOptions& options) {
  // All problems are read before the first is solved.
  std::vector<std::vector<Problem>> problems;
  for (const RefinementStrategy& strategy : study.strategies) {
    std::vector<Problem>& of_strategy = problems.emplace_back();
    if (strategy.levels.empty()) of_strategy.push_back(problem_of(study, strategy, {}));
    for (const int level : strategy.levels)
      of_strategy.push_back(problem_of(study, strategy, level));
    for (const Problem& problem : of_strategy)
      check_size(strategy, problem, options);
  }
  std::vector<RefinementCurve> out;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const RefinementStrategy& strategy = study.strategies[i];
    RefinementCurve& curve = out.emplace_back();
    curve.name = strategy.name;
    for (const Problem& problem : problems[i]) {
      if (on_run) on_run(fmt::format("{}, levels = {}", strategy.name, problem.mesh.levels));
      const auto keep = [&](const ShellModel& model, const ShellSolution& solution) {
        if (curve.points.empty()) curve.first = *model.mesh;
        curve.points.push_back(point_of(study, model, solution));
        curve.last = *model.mesh;
      };
      const ShellResult result =
          with_overrides(strategy, [&] { return run_shell_problem(problem, options, {}, keep); });
      require_passed(strategy, result);
    }
  }
  return out;
}

}  // namespace limes
