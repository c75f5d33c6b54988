#pragma once

#include "limes/study/plane_solution.h"

namespace limes {

/// Where a probe landed on the surface, and what is there.
struct ProbeResult {
  std::string name;
  Vec3 at;          ///< asked for
  double distance;  ///< from there to the surface
  int element;
  Vec2 uv;
  PlaneState state;
};

/// Evaluates a solution at the nearest points of the surface to the problem's probes.
[[nodiscard]] std::vector<ProbeResult> probe(const PlaneModel& model,
                                             const PlaneSolution& solution);

/// One remark per probe that lies away from the surface by more than 1 % of the model's diagonal.
[[nodiscard]] std::vector<std::string> remarks_on(const std::vector<ProbeResult>& probes,
                                                  const PlaneModel& model);

}  // namespace limes
