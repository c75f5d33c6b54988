#include "limes/adapt/loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "limes/core/interrupt.h"

namespace limes {
namespace {

AdaptStep figures(const StepSolution& solution, const AdaptTargets& targets) {
  AdaptStep step;
  step.dofs = solution.dofs;
  step.elements = solution.elements;
  step.strain_energy = solution.strain_energy;
  const double square = std::accumulate(solution.squares.begin(), solution.squares.end(), 0.0);
  step.error_estimate = std::sqrt(square);
  const double whole = 2 * solution.strain_energy + square;
  step.relative_error = whole > 0 ? std::sqrt(square / whole) : 0.0;
  if (targets.reference_energy) {
    step.true_error = std::sqrt(2 * std::abs(*targets.reference_energy - step.strain_energy));
    if (*step.true_error > 0) step.effectivity = step.error_estimate / *step.true_error;
  }
  if (!solution.finer_squares.empty()) {
    step.finer_error = std::sqrt(
        std::accumulate(solution.finer_squares.begin(), solution.finer_squares.end(), 0.0));
    if (*step.finer_error > 0) step.finer_effectivity = step.error_estimate / *step.finer_error;
  }
  return step;
}

std::vector<FaceId> marked_leaves(const ForestMesh& mesh, const std::vector<double>& squares,
                                  const AdaptTargets& targets) {
  std::vector<FaceId> leaves;  // faces of one leaf follow each other
  std::vector<double> of_leaf;
  for (std::size_t f = 0; f < squares.size(); ++f) {
    if (leaves.empty() || leaves.back() != mesh.leaves[f]) {
      leaves.push_back(mesh.leaves[f]);
      of_leaf.push_back(0);
    }
    of_leaf.back() += squares[f];
  }
  std::vector<FaceId> out;
  for (const int i : marked(of_leaf, targets.mark, targets.share))
    out.push_back(leaves[static_cast<std::size_t>(i)]);
  return out;
}

/// Whether all leaves lie above the deepest level; what balance and seams add lies no deeper.
bool can_be_split(const Forest& forest, const std::vector<FaceId>& leaves, int deepest_level) {
  return std::all_of(leaves.begin(), leaves.end(),
                     [&](FaceId leaf) { return forest.ancestry(leaf).level < deepest_level; });
}

}  // namespace

bool has_too_many_dofs(const ForestMesh& mesh, const AdaptTargets& targets) {
  const auto free = mesh.mesh.points.size() - static_cast<std::int64_t>(mesh.hanging.size());
  return free * targets.dofs_per_vertex > targets.max_dofs;
}

AdaptHistory solve_adaptively(Forest& forest, const AdaptTargets& targets,
                              const std::function<StepSolution(const ForestMesh& mesh)>& solve,
                              std::span<const TiedEdge> seams) {
  const auto start = std::chrono::steady_clock::now();
  AdaptHistory history{targets.before, {}};
  for (ForestMesh mesh = forest_mesh(forest, targets.closure);;) {
    check_interrupt();
    const StepSolution solution = solve(mesh);
    history.steps.push_back(figures(solution, targets));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const auto ends = [&](const char* why) {
      history.end = why;
      return history;
    };
    if (targets.error && history.steps.back().relative_error <= *targets.error)
      return ends("target_error");
    if (static_cast<int>(history.steps.size()) >= targets.max_steps) return ends("max_steps");
    if (targets.max_seconds && seconds.count() >= *targets.max_seconds) return ends("max_seconds");
    const std::vector<FaceId> leaves = marked_leaves(mesh, solution.squares, targets);
    if (leaves.empty()) return ends("no error left");
    if (!can_be_split(forest, leaves, targets.deepest_level)) return ends("max_level");
    forest.refine(leaves);
    match_seams(forest, seams);
    mesh = forest_mesh(forest, targets.closure);
    if (has_too_many_dofs(mesh, targets)) return ends("max_dofs");
    if (targets.on_refined) targets.on_refined(history.steps, forest);
  }
}

}  // namespace limes
