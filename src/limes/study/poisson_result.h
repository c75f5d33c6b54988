#pragma once

#include "limes/study/adaptive.h"
#include "limes/study/poisson_solution.h"
#include "limes/study/result_files.h"

namespace limes {

/// Poisson's equation solved, with everything that is reported about it.
struct PoissonResult {
  PlaneModel model;
  PoissonSolution solution;
  std::vector<PoissonProbe> probes;
  std::vector<SolutionCheck> checks;
  std::optional<AdaptiveRun> adaptive;
  /// As in PlaneResult.
  std::vector<std::pair<std::string, double>> timings;
  std::int64_t peak_memory = 0;
  std::string made_by = {};
};

/// Contents of result.json, without timings and memory if not wanted (for comparisons).
[[nodiscard]] nlohmann::ordered_json result_json(const PoissonResult& result,
                                                 bool with_timings = true);

/// result.vtu: the quads with the value at the vertices; per cell the gradient at its centre, the
/// material and, of an adaptive run, the errors, estimated and against a finer solution.
void write_result_vtu(const ByteSink& sink, const PoissonResult& result);

/// report.html and its pictures, as for elasticity.
[[nodiscard]] std::vector<ReportFile> report_files(const PoissonResult& result);

}  // namespace limes
