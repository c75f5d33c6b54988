#pragma once

#include <vector>

#include "limes/study/shell_solution.h"

namespace limes {

/// A stress at top (the side that the directors point to), middle and bottom of the thickness.
struct LayerStress {
  double top = 0, middle = 0, bottom = 0;
};

/// Von Mises stresses of membrane and bending.
[[nodiscard]] LayerStress von_mises_in_layers(const ShellResultants& resultants, double thickness);

/// What an element carries at its centre.
struct ShellState {
  ShellResultants resultants;
  LayerStress von_mises;
};
[[nodiscard]] ShellState state_at_centre(const ShellModel& model, const ShellSolution& solution,
                                         FaceId face);
/// Of every face.
[[nodiscard]] std::vector<ShellState> states_at_centres(const ShellModel& model,
                                                        const ShellSolution& solution);

}  // namespace limes
