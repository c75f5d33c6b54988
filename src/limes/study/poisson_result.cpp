#include "limes/study/poisson_result.h"

#include <nlohmann/json.hpp>

#include <cmath>

#include "limes/io/vtu.h"
#include "limes/study/poisson_conditions.h"
#include "limes/study/result_parts.h"

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json probes_json(const PoissonResult& result) {
  Json out = Json::object();
  for (const PoissonProbe& p : result.probes) {
    const PoissonState& s = p.state;
    out[p.name] = {{"at", {p.at.x(), p.at.y(), p.at.z()}},
                   {"point", {s.x.x(), s.x.y(), s.x.z()}},
                   {"distance", p.distance},
                   {"value", s.value},
                   {"gradient", {s.gradient.x(), s.gradient.y()}}};
  }
  return out;
}

}  // namespace

nlohmann::ordered_json result_json(const PoissonResult& result, bool with_timings) {
  const PlaneModel& model = result.model;
  const PoissonSolution& solution = result.solution;
  Json out;
  out["title"] = model.problem.title;
  out["model"] = "poisson";
  out["scheme"] = model.problem.mesh.scheme;
  out["levels"] = model.problem.mesh.levels;
  out["dofs"] = solution.num_unknowns;
  out["elements"] = model.space->elements().size();
  out["strain_energy"] = solution.strain_energy;
  out["units"] = units_json(model.problem.units);
  out["probes"] = probes_json(result);
  out["load"] = solution.load;
  out["reactions"] = Json::array();
  for (const PoissonSolution::Reaction& r : solution.reactions)
    out["reactions"].push_back({{"where", r.where}, {"flux", r.flux}});
  if (result.adaptive) {
    out["steps"] = steps_json(*result.adaptive);
    out["end"] = result.adaptive->history.end;
  }
  out["checks"] = checks_json(result.checks);
  if (with_timings) add_cost(result.timings, result.peak_memory, out);
  return out;
}

void write_result_vtu(const ByteSink& sink, const PoissonResult& result) {
  const PlaneModel& model = result.model;
  const SubdivisionSpace& space = *model.space;
  VtuGrid grid;
  grid.points = model.mesh().points.vector();
  std::vector<double> value, gradient, error, finer_error;
  std::vector<std::int64_t> material;
  for (int v = 0; v < model.mesh().points.size(); ++v) {
    const int dof = dof_of_vertex(space, VertexId(v));
    value.push_back(dof < 0 ? 0.0 : result.solution.u(dof));
  }
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    const Element& element = space.elements()[static_cast<std::size_t>(e)];
    std::vector<std::int64_t> ids;
    for (const VertexId v : model.mesh().topology.face(element.face))
      ids.push_back(v.value);
    grid.add_cell(VtkCell::quad, ids);
    const ElementTable centre = space.sample(element.shape, {Vec2(0.5, 0.5)});
    const PoissonState s = states(model, result.solution, e, centre).front();
    gradient.insert(gradient.end(), {s.gradient.x(), s.gradient.y(), 0.0});
    material.push_back(model.material_of_element[static_cast<std::size_t>(e)]);
    const auto face = static_cast<std::size_t>(element.face.value);
    if (result.adaptive) error.push_back(std::sqrt(result.adaptive->squares[face]));
    if (result.adaptive && !result.adaptive->finer_squares.empty())
      finer_error.push_back(std::sqrt(result.adaptive->finer_squares[face]));
  }
  grid.point_data = {{"value", 1, std::move(value)}};
  grid.cell_data = {{"gradient", 3, std::move(gradient)}, {"material", 1, std::move(material)}};
  if (!error.empty()) grid.cell_data.push_back({"error", 1, std::move(error)});
  if (!finer_error.empty())
    grid.cell_data.push_back({"error_against_finer", 1, std::move(finer_error)});
  write_vtu(sink, grid);
}

}  // namespace limes
