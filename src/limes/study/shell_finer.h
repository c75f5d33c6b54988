#pragma once

#include <vector>

#include "limes/study/shell_forest.h"
#include "limes/study/shell_solution.h"

namespace limes {

/// The problem of a model on a mesh of a forest, with every face split `levels` times more. New vertices
/// are placed on exact surfaces or by the scheme; those of the model stay. The children of face f are the
/// 4^levels faces from 4^levels f on. Where a node hangs in a side of the mesh, others do in the halves of it.
/// @param tied  edges of the mesh on seams
[[nodiscard]] ShellModel finer_model(const ShellModel& model, const ShellForest& shell,
                                     const std::vector<TiedEdge>& tied, const ForestMesh& mesh,
                                     int levels);

/// Squared difference of the resultants of two solutions over every face, in the energy norm
/// (energy_between()), by the Gauss points of the finer mesh. Resultants of the coarse one are taken at the
/// same parameters and turned to the finer one's normal.
/// @param finer   finer_model(model, ..., levels)
[[nodiscard]] std::vector<double> error_against(const ShellModel& finer,
                                                const ShellSolution& finer_solution, int levels,
                                                const ShellModel& model,
                                                const ShellSolution& solution);

}  // namespace limes
