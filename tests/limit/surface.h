#pragma once

#include "limes/limit/limit_surface.h"
#include "limes/subdiv/schemes.h"
#include "limit/local_refinement.h"

namespace limes::test {

/// The Catmull-Clark limit of a mesh: model, basis and surface in one.
struct Surface {
  explicit Surface(const Mesh& mesh, BoundaryRule boundary = BoundaryRule::edges)
      : model(make_model(mesh, boundary)),
        basis(model.topology, model.features, find_scheme("catmull-clark")),
        limit(basis, model.points) {}
  Model model;
  LimitBasis basis;
  LimitSurface limit;
};

}  // namespace limes::test
