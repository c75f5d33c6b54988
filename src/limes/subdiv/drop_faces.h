#pragma once

#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"

namespace limes {

/// The faces that BoundaryRule::none leaves out: those with a boundary vertex, except where both
/// boundary edges there are tagged infinitely sharp, as in OpenSubdiv.
[[nodiscard]] std::vector<bool> unsupported_faces(const Adjacency& adjacency, const Tags& tags);

/// The mesh without the faces that are marked, and without the vertices that no face uses then. The
/// order of the others stays.
[[nodiscard]] Mesh without_faces(const Mesh& mesh, const std::vector<bool>& drop);

}  // namespace limes
