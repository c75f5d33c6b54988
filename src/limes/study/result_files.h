#pragma once

#include <nlohmann/json_fwd.hpp>

#include "limes/io/io.h"
#include "limes/study/checks.h"
#include "limes/study/probes.h"
#include "limes/study/result_parts.h"

namespace limes {

/// A solved problem with everything that is reported about it.
struct PlaneResult {
  PlaneModel model;
  PlaneSolution solution;
  std::vector<ProbeResult> probes;
  std::vector<SolutionCheck> checks;
  std::optional<AdaptiveRun> adaptive;
  /// Seconds by phase, in order; measured, so the only part that differs from run to run.
  std::vector<std::pair<std::string, double>> timings;
  std::int64_t peak_memory = 0;  ///< bytes
  /// What made it, for the foot of the report: version, command; the same for the same input.
  std::string made_by = {};
};

/// Contents of result.json, without timings and memory if not wanted (for comparisons).
[[nodiscard]] nlohmann::ordered_json result_json(const PlaneResult& result,
                                                 bool with_timings = true);

/// result.vtu: curved cells of degree 3 (on which displacements are exact) with displacement, stress,
/// strain, von Mises stress as nodal values, material and face of the refined mesh per cell; of an adaptive
/// run the errors of the face, estimated and against a finer solution.
void write_result_vtu(const ByteSink& sink, const PlaneResult& result);

/// report.html with numbers, pictures and checks, which needs no other file; and its pictures as .png.
/// No timings: the same result gives the same bytes.
[[nodiscard]] std::vector<ReportFile> report_files(const PlaneResult& result);

}  // namespace limes
