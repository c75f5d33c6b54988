#pragma once

#include "limes/mesh/mesh.h"
#include "limes/subdiv/scheme.h"

namespace limes {

struct RefineOptions {
  int levels = 1;
  BoundaryRule boundary = BoundaryRule::edges;
};

/// Uniform refinement of a mesh with its tags, groups and parts. With BoundaryRule::none the faces
/// that touch the boundary shape the others and are then left out.
/// @throws InputError for a mesh that cannot be refined (see mesh/defects.h)
[[nodiscard]] Mesh refine(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options);

}  // namespace limes
