#pragma once

#include <span>
#include <vector>

#include "limes/mesh/topology.h"

namespace limes {

struct FacePair {
  FaceId earlier, later;
};

/// Faces with the corners of an earlier face, wherever the list of corners begins. A face is paired
/// with the first that has its corners in its order, else with the first in opposite order. Faces
/// that use a vertex twice are left out. Ascending by the later face.
struct DuplicateFaces {
  std::vector<FacePair> same_order;
  std::vector<FacePair> opposite_order;
};
[[nodiscard]] DuplicateFaces find_duplicate_faces(const Topology& topology);

/// A vertex that the face uses at two corners, or an invalid one. `scratch` saves allocations.
[[nodiscard]] VertexId repeated_vertex(std::span<const VertexId> face,
                                       std::vector<VertexId>& scratch);

}  // namespace limes
