#pragma once

#include "limes/mesh/mesh.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Whether a scheme can start from a mesh.
inline bool fits(const Scheme& scheme, const Mesh& mesh) {
  if (scheme.faces == FaceKind::polygons) return true;
  return mesh.topology.uniform_face_size() == (scheme.faces == FaceKind::quads ? 4 : 3);
}

}  // namespace limes
