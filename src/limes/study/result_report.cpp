#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "limes/report/html.h"
#include "limes/report/pictures.h"
#include "limes/report/ticks.h"
#include "limes/solve/linear.h"
#include "limes/study/field_cells.h"
#include "limes/study/result_files.h"

namespace limes {
namespace {

/// A few significant digits for people; result.json has them all.
std::string shown(double value) {
  return fmt::format("{:.6g}", value);
}

std::string with_unit(const std::string& value, const std::string& unit) {
  return unit.empty() ? value : value + " " + unit;
}

/// Stress and its unit, from the user's names.
std::string stress_unit(const UnitSettings& units) {
  if (units.force.empty() || units.length.empty()) return {};
  return fmt::format("{}/{}²", units.force, units.length);
}

/// What the pictures of fields are drawn from: every tile as a small grid of triangles.
struct FieldTriangles {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> stress_xx, von_mises;

  void add(const FieldCell& cell, int n) {
    const int first = static_cast<int>(points.size());
    for (const PlaneState& s : cell.states) {
      points.push_back(s.x);
      stress_xx.push_back(s.stress(0));
      von_mises.push_back(s.von_mises);
    }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int v = first + j * (n + 1) + i;
        triangles.push_back({v, v + 1, v + n + 2});
        triangles.push_back({v, v + n + 2, v + n + 1});
      }
  }
};

FieldTriangles field_triangles(const PlaneResult& result) {
  // Some 300,000 triangles, however many elements there are.
  const auto elements = static_cast<double>(result.model.space->elements().size());
  const int n = std::clamp(static_cast<int>(std::sqrt(150'000 / elements)), 2, 12);
  FieldTriangles out;
  for_each_field_cell(result.model, result.solution, n, 3,
                      [&](const FieldCell& cell) { out.add(cell, n); });
  return out;
}

/// Limit curves of the element borders would be best; the mesh of limit points is close.
Lines mesh_lines(const PlaneModel& model) {
  Lines lines = edge_lines(model.mesh().topology, model.limit_points.span());
  lines.width = 0.5;
  lines.on_top = true;
  lines.colour = palette::muted;
  return lines;
}

Figure stress_figure(const PlaneResult& result, const FieldTriangles& field,
                     const std::vector<double>& values, const std::string& quantity,
                     const std::string& title) {
  FieldPicture picture{field.points, field.triangles, values, quantity,
                       stress_unit(result.model.problem.units)};
  if (result.model.space->elements().size() < 4000) picture.mesh_lines = mesh_lines(result.model);
  return field_figure(picture, {.title = title});
}

void add_summary(const PlaneResult& result, HtmlReport& report) {
  const PlaneModel& model = result.model;
  const Problem& problem = model.problem;
  const bool strain = model.assumption() == PlaneAssumption::strain;
  std::vector<std::pair<std::string, std::string>> rows{
      {"Model", strain ? "plane strain" : "plane stress"},
      {"Mesh", fmt::format("{}, {} faces, refined {} times", problem.mesh.file.string(),
                           model.control.topology.num_faces(), problem.mesh.levels)},
      {"Functions",
       fmt::format("{}, {} boundary", problem.mesh.scheme,
                   problem.model.boundary == FieldBoundary::free ? "free ghosts beyond the"
                                                                 : "standard (phantom)")},
      {"Elements", std::to_string(model.space->elements().size())},
      {"Unknowns", std::to_string(result.solution.num_unknowns)},
      {"Quadrature",
       fmt::format("{0} x {0} Gauss points per tile, {1} rings around extraordinary vertices",
                   problem.model.quadrature_points, problem.model.quadrature_depth)},
      {"Solver", std::string(DirectSolver::name())},
      {"Strain energy", shown(result.solution.strain_energy)}};
  report.summary(rows);
}

void add_homogenised(const PlaneSolution::Homogenised& h, const UnitSettings& units,
                     HtmlReport& report) {
  report.section("Homogenised cell");
  report.paragraph(fmt::format(
      "Cell of {} x {}; averages over the whole cell, holes count as zero stress. Macroscopic "
      "strain "
      "(xx, yy, 2xy) = ({}, {}, {}).",
      shown(h.width), shown(h.height), shown(h.strain(0)), shown(h.strain(1)), shown(h.strain(2))));
  const std::array names{"xx", "yy", "xy"};
  Table table{with_unit("Effective stiffness, stress per strain (engineering shear)",
                        stress_unit(units).empty() ? "" : "in " + stress_unit(units)),
              {"", "xx", "yy", "xy", "average stress"},
              {}};
  for (int i = 0; i < 3; ++i)
    table.rows.push_back({names[static_cast<std::size_t>(i)],
                          fmt::format("{:.8g}", h.stiffness(i, 0)),
                          fmt::format("{:.8g}", h.stiffness(i, 1)),
                          fmt::format("{:.8g}", h.stiffness(i, 2)), shown(h.stress(i))});
  report.table(table);
}

void add_probes(const PlaneResult& result, HtmlReport& report) {
  if (result.probes.empty()) return;
  report.section("Probes");
  Table table{"Nearest points of the surface",
              {"probe", "x", "y", "u_x", "u_y", "σ_{xx}", "σ_{yy}", "σ_{xy}", "von Mises"},
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
  Table table{"Resultants about the origin", {"", "F_x", "F_y", "M_z"}, {}};
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
  std::vector<Check> checks;
  for (const SolutionCheck& c : result.checks)
    checks.push_back({c.name, fmt::format("{:.2e}", c.value),
                      fmt::format("at most {:.2g}", c.limit), c.passed()});
  report.checks(checks);
}

/// A figure in the report and as a picture beside it.
void add_figure(const Figure& figure, const std::filesystem::path& png, HtmlReport& report) {
  const Drawing picture = drawing(figure);
  report.figure(picture);
  write_drawing(png, picture);
}

}  // namespace

void write_report(const std::filesystem::path& file, const PlaneResult& result) {
  const PlaneModel& model = result.model;
  const std::filesystem::path folder = file.parent_path();
  HtmlReport report(model.problem.title.empty() ? "Plane elasticity" : model.problem.title,
                    model.problem.file.filename().string());
  add_summary(result, report);
  if (result.solution.homogenised)
    add_homogenised(*result.solution.homogenised, model.problem.units, report);

  report.section("Mesh");
  add_figure(control_mesh_figure(model.control, {.title = "Control mesh"}),
             folder / "control-mesh.png", report);
  if (model.problem.mesh.levels > 0 && model.mesh().topology.num_faces() <= 20'000)
    add_figure(control_mesh_figure(model.mesh(), {.title = "Mesh of the analysis"}),
               folder / "analysis-mesh.png", report);

  report.section("Stress");
  const FieldTriangles field = field_triangles(result);
  add_figure(stress_figure(result, field, field.stress_xx, "σ_{xx}", "Stress in x"),
             folder / "stress-xx.png", report);
  add_figure(stress_figure(result, field, field.von_mises, "σ_{vM}", "Von Mises stress"),
             folder / "von-mises.png", report);
  add_probes(result, report);
  add_reactions(result, report);
  add_checks(result, report);
  report.raw_data("result.json", result_json(result).dump(2));
  report.write(file);
}

}  // namespace limes
