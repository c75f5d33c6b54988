#include <fmt/format.h>

#include <cmath>

#include "limes/report/html.h"
#include "limes/report/pictures.h"
#include "limes/report/plot.h"
#include "limes/report/ticks.h"
#include "limes/study/refinement_study.h"

namespace limes {
namespace {

std::optional<double> relative_error(double value, const std::optional<double>& reference) {
  if (!reference) return std::nullopt;
  return std::abs(value / *reference - 1);
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

/// In quotes where a comma, quote or line end would be misread.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text)
    out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string to_csv(const Table& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i ? "," : "") + csv_field(row[i]);
    text += '\n';
  };
  add(table.header);
  for (const auto& row : table.rows)
    add(row);
  return text;
}

/// A curve of each strategy over the unknowns.
template <class Value>
std::vector<Series> series_of(const std::vector<RefinementCurve>& curves, const Value& value) {
  std::vector<Series> out;
  for (const RefinementCurve& curve : curves) {
    Series& series = out.emplace_back();
    series.name = curve.name;
    for (const RefinementPoint& p : curve.points)
      series.points.emplace_back(p.unknowns, value(p));
  }
  return out;
}

Drawing displacement_plot(const RefinementStudy& study,
                          const std::vector<RefinementCurve>& curves) {
  Plot plot{.title = "Displacement of " + study.probe,
            .x_label = "unknowns",
            .y_label = fmt::format("u_{{{}}}", "xyz"[study.component]),
            .x_scale = AxisScale::logarithmic,
            .series = series_of(curves, [](const RefinementPoint& p) { return p.displacement; })};
  if (study.reference_displacement) {
    double lowest = 1e300, highest = 0;
    for (const Series& s : plot.series)
      for (const Vec2& p : s.points) {
        lowest = std::min(lowest, p.x());
        highest = std::max(highest, p.x());
      }
    plot.series.push_back({.name = "reference",
                           .points = {{lowest, *study.reference_displacement},
                                      {highest, *study.reference_displacement}},
                           .markers = false,
                           .dashed = true});
  }
  return drawing(plot);
}

/// A logarithmic axis shows errors above 0 only.
bool has_error(const RefinementStudy& study, const std::vector<RefinementCurve>& curves) {
  for (const RefinementCurve& curve : curves)
    for (const RefinementPoint& p : curve.points)
      if (*relative_error(p.energy, study.reference_energy) > 0) return true;
  return false;
}

Drawing energy_plot(const RefinementStudy& study, const std::vector<RefinementCurve>& curves) {
  return drawing(convergence_plot("Relative error of the energy", "unknowns", "|E_{h} − E| / E",
                                  series_of(curves,
                                            [&](const RefinementPoint& p) {
                                              return *relative_error(p.energy,
                                                                     study.reference_energy);
                                            }),
                                  {{-1.0}}));
}

Figure mesh_figure(const Mesh& mesh, const std::string& title) {
  SurfacePicture surface;
  surface.points = mesh.points.vector();
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto c = mesh.topology.face(FaceId(f));
    surface.triangles.push_back({c[0].value, c[1].value, c[2].value});
    surface.triangles.push_back({c[0].value, c[2].value, c[3].value});
  }
  surface.control_mesh = edge_lines(mesh.topology, mesh.points.span());
  surface.control_mesh.width = mesh.topology.num_faces() > 2000 ? 0.4 : 0.8;
  Figure figure = surface_figure(
      surface, {.title = title, .size = {420, 360}, .density = 2, .direction = Vec3(-1, -1.5, -1)});
  figure.legend.clear();  // the lines are the elements
  return figure;
}

}  // namespace

std::string picture_name(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
  return name;
}

Table to_table(const RefinementStudy& study, const std::vector<RefinementCurve>& curves) {
  Table table{{}, {"strategy", "unknowns", "elements", "energy", "displacement"}, {}};
  if (study.reference_energy) table.header.emplace_back("energy error");
  if (study.reference_displacement) table.header.emplace_back("displacement error");
  for (const RefinementCurve& curve : curves)
    for (const RefinementPoint& p : curve.points) {
      table.rows.push_back({curve.name, std::to_string(p.unknowns), std::to_string(p.elements),
                            fmt::format("{:.8g}", p.energy),
                            fmt::format("{:.8g}", p.displacement)});
      if (study.reference_energy)
        table.rows.back().push_back(cell(relative_error(p.energy, study.reference_energy)));
      if (study.reference_displacement)
        table.rows.back().push_back(
            cell(relative_error(p.displacement, study.reference_displacement)));
    }
  return table;
}

nlohmann::ordered_json to_json(const RefinementStudy& study,
                               const std::vector<RefinementCurve>& curves) {
  nlohmann::ordered_json out;
  for (const RefinementCurve& curve : curves) {
    nlohmann::ordered_json& list = out["strategies"][curve.name];
    for (const RefinementPoint& p : curve.points) {
      nlohmann::ordered_json& point =
          list.emplace_back(nlohmann::ordered_json{{"unknowns", p.unknowns},
                                                   {"elements", p.elements},
                                                   {"energy", p.energy},
                                                   {"displacement", p.displacement}});
      if (const auto e = relative_error(p.energy, study.reference_energy))
        point["energy_error"] = *e;
      if (const auto e = relative_error(p.displacement, study.reference_displacement))
        point["displacement_error"] = *e;
    }
  }
  return out;
}

std::vector<ReportFile> study_files(const RefinementStudy& study,
                                    const std::vector<RefinementCurve>& curves) {
  std::vector<ReportFile> files;
  HtmlReport report(study.title.empty() ? "Refinement" : study.title);
  const auto add = [&](const Drawing& picture, const std::string& name) {
    report.figure(picture);
    files.push_back({name + ".svg", to_svg(picture)});
  };
  report.section("Convergence");
  if (study.reference_energy && has_error(study, curves))
    add(energy_plot(study, curves), "energy-error");
  add(displacement_plot(study, curves), "displacement");
  report.section("Meshes");
  for (const RefinementCurve& curve : curves)
    for (const auto& [mesh, which] : {std::pair(&curve.first, "start"), {&curve.last, "final"}}) {
      const Drawing picture =
          drawing(mesh_figure(*mesh, fmt::format("{}, {} mesh, {} elements", curve.name, which,
                                                 mesh->topology.num_faces())));
      report.figure(picture);
      files.push_back({fmt::format("{}-{}.png", picture_name(curve.name), which),
                       encode_png(to_image(picture))});
    }
  const Table table = to_table(study, curves);
  report.section("Figures");
  report.table(table);
  files.push_back({"table.csv", to_csv(table)});
  files.push_back({"report.html", report.text()});
  return files;
}

}  // namespace limes
