#include "limit_mesh.h"

#include "limes/limit/limit_surface.h"
#include "limes/subdiv/drop_faces.h"
#include "limes/subdiv/split.h"

namespace limes::app {

Mesh limit_mesh(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options) {
  if (scheme.interpolatory) return refine(mesh, scheme, options);
  // With BoundaryRule::none the faces at the boundary shape the limit of the others, so they are
  // dropped last.
  const bool drop = options.boundary == BoundaryRule::none;
  const BoundaryRule rule = drop ? BoundaryRule::edges : options.boundary;
  Mesh fine = refine(mesh, scheme,
                     {.levels = options.levels, .boundary = rule, .weights = options.weights});
  Features features = resolve_tags(Adjacency(fine.topology), fine.tags, rule);
  features.weights = options.weights;
  const LimitBasis basis(fine.topology, std::move(features), scheme);
  fine.points = limit_positions(LimitSurface(basis, fine.points.span()), fine.points.span());
  if (!drop) return fine;
  const std::vector<bool> unsupported = unsupported_faces(Adjacency(mesh.topology), mesh.tags);
  return without_faces(fine, descendants(mesh.topology, unsupported, scheme.split, options.levels));
}

}  // namespace limes::app
