#pragma once

#include "limes/study/plane_solution.h"

namespace limes {

/// Where a probe landed on the surface.
struct ProbePlace {
  std::string name;
  Vec3 at;          ///< asked for
  double distance;  ///< from there to the surface
  int element;
  Vec2 uv;
};
/// The nearest points of the surface to the problem's probes.
[[nodiscard]] std::vector<ProbePlace> probe_places(const PlaneModel& model);

/// And what is there.
struct ProbeResult : ProbePlace {
  PlaneState state;
};

/// Evaluates a solution at the nearest points of the surface to the problem's probes.
[[nodiscard]] std::vector<ProbeResult> probe(const PlaneModel& model,
                                             const PlaneSolution& solution);

/// A remark if a probe lies away from the surface by more than 1 % of the model's diagonal.
[[nodiscard]] std::optional<std::string> remark_on(const ProbePlace& place, const Vec3& point,
                                                   const PlaneModel& model);
/// Those on all probes.
[[nodiscard]] std::vector<std::string> remarks_on(const std::vector<ProbeResult>& probes,
                                                  const PlaneModel& model);

}  // namespace limes
