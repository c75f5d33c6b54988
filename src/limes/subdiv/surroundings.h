#pragma once

#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"

namespace limes {

/// The faces that have one of some vertices as a corner, ascending.
[[nodiscard]] std::vector<FaceId> faces_around(const Adjacency& adjacency,
                                               std::span<const VertexId> vertices);

/// These faces with their edges and corners, each list ascending: what the rules of one step of
/// reach one make of the vertices.
struct SurroundedElements {
  std::vector<FaceId> faces;
  std::vector<EdgeId> edges;
  std::vector<VertexId> vertices;  ///< also those of the given vertices that have no face
};
[[nodiscard]] SurroundedElements surrounded_by(const Adjacency& adjacency,
                                               std::span<const VertexId> vertices);

}  // namespace limes
