#include "limes/subdiv/kobbelt_literal.h"

#include "limes/core/error.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

/// The edge opposite to h in the face on the other side of h.
EdgeId edge_beyond(const Adjacency& mesh, HalfedgeId h) {
  return mesh.edge(mesh.next(mesh.next(mesh.twin(h))));
}

}  // namespace

Mesh refine_literally(const Mesh& closed, double tension) {
  const Adjacency mesh(closed.topology);
  for (int e = 0; e < mesh.num_edges(); ++e)
    if (mesh.is_boundary(EdgeId(e)))
      throw InputError("edge {}-{} is on the boundary; the literal rule is for closed nets",
                       mesh.from(mesh.halfedge(EdgeId(e))).value,
                       mesh.to(mesh.halfedge(EdgeId(e))).value);
  if (!closed.tags.creases.empty())
    throw InputError("the net has creases; the literal rule is for smooth nets");

  RefineOptions options{.levels = 1};
  options.tension = tension;
  Mesh fine = refine(closed, find_scheme("kobbelt"), options);
  const QuadrisectionIds ids = quadrisection_ids(mesh);
  const double omega = tension / 16.0;
  const auto edge_point = [&](EdgeId e) { return fine.points[ids.of_edge(e)]; };
  for (int f = 0; f < closed.topology.num_faces(); ++f) {
    Vec3 sum = Vec3::Zero();  // over both directions
    for (int i = 0; i < 4; ++i) {
      const HalfedgeId side = closed.topology.halfedge(FaceId(f), i);
      sum +=
          (0.5 + omega) * edge_point(mesh.edge(side)) - omega * edge_point(edge_beyond(mesh, side));
    }
    fine.points[ids.of_face(FaceId(f))] = 0.5 * sum;
  }
  return fine;
}

}  // namespace limes
