#include "problem_size.h"

#include <string>

#include "limes/core/error.h"
#include "limes/subdiv/schemes.h"
#include "size_plan.h"

namespace limes::app {
namespace {

// Bytes at the peak per element, at most what `limes solve --json` reports after 20 MB for the program:
// poisson 1.9e3 (l_shape, 49 152 elements), plane and linear 3.9e3 to 4.9e3 (cook, 4096; block, 17 664),
// mitc4 24.3e3 to 25.9e3 (roof, hemisphere, hole_5_kobbelt, i_beam; 4096 to 122 880), catmull-clark
// 24.7e3 to 25.4e3 (block, 17 664 and 70 656).
double bytes_of_element(const Problem& problem) {
  if (problem.model.kind == ModelKind::poisson) return 1.6e3;
  if (problem.model.kind == ModelKind::mitc4) return 24e3;
  return problem.mesh.scheme == "linear" ? 3.8e3 : 24e3;
}

/// A key that multiplies elements.
struct Levels {
  const Place* place;
  const char* key;
  int wanted, made_before;
  double bytes_per_element;
};

/// Refines the size as often as wanted. @throws InputError where it is not feasible any more
void require_levels(const Levels& levels, ModelKind kind, const Scheme& scheme,
                    std::int64_t memory_limit, MeshSize& size) {
  for (int level = 0; level <= levels.wanted; ++level) {
    if (level > 0) size = refined_size(size, scheme, levels.made_before + level - 1);
    const std::string reason =
        obstacle(size.corners, size.vertices,
                 levels.bytes_per_element * static_cast<double>(size.faces), memory_limit);
    if (reason.empty()) continue;
    const std::string possible = level > 0
                                     ? fmt::format("{} = {} is possible", levels.key, level - 1)
                                     : "a coarser mesh is right";
    throw InputError("{}: level {} would have {} elements and about {} unknowns: {}; {}",
                     levels.place->text, level, size.faces,
                     size.vertices * unknowns_per_vertex(kind), reason, possible);
  }
}

}  // namespace

void require_feasible(const Problem& problem, const Mesh& control, std::int64_t memory_limit) {
  const Scheme& scheme = find_scheme(problem.mesh.scheme);
  const double bytes = bytes_of_element(problem);
  const ModelKind kind = problem.model.kind;
  MeshSize size = size_of(control.topology);
  require_levels(
      {&problem.mesh.origin.of("levels"), "[mesh] levels", problem.mesh.levels, 0, bytes}, kind,
      scheme, memory_limit, size);
  if (problem.adapt)
    require_levels({&problem.adapt->origin.of("reference_levels"), "[adapt] reference_levels",
                    problem.adapt->reference_levels, problem.mesh.levels, bytes},
                   kind, scheme, memory_limit, size);
}

}  // namespace limes::app
