#include "limit_mesh.h"

#include <cstdint>

#include "limes/limit/limit_surface.h"
#include "limes/subdiv/drop_faces.h"

namespace limes::app {
namespace {

/// The marks of faces handed down to their children after some quadrisections.
std::vector<bool> children_of_marked(const Topology& topology, const std::vector<bool>& marked,
                                     int levels) {
  if (levels == 0) return marked;
  const std::int64_t per_corner = std::int64_t{1} << (2 * (levels - 1));
  std::vector<bool> result;
  for (int f = 0; f < topology.num_faces(); ++f)
    result.insert(result.end(),
                  static_cast<std::size_t>(topology.face_size(FaceId(f)) * per_corner),
                  marked[static_cast<std::size_t>(f)]);
  return result;
}

}  // namespace

Mesh limit_mesh(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options) {
  // With BoundaryRule::none the faces at the boundary shape the limit of the others, so they are
  // dropped last.
  const bool drop = options.boundary == BoundaryRule::none;
  const BoundaryRule rule = drop ? BoundaryRule::edges : options.boundary;
  Mesh fine = refine(mesh, scheme, {options.levels, rule});
  const LimitBasis basis(fine.topology, resolve_tags(Adjacency(fine.topology), fine.tags, rule),
                         scheme);
  fine.points = limit_positions(LimitSurface(basis, fine.points.span()), fine.points.span());
  if (!drop) return fine;
  const std::vector<bool> unsupported = unsupported_faces(Adjacency(mesh.topology), mesh.tags);
  return without_faces(fine, children_of_marked(mesh.topology, unsupported, options.levels));
}

}  // namespace limes::app
