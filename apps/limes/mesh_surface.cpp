#include "mesh_surface.h"

#include <utility>

#include "files.h"
#include "limes/core/error.h"
#include "limes/subdiv/drop_faces.h"
#include "limes/subdiv/refinement_step.h"

namespace limes::app {
namespace {

Features features_of(const Mesh& mesh, const SchemeChoice& choice) {
  Features features = resolve_tags(Adjacency(mesh.topology), mesh.tags, choice.boundary_for(mesh));
  features.weights = choice.weights;
  return features;
}

const Scheme& require_limit(const Scheme& scheme, const Mesh& mesh, std::string_view file) {
  if (!has_exact_limit(scheme))
    throw InputError("{}: the limit surface of {} cannot be evaluated exactly", file, scheme.name);
  naming_file(file, mesh, [&] { require_faces(mesh.topology, scheme); });
  return scheme;
}

}  // namespace

MeshSurface::MeshSurface(Mesh mesh, const SchemeChoice& choice, std::string_view file)
    : file_(file),
      mesh_(std::move(mesh)),
      basis_(mesh_.topology, features_of(mesh_, choice),
             require_limit(*choice.scheme, mesh_, file)),
      surface_(basis_, mesh_.points.span()) {
  if (choice.boundary_for(mesh_) == BoundaryRule::none)
    dropped_ = unsupported_faces(basis_.adjacency(), mesh_.tags);
}

std::vector<FaceId> MeshSurface::visible_faces() const {
  std::vector<bool> hole(static_cast<std::size_t>(mesh_.topology.num_faces()), false);
  for (const FaceId f : mesh_.tags.holes)
    hole[static_cast<std::size_t>(f.value)] = true;
  std::vector<FaceId> faces;
  for (int f = 0; f < mesh_.topology.num_faces(); ++f)
    if (!hole[static_cast<std::size_t>(f)] && has_surface(FaceId(f))) faces.emplace_back(f);
  if (faces.empty())
    throw InputError("{}: no face has a surface: each is a hole or dropped by boundary rule none",
                     file_);
  return faces;
}

}  // namespace limes::app
