#include "limes/subdiv/refine.h"

#include "limes/core/memory.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/child_lists.h"
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

/// All steps at once; children are found by arithmetic.
Mesh refine_by_quadrisection(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options) {
  const Adjacency adjacency(mesh.topology);
  Features features = control_features(adjacency, mesh, scheme, options);
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

/// Step by step, for the other splits.
Mesh refine_by_steps(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options) {
  Mesh current = mesh;
  Features features = control_features(Adjacency(mesh.topology), mesh, scheme, options);
  for (int level = 0; level < options.levels; ++level) {
    const Adjacency adjacency(current.topology, Adjacency::Check::edges);
    const RefinementStep step(adjacency, features, scheme);
    const ChildLists children(step.parent_faces(), current.topology.num_faces());
    Mesh next;
    next.points.resize(static_cast<std::size_t>(step.num_child_vertices()));
    step.apply(current.points.span(), next.points.span());
    next.tags.holes = children.of(current.tags.holes);
    next.groups = children.of(current.groups);
    next.parts = children.of(current.parts);
    next.topology = step.child_topology();
    features = step.child_features();
    current = std::move(next);
  }
  Tags tags = tags_of(current.topology, features);
  tags.holes = std::move(current.tags.holes);
  tags.boundary = mesh.tags.boundary;
  current.tags = std::move(tags);
  return current;
}

}  // namespace

Features control_features(const Adjacency& adjacency, const Mesh& mesh, const Scheme& scheme,
                          const RefineOptions& options) {
  Features features = resolve_tags(adjacency, mesh.tags, options.boundary);
  features.tension = options.tension;
  features.weights = options.weights;
  if (options.sector_stencils) measure_corners(adjacency, mesh.points.span(), features);
  if (scheme.boundary == Boundary::open_net)
    add_breakpoints(adjacency, mesh.points.span(), options.corners, features);
  return features;
}

Mesh refine(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options) {
  if (scheme.needs_positions) {
    QuasiOptions quasi = options.quasi;
    quasi.levels = options.levels;
    return refine_quasi_four_eight(mesh, quasi).mesh;
  }
  return is_quadrisection(scheme.split) ? refine_by_quadrisection(mesh, scheme, options)
                                        : refine_by_steps(mesh, scheme, options);
}

}  // namespace limes
