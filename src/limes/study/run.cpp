#include "limes/study/run.h"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <system_error>

#include "limes/adapt/finer.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/mesh/defects.h"
#include "limes/study/refine_control.h"
#include "limes/study/shell_error.h"
#include "limes/study/shell_finer.h"
#include "limes/study/shell_forest.h"
#include "limes/study/shell_supports.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split_leaves.h"

namespace limes {
namespace {

/// Times the phases of a run.
class Phases {
 public:
  Phases(const PhaseCallback& on_phase, std::vector<std::pair<std::string, double>>& timings)
      : on_phase_(on_phase), timings_(timings) {}

  template <class Work>
  auto operator()(const std::string& name, const Work& work) {
    check_interrupt();
    if (on_phase_) on_phase_(name);
    const auto start = std::chrono::steady_clock::now();
    const auto stop = [&] {
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      timings_.emplace_back(name, seconds.count());
    };
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      stop();
    } else {
      auto result = work();
      stop();
      return result;
    }
  }

 private:
  const PhaseCallback& on_phase_;
  std::vector<std::pair<std::string, double>>& timings_;
};

void require_kept_faces(const Problem& problem, const Tags& tags) {
  if (tags.boundary == BoundaryRule::none)
    fail_at(
        problem.adapt->origin.table,
        "[adapt] refines all faces, but {} has the boundary rule none, which drops those at "
        "the boundary; right is edges or edges-and-corners, 't interpolateboundary 1/0/0 2' or 1",
        mesh_path(problem).string());
}

/// The mesh of a step with every face split as often as reference_levels says, and what hangs in it.
ForestMesh reference_mesh(const Problem& problem, const Forest& forest, const ForestMesh& mesh,
                          const Scheme& scheme) {
  const int levels = problem.adapt->reference_levels;
  if (problem.adapt->closure == Closure::hanging) {
    Forest split = split_leaves(forest, levels);
    return forest_mesh(split, Closure::hanging);
  }
  ForestMesh out;
  out.mesh = refine(mesh.mesh, scheme, {.levels = levels});
  return out;
}

/// Refines step by step from the mesh that the problem names; model and solution of `result` are
/// those of the last step.
template <class Result, class Build, class Solve>
void solve_in_steps(const Problem& problem, const ModelOptions& options, const Build& build,
                    const Solve& solve, const PhaseCallback& on_phase, Result& result) {
  MeshFile file = read_control_mesh(problem, options);
  require_refinable(file.mesh, mesh_path(problem).string());
  require_kept_faces(problem, file.mesh.tags);
  const Scheme& scheme = find_scheme(problem.mesh.scheme);
  Forest forest = plane_forest(
      problem, refine_control(problem, file.mesh, {.levels = problem.mesh.levels}), scheme);
  const Problem step = step_problem(problem);
  int number = 0;
  result.adaptive = run_adaptively(problem, forest, {}, [&](const ForestMesh& mesh) {
    if (on_phase)
      on_phase(fmt::format("step {}, {} faces", number++, mesh.mesh.topology.num_faces()));
    result.model = build(step, mesh.mesh, mesh.hanging);
    result.solution = solve(result.model);
    StepSolution out{result.solution.num_unknowns,
                     static_cast<int>(result.model.space->elements().size()),
                     result.solution.strain_energy, estimate_error(result.model, result.solution)};
    if (const int levels = problem.adapt->reference_levels; levels > 0) {
      const ForestMesh split = reference_mesh(problem, forest, mesh, scheme);
      const PlaneModel finer = build(step, split.mesh, split.hanging);
      const auto reference = solve(finer);
      out.finer_squares =
          error_against(*finer.space, energy_density(finer, reference), levels, *result.model.space,
                        energy_density(result.model, result.solution));
    }
    return out;
  });
  result.model.problem = problem;
  result.model.remarks = std::move(file.remarks);
}

/// The same for shells: on a forest on the mesh of the file, whose first step has every face split as often
/// as `levels` says.
void solve_in_steps(const Problem& problem, const ModelOptions& options,
                    const PhaseCallback& on_phase, const ShellStepCallback& on_step,
                    ShellResult& result) {
  MeshFile file = read_control_mesh(problem, options);
  ShellForest shell = shell_forest(problem, file.mesh);
  int number = 0;
  result.adaptive = run_adaptively(problem, shell.forest, shell.seams, [&](const ForestMesh& mesh) {
    if (on_phase)
      on_phase(fmt::format("step {}, {} faces", number++, mesh.mesh.topology.num_faces()));
    const std::vector<TiedEdge> tied = tied_edges(shell.forest, mesh, shell.seams);
    ForestMesh smoothed = mesh;
    if (problem.mesh.smoothing > 0)
      smooth_on_surfaces(problem, shell.forest, shell.areas, shell.curves, tied, smoothed);
    result.model = shell_model_on(problem, std::move(smoothed.mesh), tied, mesh.hanging);
    result.solution = solve_shell(result.model);
    if (on_step) on_step(result.model, result.solution);
    StepSolution out{result.solution.num_unknowns, mesh.mesh.topology.num_faces(),
                     result.solution.strain_energy, estimate_error(result.model, result.solution)};
    if (const int levels = problem.adapt->reference_levels; levels > 0) {
      const ShellModel finer = finer_model(result.model, shell, tied, mesh, levels);
      out.finer_squares =
          error_against(finer, solve_shell(finer), levels, result.model, result.solution);
    }
    return out;
  });
  result.model.control = std::move(file.mesh);
  result.model.remarks = std::move(file.remarks);
}

template <class Result>
void write_all(const std::filesystem::path& folder, const Result& result) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError("{}: cannot be made: {}", folder.string(), error.message());
  AtomicFiles files;
  const auto write = [&](const std::string& name, std::string_view bytes) {
    files.add(folder / name).write(bytes);
  };
  AtomicFile& vtu = files.add(folder / "result.vtu");
  write_result_vtu([&](std::string_view bytes) { vtu.write(bytes); }, result);
  for (const ReportFile& file : report_files(result))
    write(file.name, file.bytes);
  write("result.json", result_json(result).dump(2) + "\n");
  check_interrupt();
  files.commit();
}

}  // namespace

PlaneResult run_problem(const Problem& problem, const ModelOptions& options,
                        const PhaseCallback& on_phase) {
  std::vector<std::pair<std::string, double>> timings;
  Phases phase(on_phase, timings);
  PlaneResult result;
  if (problem.adapt) {
    phase("steps",
          [&] { solve_in_steps(problem, options, build_model, solve_plane, on_phase, result); });
  } else {
    result.model = phase("model", [&] { return read_model(problem, options); });
    result.solution = phase("solve", [&] { return solve_plane(result.model); });
  }
  result.probes = phase("probes", [&] { return probe(result.model, result.solution); });
  for (std::string& remark : remarks_on(result.probes, result.model))
    result.model.remarks.push_back(std::move(remark));
  result.checks = phase("checks", [&] { return check_solution(result.model, result.solution); });
  result.timings = std::move(timings);
  return result;
}

PoissonResult run_poisson_problem(const Problem& problem, const ModelOptions& options,
                                  const PhaseCallback& on_phase) {
  std::vector<std::pair<std::string, double>> timings;
  Phases phase(on_phase, timings);
  PoissonResult result;
  if (problem.adapt) {
    phase("steps",
          [&] { solve_in_steps(problem, options, build_model, solve_poisson, on_phase, result); });
  } else {
    result.model = phase("model", [&] { return read_model(problem, options); });
    result.solution = phase("solve", [&] { return solve_poisson(result.model); });
  }
  result.probes = phase("probes", [&] { return probe(result.model, result.solution); });
  for (const PoissonProbe& p : result.probes)
    if (auto remark = remark_on(p, p.state.x, result.model))
      result.model.remarks.push_back(std::move(*remark));
  result.checks = phase("checks", [&] { return check_solution(result.model, result.solution); });
  result.timings = std::move(timings);
  return result;
}

ShellResult run_shell_problem(const Problem& problem, const ModelOptions& options,
                              const PhaseCallback& on_phase, const ShellStepCallback& on_step) {
  std::vector<std::pair<std::string, double>> timings;
  Phases phase(on_phase, timings);
  ShellResult result;
  if (problem.adapt) {
    phase("steps", [&] { solve_in_steps(problem, options, on_phase, on_step, result); });
  } else {
    result.model = phase("model", [&] { return read_shell_model(problem, options); });
    result.solution = phase("solve", [&] { return solve_shell(result.model); });
    if (on_step) on_step(result.model, result.solution);
  }
  for (std::string& remark : remarks_on_symmetry(result.model))
    result.model.remarks.push_back(std::move(remark));
  result.probes = phase("probes", [&] { return probe(result.model, result.solution); });
  for (const ShellProbe& p : result.probes)
    if (p.distance > 0.01 * result.model.diagonal)
      result.model.remarks.push_back(
          fmt::format("{}: probe '{}' is {:.3g} away from the surface; its values are those of the "
                      "nearest point",
                      problem.file.string(), p.name, p.distance));
  result.checks = phase("checks", [&] { return check_solution(result.model, result.solution); });
  result.timings = std::move(timings);
  return result;
}

void write_results(const std::filesystem::path& folder, const PlaneResult& result) {
  write_all(folder, result);
}

void write_results(const std::filesystem::path& folder, const PoissonResult& result) {
  write_all(folder, result);
}

void write_results(const std::filesystem::path& folder, const ShellResult& result) {
  write_all(folder, result);
}

}  // namespace limes
