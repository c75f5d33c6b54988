#pragma once

#include <functional>

#include "limes/study/poisson_result.h"
#include "limes/study/result_files.h"
#include "limes/study/shell_result.h"

namespace limes {

/// Called when a phase of a run begins.
using PhaseCallback = std::function<void(std::string_view phase)>;

/// Reads, solves, probes and checks a problem; with [adapt] refines it step by step.
[[nodiscard]] PlaneResult run_problem(const Problem& problem, const ModelOptions& options = {},
                                      const PhaseCallback& on_phase = {});

/// Called with the solution of every step, or the only one.
using ShellStepCallback =
    std::function<void(const ShellModel& model, const ShellSolution& solution)>;

/// The same for a shell, [model] kind = "mitc4".
[[nodiscard]] ShellResult run_shell_problem(const Problem& problem,
                                            const ModelOptions& options = {},
                                            const PhaseCallback& on_phase = {},
                                            const ShellStepCallback& on_step = {});

/// The same for [model] kind = "poisson".
[[nodiscard]] PoissonResult run_poisson_problem(const Problem& problem,
                                                const ModelOptions& options = {},
                                                const PhaseCallback& on_phase = {});

/// Writes result.json, result.vtu, report.html and its pictures into a folder, which is made if it
/// is not there: all of them, or none of them is changed. @throws OutputError
void write_results(const std::filesystem::path& folder, const PlaneResult& result);
void write_results(const std::filesystem::path& folder, const ShellResult& result);
void write_results(const std::filesystem::path& folder, const PoissonResult& result);

}  // namespace limes
