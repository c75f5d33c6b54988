#include "limes/study/shell_result.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "limes/io/vtu.h"
#include "limes/study/result_parts.h"

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json list(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// xx, yy, zz, xy, yz, xz
std::array<double, 6> components(const Mat3& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2)};
}

Json layers(const LayerStress& s) {
  return {{"top", s.top}, {"middle", s.middle}, {"bottom", s.bottom}};
}

Json probes_json(const ShellResult& result) {
  Json out = Json::object();
  for (const ShellProbe& p : result.probes)
    out[p.name] = {{"at", list(p.at)},
                   {"point", list(p.point)},
                   {"distance", p.distance},
                   {"displacement", list(p.displacement)},
                   {"rotation", list(p.rotation)},
                   {"membrane", components(p.state.resultants.membrane)},
                   {"bending", components(p.state.resultants.bending)},
                   {"shear", list(p.state.resultants.shear)},
                   {"element", p.face.value},
                   {"von_mises", layers(p.state.von_mises)}};
  return out;
}

/// Fields of the cells, collected face by face.
struct CellFields {
  std::vector<double> membrane, bending, shear, top, middle, bottom;
  std::vector<std::int64_t> material;

  void add(const ShellState& state) {
    for (const double x : components(state.resultants.membrane))
      membrane.push_back(x);
    for (const double x : components(state.resultants.bending))
      bending.push_back(x);
    shear.insert(shear.end(), state.resultants.shear.begin(), state.resultants.shear.end());
    top.push_back(state.von_mises.top);
    middle.push_back(state.von_mises.middle);
    bottom.push_back(state.von_mises.bottom);
  }
};

}  // namespace

nlohmann::ordered_json result_json(const ShellResult& result, bool with_timings) {
  const ShellModel& model = result.model;
  const ShellSolution& solution = result.solution;
  Json out;
  out["title"] = model.problem.title;
  out["model"] = "mitc4";
  out["scheme"] = model.problem.mesh.scheme;
  out["levels"] = model.problem.mesh.levels;
  out["placement"] = model.problem.mesh.exact ? "exact" : "scheme";
  out["dofs"] = solution.num_unknowns;
  out["elements"] = model.mesh->topology.num_faces();
  out["kink_nodes"] = solution.num_kink_nodes;
  out["strain_energy"] = solution.strain_energy;
  out["units"] = units_json(model.problem.units);
  out["units"]["rotation"] = "rad";
  out["probes"] = probes_json(result);
  out["loads"] = {{"force", list(solution.loads.force)}, {"moment", list(solution.loads.moment)}};
  out["reactions"] = Json::array();
  for (const ShellSolution::Reaction& r : solution.reactions)
    out["reactions"].push_back({{"where", r.where},
                                {"force", list(r.resultant.force)},
                                {"moment", list(r.resultant.moment)}});
  if (result.adaptive) {
    out["steps"] = steps_json(*result.adaptive);
    out["end"] = result.adaptive->history.end;
  }
  out["checks"] = checks_json(result.checks);
  if (with_timings) add_cost(result.timings, result.peak_memory, out);
  return out;
}

void write_result_vtu(const ByteSink& sink, const ShellResult& result) {
  const ShellModel& model = result.model;
  const Topology& t = model.mesh->topology;
  VtuGrid grid;
  grid.points = model.mesh->points.vector();
  std::vector<double> displacement, rotation;
  for (int v = 0; v < t.num_vertices(); ++v) {
    const auto node = result.solution.u.segment<6>(6 * v);
    displacement.insert(displacement.end(), {node(0), node(1), node(2)});
    rotation.insert(rotation.end(), {node(3), node(4), node(5)});
  }
  CellFields cells;
  for (int f = 0; f < t.num_faces(); ++f) {
    std::vector<std::int64_t> ids;
    for (const VertexId v : t.face(FaceId(f)))
      ids.push_back(v.value);
    grid.add_cell(ids.size() == 4 ? VtkCell::quad : VtkCell::polygon, ids);
    cells.add(state_at_centre(model, result.solution, FaceId(f)));
    cells.material.push_back(model.material_of_face[static_cast<std::size_t>(f)]);
  }
  grid.point_data = {{"displacement", 3, std::move(displacement)},
                     {"rotation", 3, std::move(rotation)}};
  grid.cell_data = {{"membrane", 6, std::move(cells.membrane)},
                    {"bending", 6, std::move(cells.bending)},
                    {"shear", 3, std::move(cells.shear)},
                    {"von_mises_top", 1, std::move(cells.top)},
                    {"von_mises_middle", 1, std::move(cells.middle)},
                    {"von_mises_bottom", 1, std::move(cells.bottom)},
                    {"material", 1, std::move(cells.material)}};
  if (result.adaptive) {
    const auto add = [&](const char* name, const std::vector<double>& squares) {
      std::vector<double> error;
      for (const double square : squares)
        error.push_back(std::sqrt(square));
      if (!error.empty()) grid.cell_data.push_back({name, 1, std::move(error)});
    };
    add("error", result.adaptive->squares);
    add("error_against_finer", result.adaptive->finer_squares);
  }
  write_vtu(sink, grid);
}

}  // namespace limes
