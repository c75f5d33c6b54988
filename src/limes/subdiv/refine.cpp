#include "limes/subdiv/refine.h"

#include "limes/core/memory.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/drop_faces.h"
#include "limes/subdiv/split.h"
#include "limes/subdiv/uniform.h"

namespace limes {
namespace {

std::vector<FaceId> descendants(const Topology& control, const std::vector<FaceId>& faces,
                                Split split, int levels) {
  std::vector<FaceId> all;
  for (const FaceId f : faces) {
    const FaceRange d = descendants(control, f, split, levels);
    for (std::int64_t i = d.begin; i < d.end; ++i)
      all.push_back(FaceId(i));
  }
  return all;
}

std::vector<FaceGroup> descendants(const Topology& control, const std::vector<FaceGroup>& groups,
                                   Split split, int levels) {
  std::vector<FaceGroup> all;
  for (const FaceGroup& g : groups)
    all.push_back({g.name, descendants(control, g.faces, split, levels)});
  return all;
}

}  // namespace

Mesh refine(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options) {
  const Adjacency adjacency(mesh.topology);
  Features features = resolve_tags(adjacency, mesh.tags, options.boundary);
  Mesh fine;
  if (options.levels == 0) {
    fine.topology = mesh.topology;
    fine.points = mesh.points;
  } else {
    UniformRefinement refinement(adjacency, features, scheme, options.levels);
    fine.topology = refinement.topology();
    resize_fresh(fine.points.vector(), static_cast<std::size_t>(refinement.num_vertices()));
    refinement.positions(mesh.points.span(), fine.points.span());
    features = refinement.features();
  }
  fine.tags = tags_of(fine.topology, features);
  fine.tags.holes = descendants(mesh.topology, mesh.tags.holes, scheme.split, options.levels);
  fine.tags.boundary = mesh.tags.boundary;
  fine.groups = descendants(mesh.topology, mesh.groups, scheme.split, options.levels);
  fine.parts = descendants(mesh.topology, mesh.parts, scheme.split, options.levels);
  if (options.boundary != BoundaryRule::none || scheme.reach == 0) return fine;
  const std::vector<bool> dropped = unsupported_faces(adjacency, mesh.tags);
  return without_faces(fine, descendants(mesh.topology, dropped, scheme.split, options.levels));
}

}  // namespace limes
