#include "limes/study/result_parts.h"

#include <fmt/format.h>

#include "limes/report/render.h"
#include "limes/report/ticks.h"

namespace limes {

using Json = nlohmann::ordered_json;

Json units_json(const UnitSettings& units) {
  Json out = Json::object();
  if (!units.length.empty()) out["length"] = units.length;
  if (!units.force.empty()) out["force"] = units.force;
  return out;
}

Json checks_json(const std::vector<SolutionCheck>& checks) {
  Json out = Json::array();
  for (const SolutionCheck& c : checks)
    out.push_back(
        {{"name", c.name}, {"value", c.value}, {"limit", c.limit}, {"passed", c.passed()}});
  return out;
}

void add_cost(const std::vector<std::pair<std::string, double>>& timings, std::int64_t peak_memory,
              Json& out) {
  out["timings"] = Json::object();
  for (const auto& [phase, seconds] : timings)
    out["timings"][phase] = seconds;
  out["peak_memory"] = peak_memory;
}

void add_picture(const Drawing& picture, const std::string& png, HtmlReport& report,
                 std::vector<ReportFile>& files) {
  report.figure(picture);
  files.push_back({png, encode_png(to_image(picture))});
}

void add_adaptive_section(const AdaptSettings& settings, const AdaptiveRun& run, const Mesh& mesh,
                          const std::optional<Vec3>& direction, HtmlReport& report,
                          std::vector<ReportFile>& files) {
  report.section("Adaptive refinement");
  report.paragraph(how_refined(settings) + " " + end_of(run));
  report.table(steps_table(run));
  if (const auto steps = steps_drawing(run))
    add_picture(*steps, "convergence.png", report, files);
  else
    report.paragraph(
        "There is no diagram of the error over the unknowns: fewer than two steps have an error "
        "above 0.");
  add_picture(drawing(error_figure(run, mesh, direction)), "adapted-mesh.png", report, files);
}

std::string stress_unit(const UnitSettings& units) {
  if (units.force.empty() || units.length.empty()) return {};
  return fmt::format("{}/{}²", units.force, units.length);
}

std::string with_unit(const std::string& value, const std::string& unit) {
  return unit.empty() ? value : value + " " + unit;
}

std::vector<Check> shown_checks(const std::vector<SolutionCheck>& checks) {
  std::vector<Check> out;
  for (const SolutionCheck& c : checks)
    out.push_back({c.name, format_readable(c.value, 3), "at most " + format_readable(c.limit, 2),
                   c.passed()});
  return out;
}

}  // namespace limes
