#include "limes/study/shell_forest.h"

#include "limes/core/error.h"
#include "limes/study/adaptive.h"
#include "limes/study/refine_control.h"
#include "limes/study/shell_model.h"
#include "limes/study/shell_placement.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

/// Uniform steps before the forest takes over: it needs quads, and splits those of a seam in any case, which
/// a closure without hanging nodes might not do on both sides.
int levels_before(const Problem& problem, const Mesh& control, bool is_tied) {
  const Topology& t = control.topology;
  int before = 0;
  for (int f = 0; f < t.num_faces(); ++f)
    if (t.face_size(FaceId(f)) != 4) before = 1;
  const int least = before + (is_tied && split_unit(problem) == SplitUnit::families ? 1 : 0);
  if (problem.mesh.levels < least)
    fail_at(problem.mesh.origin.of("levels"), "[adapt] needs levels of {} or more here{}", least,
            before == 1 ? ": the mesh has faces that are no quads" : ": there are seams");
  return before;
}

}  // namespace

ShellForest shell_forest(const Problem& problem, const Mesh& control) {
  require_shell_control(problem, control);
  const std::vector<TiedEdge> seams = seams_of(problem, control);
  const int before = levels_before(problem, control, !seams.empty());
  const Scheme& scheme = find_scheme(problem.mesh.scheme);
  RefineOptions options{.levels = before,
                        .boundary = control.tags.boundary.value_or(BoundaryRule::edges)};
  const bool exact = problem.mesh.exact;
  Mesh start;
  if (exact)
    start = refined_on_surfaces(problem, control, before);
  else
    start = refine_control(
        problem, problem.mesh.smooth_start > 0 ? refined_on_surfaces(problem, control, 0) : control,
        options);
  options.levels = 0;
  ShellForest out{
      Forest(start, exact ? find_scheme("linear") : scheme, options, split_unit(problem), {},
             exact ? exact_placement(problem, control, before) : Placement()),
      refined_seams(control, seams, before), curve_edges(problem, control, before),
      wanted_areas(control, before)};
  for (int level = before; level < problem.mesh.levels; ++level)
    out.forest.refine(out.forest.leaves());
  return out;
}

}  // namespace limes
