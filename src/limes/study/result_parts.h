#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "limes/study/adaptive.h"
#include "limes/study/checks.h"

namespace limes {

// What results of every kind of problem have.

/// The user's names of units, where they are given.
[[nodiscard]] nlohmann::ordered_json units_json(const UnitSettings& units);

[[nodiscard]] nlohmann::ordered_json checks_json(const std::vector<SolutionCheck>& checks);

/// Seconds by phase, and bytes.
void add_cost(const std::vector<std::pair<std::string, double>>& timings, std::int64_t peak_memory,
              nlohmann::ordered_json& out);

/// One of the files of a report.
struct ReportFile {
  std::string name;
  std::string bytes;
};

/// A figure in the report and as a picture beside it.
void add_picture(const Drawing& picture, const std::string& png, HtmlReport& report,
                 std::vector<ReportFile>& files);

/// Steps, convergence diagram (or a sentence that one step has none) and last mesh of an adaptive run.
/// @param direction  to look along; without it straight onto a plane model
void add_adaptive_section(const AdaptSettings& settings, const AdaptiveRun& run, const Mesh& mesh,
                          const std::optional<Vec3>& direction, HtmlReport& report,
                          std::vector<ReportFile>& files);

/// Unit of a stress from the user's names, "N/mm²"; empty if one of them is.
[[nodiscard]] std::string stress_unit(const UnitSettings& units);
/// "3.5 mm", "3.5" without a unit.
[[nodiscard]] std::string with_unit(const std::string& value, const std::string& unit);

/// As the report shows them.
[[nodiscard]] std::vector<Check> shown_checks(const std::vector<SolutionCheck>& checks);

}  // namespace limes
