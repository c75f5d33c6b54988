#pragma once

#include "limes/limit/limit_surface.h"
#include "limes/subdiv/schemes.h"
#include "limit/local_refinement.h"
#include "limit/zoo.h"

namespace limes::test {

/// The limit of a mesh: model, basis and surface in one.
struct Surface {
  explicit Surface(const Mesh& mesh, BoundaryRule boundary = BoundaryRule::edges,
                   std::string_view scheme = "catmull-clark")
      : model(make_model(mesh, boundary)),
        basis(model.topology, model.features, find_scheme(scheme)),
        limit(basis, model.points) {}
  explicit Surface(const Shape& shape) : Surface(shape.mesh, shape.boundary, shape.scheme) {}
  Model model;
  LimitBasis basis;
  LimitSurface limit;
};

}  // namespace limes::test
