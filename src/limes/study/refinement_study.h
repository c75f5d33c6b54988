#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/problem/toml_document.h"
#include "limes/study/control_mesh.h"
#include "limes/study/result_parts.h"

namespace limes {

// `limes study` on a file with the table [refinement]: strategies of refinement of a shell compared by
// displacement and energy over unknowns, as in Figures 9, 10 and 13 of [kobbelt_1996];
// docs/command-line.md.

/// One way to refine: a problem with changes, solved on several levels or adaptively.
struct RefinementStrategy {
  std::string name;
  std::filesystem::path problem;
  std::vector<std::string> overrides;  ///< "dotted.path=value", as of --set
  std::vector<int> levels;  ///< without [adapt]; empty: the steps of the problem's [adapt]
  std::string place;        ///< "FILE:LINE"
};

struct RefinementStudy {
  std::string title;
  std::string probe;  ///< name of the problem's probe whose displacement is compared
  int component = 2;  ///< of the displacement
  std::optional<double> reference_energy, reference_displacement;
  std::vector<RefinementStrategy> strategies;  ///< at least one
};

/// @throws InputError "FILE:LINE: what" for unknown keys and values out of range
[[nodiscard]] RefinementStudy read_refinement_study(const toml::table& document,
                                                    const std::filesystem::path& file);

/// Beginning of the names of a strategy's pictures: letters and digits of its name, '-' for others.
[[nodiscard]] std::string picture_name(std::string name);

/// What one mesh gave.
struct RefinementPoint {
  int unknowns = 0, elements = 0;
  double energy = 0, displacement = 0;
};

struct RefinementCurve {
  std::string name;
  std::vector<RefinementPoint> points;
  Mesh first, last;
};

/// @param on_run   called with the name of what begins
/// @param options  all sizes are checked before the first problem is solved
/// @throws InputError naming the strategy: as the problems, and for one that is no shell or lacks the
///         probe; SolverError for a solution with a failed check
[[nodiscard]] std::vector<RefinementCurve> run(
    const RefinementStudy& study, const std::function<void(const std::string&)>& on_run = {},
    const ModelOptions& options = {});

/// strategy, unknowns, elements, energy, displacement, and relative errors where there is a reference.
[[nodiscard]] Table to_table(const RefinementStudy& study,
                             const std::vector<RefinementCurve>& curves);

/// The same by strategy.
[[nodiscard]] nlohmann::ordered_json to_json(const RefinementStudy& study,
                                             const std::vector<RefinementCurve>& curves);

/// table.csv, displacement.svg, energy-error.svg (with a reference), the first and last mesh of every
/// strategy as PNG, and report.html with all of them.
[[nodiscard]] std::vector<ReportFile> study_files(const RefinementStudy& study,
                                                  const std::vector<RefinementCurve>& curves);

}  // namespace limes
