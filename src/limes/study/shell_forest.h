#pragma once

#include <vector>

#include "limes/study/shell_placement.h"
#include "limes/subdiv/forest_seams.h"

namespace limes {

/// A forest of quadtrees on the control mesh of a shell.
struct ShellForest {
  Forest forest;
  std::vector<TiedEdge> seams;            ///< edges of the control mesh
  std::vector<std::vector<Edge>> curves;  ///< likewise, of each [[curve]]
  std::vector<double> areas;              ///< that faces of the control mesh should have
};

/// Every face is split as often as `levels` says. New vertices lie where build_shell_model() puts them.
/// Precondition: the scheme is interpolatory.
/// @param problem  must outlive the forest
/// @throws InputError as build_shell_model(), and for control faces that are no quads
[[nodiscard]] ShellForest shell_forest(const Problem& problem, const Mesh& control);

}  // namespace limes
