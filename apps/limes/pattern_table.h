#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limes/spectrum/quasi_pattern.h"

namespace limes::app {

/// What quasi-four-eight makes of a control vertex between equal triangles.
struct ControlPattern {
  int valence;       ///< of the control vertex
  const char* mesh;  ///< "polygon": these triangles alone; "star": further ones around them
  QuasiPattern pattern;
};
/// Both meshes for each of the valences first to last, from 3 on.
[[nodiscard]] std::vector<ControlPattern> control_patterns(int first, int last);

[[nodiscard]] std::string to_text(const std::vector<ControlPattern>& patterns);
[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<ControlPattern>& patterns);

}  // namespace limes::app
