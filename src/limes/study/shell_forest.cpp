#include "limes/study/shell_forest.h"

#include <utility>

#include "limes/study/shell_model.h"
#include "limes/study/shell_placement.h"
#include "limes/subdiv/schemes.h"

namespace limes {

ShellForest shell_forest(const Problem& problem, const Mesh& control) {
  require_shell_control(problem, control);
  const RefineOptions options{.levels = 0,
                              .boundary = control.tags.boundary.value_or(BoundaryRule::edges)};
  const bool exact = problem.mesh.exact;
  ShellForest out{
      Forest(exact ? refined_on_surfaces(problem, control, 0) : control,
             find_scheme(exact ? "linear" : problem.mesh.scheme), options, SplitUnit::families, {},
             exact ? exact_placement(problem, control) : Placement()),
      seams_of(problem, control)};
  for (int level = 0; level < problem.mesh.levels; ++level)
    out.forest.refine(out.forest.leaves());
  return out;
}

}  // namespace limes
