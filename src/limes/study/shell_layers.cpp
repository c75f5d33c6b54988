#include "limes/study/shell_layers.h"

#include "limes/core/parallel.h"

namespace limes {

LayerStress von_mises_in_layers(const ShellResultants& resultants, double thickness) {
  return {shell_von_mises(resultants, thickness, thickness / 2),
          shell_von_mises(resultants, thickness, 0),
          shell_von_mises(resultants, thickness, -thickness / 2)};
}

ShellState state_at_centre(const ShellModel& model, const ShellSolution& solution, FaceId face) {
  ShellState out{resultants_at(model, solution, face, Vec2::Zero()), {}};
  out.von_mises = von_mises_in_layers(out.resultants, model.section(face).thickness);
  return out;
}

std::vector<ShellState> states_at_centres(const ShellModel& model, const ShellSolution& solution) {
  std::vector<ShellState> out(static_cast<std::size_t>(model.mesh->topology.num_faces()));
  for_each_index(static_cast<std::int64_t>(out.size()), [&](std::int64_t f) {
    out[static_cast<std::size_t>(f)] = state_at_centre(model, solution, FaceId(f));
  });
  return out;
}

}  // namespace limes
