#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "limes/adapt/loop.h"
#include "limes/problem/problem.h"
#include "limes/report/figure.h"
#include "limes/report/html.h"

namespace limes {

/// An adaptive run as it is reported.
struct AdaptiveRun {
  AdaptHistory history;
  Mesh start;                         ///< before the first step
  std::vector<double> squares;        ///< squared error of each face of the last mesh
  std::vector<double> finer_squares;  ///< the same against a finer solution; empty: there is none
  int deepest_level = Forest::max_level;  ///< of leaves: see AdaptTargets
};

/// The problem as each step solves it: on a mesh as it is.
[[nodiscard]] Problem step_problem(const Problem& problem);

/// Which faces the closure of the problem needs to be split together.
[[nodiscard]] SplitUnit split_unit(const Problem& problem);

/// A forest of quadtrees on a plane mesh.
/// @param scheme  that places new vertices
/// @throws InputError for a face that is no quad
[[nodiscard]] Forest plane_forest(const Problem& problem, const Mesh& start, const Scheme& scheme);

/// Runs the loop on a forest.
/// @param solve  solves step_problem() on the mesh of a step
/// @param seams  edges of its control mesh where parts are tied
[[nodiscard]] AdaptiveRun run_adaptively(
    const Problem& problem, Forest& forest, std::span<const TiedEdge> seams,
    const std::function<StepSolution(const ForestMesh&)>& solve);

/// One object per step, for result.json.
[[nodiscard]] nlohmann::ordered_json steps_json(const AdaptiveRun& run);

/// How errors are estimated and elements marked and closed, as sentences.
[[nodiscard]] std::string how_refined(const AdaptSettings& settings);

/// Why the loop ended, as a sentence.
[[nodiscard]] std::string end_of(const AdaptiveRun& run);
/// A line per step.
[[nodiscard]] Table steps_table(const AdaptiveRun& run);
/// Error over degrees of freedom, both logarithmic; nothing if fewer than two steps have an error above 0.
[[nodiscard]] std::optional<Drawing> steps_drawing(const AdaptiveRun& run);
/// The logarithm of the error of each face, where it lies.
[[nodiscard]] Figure error_figure(const AdaptiveRun& run, const Mesh& mesh,
                                  const std::optional<Vec3>& direction);

}  // namespace limes
