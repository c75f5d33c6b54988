#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "limes/core/text.h"
#include "limes/report/pictures.h"
#include "limes/report/ticks.h"
#include "limes/solve/linear.h"
#include "limes/study/poisson_conditions.h"
#include "limes/study/poisson_result.h"
#include "limes/study/result_parts.h"

namespace limes {
namespace {

std::string shown(double value) {
  return format_readable(value, 6);
}

void add_summary(const PoissonResult& result, HtmlReport& report) {
  const PlaneModel& model = result.model;
  const Mesh& start = result.adaptive ? result.adaptive->start : model.control;
  report.summary({{"Model", "Poisson's equation, bilinear elements"},
                  {"Mesh", fmt::format("{}, {}", model.problem.mesh.file.string(),
                                       counted(static_cast<std::size_t>(start.topology.num_faces()),
                                               "face", "faces"))},
                  {"Elements", std::to_string(model.space->elements().size())},
                  {"Unknowns", std::to_string(result.solution.num_unknowns)},
                  {"Solver", std::string(DirectSolver::name())},
                  {"Energy", shown(result.solution.strain_energy)}});
}

Figure value_figure(const PoissonResult& result) {
  const Mesh& mesh = result.model.mesh();
  FieldPicture field;
  field.points = mesh.points.vector();
  for (int v = 0; v < mesh.points.size(); ++v) {
    const int dof = dof_of_vertex(*result.model.space, VertexId(v));
    field.values.push_back(dof < 0 ? 0.0 : result.solution.u(dof));
  }
  for (const Element& e : result.model.space->elements()) {
    const auto c = mesh.topology.face(e.face);
    field.triangles.push_back({c[0].value, c[1].value, c[2].value});
    field.triangles.push_back({c[0].value, c[2].value, c[3].value});
  }
  field.quantity = "u";
  return field_figure(field, {.title = "Solution"});
}

void add_tables(const PoissonResult& result, HtmlReport& report) {
  if (!result.probes.empty()) {
    report.section("Probes");
    Table table{"Nearest points of the mesh", {"probe", "x", "y", "u", "u_{x}", "u_{y}"}, {}};
    for (const PoissonProbe& p : result.probes)
      table.rows.push_back({p.name, shown(p.state.x.x()), shown(p.state.x.y()),
                            shown(p.state.value), shown(p.state.gradient.x()),
                            shown(p.state.gradient.y())});
    report.table(table);
  }
  report.section("Sources and fluxes");
  Table table{"Into the body", {"", "flux"}, {}};
  table.rows.push_back({"all loads", shown(result.solution.load)});
  for (const PoissonSolution::Reaction& r : result.solution.reactions)
    table.rows.push_back({"support " + r.where, shown(r.flux)});
  report.table(table);
  report.section("Checks");
  report.checks(shown_checks(result.checks));
}

}  // namespace

std::vector<ReportFile> report_files(const PoissonResult& result) {
  const Problem& problem = result.model.problem;
  std::vector<ReportFile> files;
  HtmlReport report(problem.title.empty() ? "Poisson's equation" : problem.title,
                    problem.file.filename().string());
  add_summary(result, report);
  report.section("Solution");
  add_picture(drawing(value_figure(result)), "solution.png", report, files);
  if (result.adaptive)
    add_adaptive_section(*result.model.problem.adapt, *result.adaptive, result.model.mesh(),
                         std::nullopt, report, files);
  add_tables(result, report);
  report.raw_data("result.json, without timings", result_json(result, false).dump(2));
  report.footer(result.made_by);
  files.push_back({"report.html", report.text()});
  return files;
}

}  // namespace limes
