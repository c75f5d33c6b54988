#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limes/adapt/marking.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/forest_seams.h"

namespace limes {

struct AdaptStep {
  int dofs = 0, elements = 0;
  double strain_energy = 0;
  double error_estimate = 0;  ///< in the energy norm, whose square is twice the energy
  double relative_error = 0;  ///< estimate / energy norm of the exact solution, also estimated
  /// With a reference energy: sqrt(2 |E - E_h|), and estimate / error.
  std::optional<double> true_error, effectivity;
  /// With a finer solution: the norm of the difference to it, and estimate / that.
  std::optional<double> finer_error, finer_effectivity;
};

/// When the loop ends, and what it refines.
struct AdaptTargets {
  MarkingKind mark = MarkingKind::doerfler;
  double share = 0.5;  ///< see marked()
  Closure closure = Closure::conforming;
  /// Leaves on it are not refined. Less than Forest::max_level leaves room for finer solutions to split them.
  int deepest_level = Forest::max_level;
  std::optional<double> error = {};  ///< relative to the energy norm of the solution
  int max_dofs = 10'000;             ///< of vertices that do not hang times dofs_per_vertex
  int dofs_per_vertex = 1;
  int max_steps = 30;
  std::optional<double> max_seconds = {};       ///< no step begins later
  std::optional<double> reference_energy = {};  ///< of the exact solution, for true errors
  /// Finished steps of a run that is resumed, with a forest refined after the last of them.
  std::vector<AdaptStep> before = {};
  /// Called when the next mesh is going to be solved on.
  std::function<void(const std::vector<AdaptStep>& finished, const Forest& refined)> on_refined =
      {};
};

/// Whether a mesh is too large for a further step.
[[nodiscard]] bool has_too_many_dofs(const ForestMesh& mesh, const AdaptTargets& targets);

/// A solution on one mesh, and the squared error of each of its faces, which are 0 for holes.
struct StepSolution {
  int dofs = 0, elements = 0;
  double strain_energy = 0;
  std::vector<double> squares;
  std::vector<double> finer_squares =
      {};  ///< of the difference to a finer solution, if there is one
};

struct AdaptHistory {
  std::vector<AdaptStep> steps;  ///< at least one
  std::string end;               ///< why it ended: "target_error", "max_dofs", ...
};

/// Solve, estimate, mark, refine until a target is reached. Each step solves on the mesh of the forest
/// with the closure asked for; the errors of the faces in a leaf add up. The last call of `solve` is the
/// last step.
/// @param seams  edges of the control mesh where parts are tied: both sides are split together
/// @throws Interrupted between steps
[[nodiscard]] AdaptHistory solve_adaptively(
    Forest& forest, const AdaptTargets& targets,
    const std::function<StepSolution(const ForestMesh& mesh)>& solve,
    std::span<const TiedEdge> seams = {});

}  // namespace limes
