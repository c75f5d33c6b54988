#include "limes/study/shell_finer.h"

#include <cmath>
#include <utility>

#include "limes/core/parallel.h"
#include "limes/fem/resultant_norm.h"
#include "limes/study/adaptive.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"
#include "limes/subdiv/split_leaves.h"

namespace limes {
namespace {

Mesh split_mesh(const ShellModel& model, const ShellForest& shell,
                const std::vector<TiedEdge>& tied, const ForestMesh& mesh, int levels) {
  const Problem& problem = model.problem;
  if (problem.mesh.exact)
    return refined_on_surfaces(problem, *model.mesh, levels, tied,
                               edges_in_forest(shell.forest, mesh, shell.curves));
  return refine(
      *model.mesh, find_scheme(problem.mesh.scheme),
      {.levels = levels, .boundary = model.mesh->tags.boundary.value_or(BoundaryRule::edges)});
}

/// Of the closure with hanging nodes: of the forest with all leaves split. A side in which a node hangs has others there, in both halves.
ShellModel finer_hanging_model(const ShellModel& model, const ShellForest& shell,
                               const ForestMesh& mesh, int levels) {
  const Problem& problem = model.problem;
  Forest forest = shell.forest;
  ForestMesh fine = mesh;
  fine.mesh.points = model.mesh->points;
  std::vector<TiedEdge> tied;
  for (int level = 0; level < levels; ++level) {
    forest = split_leaves(std::move(forest), 1);
    ForestMesh split = forest_mesh(forest, Closure::hanging);
    tied = tied_edges(forest, split, shell.seams);
    if (problem.mesh.smoothing > 0)  // the forest does not know where vertices have gone
      place_children(fine,
                     surfaces_of_vertices(problem, split.mesh, tied,
                                          edges_in_forest(forest, split, shell.curves)),
                     split);
    fine = std::move(split);
  }
  return shell_model_on(problem, std::move(fine.mesh), tied, fine.hanging);
}

}  // namespace

ShellModel finer_model(const ShellModel& model, const ShellForest& shell,
                       const std::vector<TiedEdge>& tied, const ForestMesh& mesh, int levels) {
  if (split_unit(model.problem) == SplitUnit::faces)
    return finer_hanging_model(model, shell, mesh, levels);
  return shell_model_on(model.problem, split_mesh(model, shell, tied, mesh, levels),
                        refined_seams(*model.mesh, tied, levels));
}

std::vector<double> error_against(const ShellModel& finer, const ShellSolution& finer_solution,
                                  int levels, const ShellModel& model,
                                  const ShellSolution& solution) {
  const int num_faces = model.mesh->topology.num_faces();
  const std::int64_t children = std::int64_t(1) << (2 * levels);
  std::vector<double> out(static_cast<std::size_t>(num_faces), 0.0);
  for_each_index(num_faces, [&](std::int64_t i) {
    for (std::int64_t path = 0; path < children; ++path) {
      const FaceId child(children * i + path);
      const ShellQuad quad = finer.quad(child);
      const double gauss = 1 / std::sqrt(3.0);
      for (const double r : {-gauss, gauss})
        for (const double s : {-gauss, gauss}) {
          const Vec2 uv(0.5 + r / 2, 0.5 + s / 2);
          const ShellResultants exact = resultants_at(finer, finer_solution, child, {r, s});
          const ShellResultants here = resultants_at(
              model, solution, FaceId(i), 2 * in_ancestor(uv, path, levels) - Vec2(1, 1));
          out[static_cast<std::size_t>(i)] +=
              quad.area_normal({r, s}).norm() *
              energy_between(turned(here, exact.normal), exact, finer.section(child));
        }
    }
  });
  return out;
}

}  // namespace limes
