#pragma once

#include <algorithm>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Whether a dual split can make faces around all interior vertices, and keeps any face.
inline bool has_dual(const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  bool any_interior = false;
  for (int i = 0; i < mesh.topology.num_vertices(); ++i) {
    const VertexId v(i);
    if (!adjacency.ring_start(v).valid() || adjacency.is_boundary(v)) continue;
    if (adjacency.num_ring_faces(v) < 3) return false;
    any_interior = true;
  }
  return any_interior;
}

/// Whether a scheme can start from a mesh.
inline bool fits(const Scheme& scheme, const Mesh& mesh) {
  if ((scheme.split == Split::dual || scheme.split == Split::mid_edge) && !has_dual(mesh))
    return false;
  if (!scheme.creases && !(mesh.tags.creases.empty() && mesh.tags.corners.empty())) return false;
  const auto semi_sharp = [](const auto& tag) { return tag.sharpness < infinite_sharpness; };
  if (scheme.boundary == Boundary::open_net &&
      (std::any_of(mesh.tags.creases.begin(), mesh.tags.creases.end(), semi_sharp) ||
       std::any_of(mesh.tags.corners.begin(), mesh.tags.corners.end(), semi_sharp)))
    return false;
  if (scheme.faces == FaceKind::polygons) return true;
  return mesh.topology.uniform_face_size() == (scheme.faces == FaceKind::quads ? 4 : 3);
}

inline bool is_closed(const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  for (int e = 0; e < adjacency.num_edges(); ++e)
    if (adjacency.is_boundary(EdgeId(e))) return false;
  return true;
}

}  // namespace limes
