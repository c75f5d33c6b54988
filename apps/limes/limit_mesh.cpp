#include "limit_mesh.h"

#include <cstdint>

#include "limes/limit/limit_surface.h"
#include "limes/subdiv/drop_faces.h"
#include "limes/subdiv/split.h"

namespace limes::app {
namespace {

/// The marks of faces handed down to their descendants.
std::vector<bool> descendants_of_marked(const Topology& topology, const std::vector<bool>& marked,
                                        const Scheme& scheme, int levels) {
  std::vector<bool> result;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const FaceRange range = descendants(topology, FaceId(f), scheme.split, levels);
    result.insert(result.end(), static_cast<std::size_t>(range.end - range.begin),
                  marked[static_cast<std::size_t>(f)]);
  }
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
  return without_faces(fine,
                       descendants_of_marked(mesh.topology, unsupported, scheme, options.levels));
}

}  // namespace limes::app
