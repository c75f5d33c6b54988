#pragma once

#include "limes/study/result_files.h"
#include "limes/study/shell_probe.h"

namespace limes {

/// A solved shell with everything that is reported about it.
struct ShellResult {
  ShellModel model;
  ShellSolution solution;
  std::vector<ShellProbe> probes;
  std::vector<SolutionCheck> checks;
  std::optional<AdaptiveRun> adaptive;
  /// As in PlaneResult.
  std::vector<std::pair<std::string, double>> timings;
  std::int64_t peak_memory = 0;
  std::string made_by = {};
};

/// Contents of result.json, without timings and memory if not wanted (for comparisons).
[[nodiscard]] nlohmann::ordered_json result_json(const ShellResult& result,
                                                 bool with_timings = true);

/// result.vtu: the quads with displacement and rotation at nodes; per cell, at its centre, membrane,
/// bending, shear resultants in global axes (order xx, yy, zz, xy, yz, xz) and the von Mises stress
/// at top (the directors' side), middle and bottom; of an adaptive run the errors, estimated and against
/// a finer solution.
void write_result_vtu(const ByteSink& sink, const ShellResult& result);

/// report.html and its pictures, as for plane problems.
[[nodiscard]] std::vector<ReportFile> report_files(const ShellResult& result);

}  // namespace limes
