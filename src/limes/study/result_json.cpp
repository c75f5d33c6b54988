#include <nlohmann/json.hpp>

#include "limes/limit/limit_surface.h"
#include "limes/study/result_files.h"
#include "limes/study/result_parts.h"

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json list(const Vector& v) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i)
    out.push_back(v(i));
  return out;
}

Json probes_json(const PlaneResult& result) {
  Json out = Json::object();
  for (const ProbeResult& p : result.probes) {
    const PlaneState& s = p.state;
    out[p.name] = {{"at", list(p.at)},         {"point", list(s.x)},
                   {"distance", p.distance},   {"displacement", {s.u.x(), s.u.y(), 0.0}},
                   {"strain", list(s.strain)}, {"stress", list(s.stress)},
                   {"von_mises", s.von_mises}};
  }
  return out;
}

Json reactions_json(const PlaneSolution& solution) {
  Json out = Json::array();
  for (const PlaneSolution::Reaction& r : solution.reactions)
    out.push_back({{"where", r.where},
                   {"force", {r.force(0), r.force(1), 0.0}},
                   {"moment", {0.0, 0.0, r.force(2)}}});
  return out;
}

}  // namespace

nlohmann::ordered_json result_json(const PlaneResult& result, bool with_timings) {
  const PlaneModel& model = result.model;
  const PlaneSolution& solution = result.solution;
  Json out;
  out["title"] = model.problem.title;
  out["model"] = model.assumption() == PlaneAssumption::strain ? "plane-strain" : "plane-stress";
  out["scheme"] = model.problem.mesh.scheme;
  out["levels"] = model.problem.mesh.levels;
  out["boundary"] = model.problem.model.boundary == FieldBoundary::free ? "free" : "phantom";
  out["dofs"] = solution.num_unknowns;
  out["elements"] = model.space->elements().size();
  out["strain_energy"] = solution.strain_energy;
  out["units"] = units_json(model.problem.units);
  out["probes"] = probes_json(result);
  out["loads"] = {{"force", {solution.loads(0), solution.loads(1), 0.0}},
                  {"moment", {0.0, 0.0, solution.loads(2)}}};
  out["reactions"] = reactions_json(solution);
  if (solution.homogenised) {
    const PlaneSolution::Homogenised& h = *solution.homogenised;
    out["effective_stiffness"] = Json::array();
    for (int i = 0; i < 3; ++i)
      out["effective_stiffness"].push_back(list(h.stiffness.row(i)));
    out["macroscopic_strain"] = list(h.strain);
    out["average_stress"] = list(h.stress);
    out["cell"] = {h.width, h.height};
  }
  if (result.adaptive) {
    out["steps"] = steps_json(*result.adaptive);
    out["end"] = result.adaptive->history.end;
  }
  out["checks"] = checks_json(result.checks);
  if (with_timings) add_cost(result.timings, result.peak_memory, out);
  return out;
}

}  // namespace limes
