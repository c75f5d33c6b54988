#pragma once

#include <nlohmann/json_fwd.hpp>

#include "limes/study/checks.h"
#include "limes/study/probes.h"

namespace limes {

/// A solved problem with everything that is reported about it.
struct PlaneResult {
  PlaneModel model;
  PlaneSolution solution;
  std::vector<ProbeResult> probes;
  std::vector<SolutionCheck> checks;
  /// Seconds by phase, in order; measured, so the only part that differs from run to run.
  std::vector<std::pair<std::string, double>> timings;
  std::int64_t peak_memory = 0;  ///< bytes
};

/// Contents of result.json, without timings and memory if not wanted (for comparisons).
[[nodiscard]] nlohmann::ordered_json result_json(const PlaneResult& result,
                                                 bool with_timings = true);

/// result.vtu: curved cells of degree 3 (on which displacements are exact) with displacement, stress,
/// strain, von Mises stress as nodal values, material and face of the refined mesh per cell.
void write_result_vtu(const std::filesystem::path& file, const PlaneResult& result);

/// report.html: numbers, pictures and checks in one file.
void write_report(const std::filesystem::path& file, const PlaneResult& result);

}  // namespace limes
