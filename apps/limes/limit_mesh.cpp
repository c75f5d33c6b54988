#include "limit_mesh.h"

#include <utility>

#include "boundary_faces.h"
#include "limes/limit/limit_surface.h"

namespace limes::app {

Mesh limit_mesh(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options) {
  // With BoundaryRule::none the faces at the boundary shape the limit of the others, so they are
  // dropped last.
  const bool drop = options.boundary == BoundaryRule::none;
  const BoundaryRule rule = drop ? BoundaryRule::edges : options.boundary;
  Mesh fine = refine(mesh, scheme, {options.levels, rule});
  const Adjacency adjacency(fine.topology);
  const LimitBasis basis(fine.topology, resolve_tags(adjacency, fine.tags, rule), scheme);
  IdArray<VertexId, Vec3> limits =
      limit_positions(LimitSurface(basis, fine.points.span()), fine.points.span());
  if (!drop) {
    fine.points = std::move(limits);
    return fine;
  }
  // refine() keeps the order of what is left.
  Mesh kept = refine(mesh, scheme, options);
  const std::vector<bool> at_boundary =
      children_of_marked(mesh.topology, boundary_faces(Adjacency(mesh.topology)), options.levels);
  int face = 0;
  for (int f = 0; f < fine.topology.num_faces(); ++f) {
    if (at_boundary[static_cast<std::size_t>(f)]) continue;
    const auto from = fine.topology.face(FaceId(f));
    const auto to = kept.topology.face(FaceId(face++));
    for (std::size_t i = 0; i < from.size(); ++i)
      kept.points[to[i]] = limits[from[i]];
  }
  return kept;
}

}  // namespace limes::app
