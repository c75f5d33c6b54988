#pragma once

#include <string>
#include <vector>

#include "limes/study/shell_layers.h"

namespace limes {

/// What a probe finds at the nearest point of the bilinear elements.
struct ShellProbe {
  std::string name;
  Vec3 at;  ///< asked for
  Vec3 point;
  double distance;
  FaceId face;
  Vec3 displacement;
  /// Vector about the global axes, in radians; none about the director of a smooth node.
  Vec3 rotation;
  ShellState state;  ///< at the centre of that element
};
[[nodiscard]] std::vector<ShellProbe> probe(const ShellModel& model, const ShellSolution& solution);

}  // namespace limes
