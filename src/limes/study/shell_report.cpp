#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "limes/core/text.h"
#include "limes/report/html.h"
#include "limes/report/ticks.h"
#include "limes/solve/linear.h"
#include "limes/study/shell_pictures.h"

namespace limes {
namespace {

std::string shown(double value) {
  return format_readable(value, 6);
}

std::string in_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + ", in " + unit;
}

std::vector<std::string> row(const std::string& name, const Vec3& a, const Vec3& b) {
  return {name, shown(a.x()), shown(a.y()), shown(a.z()), shown(b.x()), shown(b.y()), shown(b.z())};
}

void add_summary(const ShellResult& result, HtmlReport& report) {
  const Problem& problem = result.model.problem;
  report.summary(
      {{"Model", fmt::format("shell, MITC4 elements, {} membrane strains, shear factor {}",
                             problem.model.assumed_membrane ? "assumed" : "displacement",
                             shown(problem.model.shear_factor))},
       {"Mesh",
        fmt::format("{}, {}, refined {}", problem.mesh.file.string(),
                    counted(static_cast<std::size_t>(result.model.control.topology.num_faces()),
                            "face", "faces"),
                    counted(static_cast<std::size_t>(problem.mesh.levels), "time", "times"))},
       {"Placement", problem.mesh.exact ? "exact" : problem.mesh.scheme},
       {"Elements", std::to_string(result.model.mesh->topology.num_faces())},
       {"Unknowns", std::to_string(result.solution.num_unknowns)},
       {"Nodes on kinks", std::to_string(result.solution.num_kink_nodes)},
       {"Solver", std::string(DirectSolver::name())},
       {"Strain energy", shown(result.solution.strain_energy)}});
}

void add_probes(const ShellResult& result, HtmlReport& report) {
  if (result.probes.empty()) return;
  const UnitSettings& units = result.model.problem.units;
  report.section("Probes");
  report.paragraph(
      "What the nearest points of the elements do. Vectors have components along the axes x, y, z "
      "of the model; rotations are those of one small turn about these axes, by the right-hand "
      "rule, in radians.");
  Table places{in_unit("Points and displacements", units.length),
               {"probe", "x", "y", "z", "u_{x}", "u_{y}", "u_{z}"},
               {}};
  Table turns{"Rotations, in radians", {"probe", "θ_{x}", "θ_{y}", "θ_{z}"}, {}};
  Table stresses{in_unit("Von Mises stresses at the centre of the element", stress_unit(units)),
                 {"probe", "element", "top", "middle", "bottom"},
                 {}};
  for (const ShellProbe& p : result.probes) {
    places.rows.push_back(row(p.name, p.point, p.displacement));
    turns.rows.push_back(
        {p.name, shown(p.rotation.x()), shown(p.rotation.y()), shown(p.rotation.z())});
    stresses.rows.push_back({p.name, std::to_string(p.face.value), shown(p.state.von_mises.top),
                             shown(p.state.von_mises.middle), shown(p.state.von_mises.bottom)});
  }
  for (const Table& table : {places, turns, stresses})
    report.table(table);
}

void add_view(const ShellPictures& pictures, const std::string& unit, HtmlReport& report) {
  if (const auto view = pictures.view())
    report.view(*view, fmt::format("The stress at the top, to turn, in the colours of the pictures "
                                   "above: from 0 to {}.",
                                   with_unit(format_readable(pictures.stress_scale().high), unit)));
  else
    report.paragraph(fmt::format("There is no view to turn: the mesh has more than {} elements.",
                                 ShellPictures::most_faces_to_turn));
}

void add_tables(const ShellResult& result, HtmlReport& report) {
  add_probes(result, report);
  report.section("Loads and reactions");
  Table table{"Resultants about the origin",
              {"", "F_{x}", "F_{y}", "F_{z}", "M_{x}", "M_{y}", "M_{z}"},
              {}};
  const ShellSolution& s = result.solution;
  table.rows.push_back(row("all loads", s.loads.force, s.loads.moment));
  for (const ShellSolution::Reaction& r : s.reactions)
    table.rows.push_back(row("support " + r.where, r.resultant.force, r.resultant.moment));
  report.table(table);
  report.section("Checks");
  report.checks(shown_checks(result.checks));
}

}  // namespace

std::vector<ReportFile> report_files(const ShellResult& result) {
  const Problem& problem = result.model.problem;
  std::vector<ReportFile> files;
  HtmlReport report(problem.title.empty() ? "Shell" : problem.title,
                    problem.file.filename().string());
  add_summary(result, report);
  report.section("Displacement");
  const ShellPictures pictures(result);
  add_picture(drawing(pictures.displacement()), "displacement.png", report, files);
  report.section("Stress");
  report.paragraph(
      "Von Mises stress of membrane and bending forces, one value per element, at its centre: "
      "nothing is averaged between elements. Both pictures have the same scale.");
  add_picture(drawing(pictures.von_mises(ShellSide::top)), "von-mises-top.png", report, files);
  add_picture(drawing(pictures.von_mises(ShellSide::bottom)), "von-mises-bottom.png", report,
              files);
  add_view(pictures, stress_unit(problem.units), report);
  if (result.adaptive)
    add_adaptive_section(*result.model.problem.adapt, *result.adaptive, *result.model.mesh,
                         shell_view_direction(), report, files);
  add_tables(result, report);
  report.raw_data("result.json, without timings", result_json(result, false).dump(2));
  report.footer(result.made_by);
  files.push_back({"report.html", report.text()});
  return files;
}

}  // namespace limes
