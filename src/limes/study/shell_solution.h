#pragma once

#include "limes/study/checks.h"
#include "limes/study/shell_model.h"

namespace limes {

/// Force and moment about a point.
struct ShellResultant {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};

/// The solution of a shell problem.
struct ShellSolution {
  VectorX u;  ///< displacement and rotation vector of each node

  int num_unknowns = 0;    ///< after elimination
  int num_kink_nodes = 0;  ///< nodes with six unknowns
  double strain_energy = 0;
  double solver_residual = 0;  ///< relative
  double rounding_floor = 0;   ///< what rounding alone may leave of it
  ShellResultant loads;        ///< about the origin
  double load_size = 0;        ///< sum of the magnitudes of all nodal forces
  /// Of loads and reactions together, about the model's centre: zero but for rounding.
  ShellResultant imbalance;
  struct Reaction {
    std::string where;  ///< of the support
    ShellResultant resultant;
  };
  std::vector<Reaction> reactions;
};

/// @throws InputError for a rigid motion left free or, with assumed membrane strains, a face far from convex; SolverError if the
///         factorisation fails
[[nodiscard]] ShellSolution solve_shell(const ShellModel& model);

/// What a face carries at a point, rs from -1 to 1.
[[nodiscard]] ShellResultants resultants_at(const ShellModel& model, const ShellSolution& solution,
                                            FaceId face, const Vec2& rs);

/// Sum of the element matrices, six unknowns per vertex.
[[nodiscard]] SparseMatrix shell_matrix(const ShellModel& model);

[[nodiscard]] std::vector<SolutionCheck> check_solution(const ShellModel& model,
                                                        const ShellSolution& solution);

}  // namespace limes
