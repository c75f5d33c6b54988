#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "limes/core/text.h"
#include "limes/report/html.h"
#include "limes/report/ticks.h"
#include "limes/solve/linear.h"
#include "limes/study/result_pictures.h"

namespace limes {
namespace {

/// A few significant digits for people; result.json has them all.
std::string shown(double value) {
  return format_readable(value, 6);
}

std::size_t as_size(int count) {
  return static_cast<std::size_t>(count);
}

void add_summary(const PlaneResult& result, HtmlReport& report) {
  const PlaneModel& model = result.model;
  const Problem& problem = model.problem;
  const bool strain = model.assumption() == PlaneAssumption::strain;
  std::vector<std::pair<std::string, std::string>> rows{
      {"Model", strain ? "plane strain" : "plane stress"},
      {"Mesh",
       fmt::format("{}, {}, refined {}", problem.mesh.file.string(),
                   counted(as_size((result.adaptive ? result.adaptive->start : model.control)
                                       .topology.num_faces()),
                           "face", "faces"),
                   counted(as_size(problem.mesh.levels), "time", "times"))},
      {"Functions",
       fmt::format("{}, {} boundary", problem.mesh.scheme,
                   problem.model.boundary == FieldBoundary::free ? "free ghosts beyond the"
                                                                 : "standard (phantom)")},
      {"Elements", std::to_string(model.space->elements().size())},
      {"Unknowns", std::to_string(result.solution.num_unknowns)},
      {"Quadrature",
       fmt::format("{0} × {0} Gauss points per tile, {1} rings around extraordinary vertices",
                   problem.model.quadrature_points, problem.model.quadrature_depth)},
      {"Solver", std::string(DirectSolver::name())},
      {"Strain energy", shown(result.solution.strain_energy)}};
  report.summary(rows);
}

void add_homogenised(const PlaneSolution::Homogenised& h, const UnitSettings& units,
                     HtmlReport& report) {
  report.section("Homogenised cell");
  report.paragraph(fmt::format(
      "Cell of {} × {}; averages over the whole cell, holes count as zero stress. Macroscopic "
      "strain "
      "(xx, yy, 2xy) = ({}, {}, {}).",
      shown(h.width), shown(h.height), shown(h.strain(0)), shown(h.strain(1)), shown(h.strain(2))));
  const std::array names{"xx", "yy", "xy"};
  Table table{with_unit("Effective stiffness, stress per strain (engineering shear)",
                        stress_unit(units).empty() ? "" : "in " + stress_unit(units)),
              {"", "xx", "yy", "xy", "average stress"},
              {}};
  for (int i = 0; i < 3; ++i)
    table.rows.push_back({names[static_cast<std::size_t>(i)], format_readable(h.stiffness(i, 0), 8),
                          format_readable(h.stiffness(i, 1), 8),
                          format_readable(h.stiffness(i, 2), 8), shown(h.stress(i))});
  report.table(table);
}

void add_probes(const PlaneResult& result, HtmlReport& report) {
  if (result.probes.empty()) return;
  report.section("Probes");
  Table table{"Nearest points of the surface",
              {"probe", "x", "y", "u_{x}", "u_{y}", "σ_{xx}", "σ_{yy}", "σ_{xy}", "von Mises"},
              {}};
  for (const ProbeResult& p : result.probes) {
    const PlaneState& s = p.state;
    table.rows.push_back({p.name, shown(s.x.x()), shown(s.x.y()), shown(s.u.x()), shown(s.u.y()),
                          shown(s.stress(0)), shown(s.stress(1)), shown(s.stress(2)),
                          shown(s.von_mises)});
  }
  report.table(table);
}

void add_reactions(const PlaneResult& result, HtmlReport& report) {
  if (result.solution.homogenised) return;
  report.section("Loads and reactions");
  Table table{"Resultants about the origin", {"", "F_{x}", "F_{y}", "M_{z}"}, {}};
  const auto add = [&](const std::string& name, const PlaneResultant& r) {
    table.rows.push_back({name, shown(r(0)), shown(r(1)), shown(r(2))});
  };
  add("all loads", result.solution.loads);
  for (const PlaneSolution::Reaction& r : result.solution.reactions)
    add("support " + r.where, r.force);
  report.table(table);
}

void add_checks(const PlaneResult& result, HtmlReport& report) {
  report.section("Checks");
  report.checks(shown_checks(result.checks));
}

/// Figures in the report and as pictures beside it.
class Figures {
 public:
  Figures(HtmlReport& report, std::vector<ReportFile>& files) : report_(report), files_(files) {}

  void add(const Figure& figure, const std::string& png) {
    const Drawing picture = drawing(figure);
    report_.figure(picture);
    files_.push_back({png, encode_png(to_image(picture))});
  }

 private:
  HtmlReport& report_;
  std::vector<ReportFile>& files_;
};

void add_pictures(const PlaneResult& result, Figures& figures, HtmlReport& report) {
  const PlaneModel& model = result.model;
  report.section("Mesh");
  const Mesh& control = result.adaptive ? result.adaptive->start : model.control;
  figures.add(control_mesh_figure(control, {.title = "Control mesh"}), "control-mesh.png");
  constexpr int most_faces = 20'000;
  // The section on refinement shows meshes in whose sides vertices hang.
  if (model.problem.mesh.levels > 0 && !model.closed &&
      model.mesh().topology.num_faces() <= most_faces)
    figures.add(control_mesh_figure(model.mesh(), {.title = "Mesh of the analysis"}),
                "analysis-mesh.png");
  const ResultPictures pictures(result);
  report.section("Displacement");
  figures.add(pictures.deformed(), "deformed.png");
  report.section("Stress");
  figures.add(pictures.stress_xx(), "stress-xx.png");
  figures.add(pictures.von_mises(), "von-mises.png");
}

}  // namespace

std::vector<ReportFile> report_files(const PlaneResult& result) {
  const PlaneModel& model = result.model;
  std::vector<ReportFile> files;
  HtmlReport report(model.problem.title.empty() ? "Plane elasticity" : model.problem.title,
                    model.problem.file.filename().string());
  Figures figures(report, files);
  add_summary(result, report);
  if (result.solution.homogenised)
    add_homogenised(*result.solution.homogenised, model.problem.units, report);
  add_pictures(result, figures, report);
  if (result.adaptive)
    add_adaptive_section(*model.problem.adapt, *result.adaptive, model.mesh(), std::nullopt, report,
                         files);
  add_probes(result, report);
  add_reactions(result, report);
  add_checks(result, report);
  report.raw_data("result.json, without timings", result_json(result, false).dump(2));
  report.footer(result.made_by);
  files.push_back({"report.html", report.text()});
  return files;
}

}  // namespace limes
