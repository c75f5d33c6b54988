#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "limes/core/text.h"
#include "limes/report/html.h"
#include "limes/report/pictures.h"
#include "limes/report/ticks.h"
#include "limes/solve/linear.h"
#include "limes/study/shell_result.h"

namespace limes {
namespace {

const Vec3 view_direction(-1, -1.5, -1);

std::string shown(double value) {
  return format_readable(value, 6);
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

/// The length of the displacement on the shell, half of each quad as a triangle.
Figure displacement_figure(const ShellResult& result) {
  const Mesh& mesh = *result.model.mesh;
  FieldPicture field;
  field.points = mesh.points.vector();
  for (int v = 0; v < mesh.points.size(); ++v)
    field.values.push_back(result.solution.u.segment<3>(6 * v).norm());
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto c = mesh.topology.face(FaceId(f));
    for (std::size_t k = 2; k < c.size(); ++k)
      field.triangles.push_back({c[0].value, c[k - 1].value, c[k].value});
  }
  field.quantity = "|u|";
  field.unit = result.model.problem.units.length;
  field.mesh_lines = edge_lines(mesh.topology, mesh.points.span());
  if (result.adaptive)
    field.mesh_lines.width = 0.35;  // where it is fine, lines would cover the colours
  return field_figure(field, {.title = "Length of the displacement", .direction = view_direction});
}

void add_tables(const ShellResult& result, HtmlReport& report) {
  if (!result.probes.empty()) {
    report.section("Probes");
    Table table{
        "Nearest points of the elements", {"probe", "x", "y", "z", "u_x", "u_y", "u_z"}, {}};
    for (const ShellProbe& p : result.probes)
      table.rows.push_back(row(p.name, p.point, p.displacement));
    report.table(table);
  }
  report.section("Loads and reactions");
  Table table{"Resultants about the origin", {"", "F_x", "F_y", "F_z", "M_x", "M_y", "M_z"}, {}};
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
  add_picture(drawing(displacement_figure(result)), "displacement.png", report, files);
  if (result.adaptive)
    add_adaptive_section(*result.model.problem.adapt, *result.adaptive, *result.model.mesh,
                         view_direction, report, files);
  add_tables(result, report);
  report.raw_data("result.json, without timings", result_json(result, false).dump(2));
  report.footer(result.made_by);
  files.push_back({"report.html", report.text()});
  return files;
}

}  // namespace limes
