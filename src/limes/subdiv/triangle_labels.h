#pragma once

#include <string>
#include <vector>

#include "limes/subdiv/quadrisection_labels.h"

namespace limes {

// QuadrisectionLabels for triangles, each of which was split into four: three children with an old
// vertex and two edge points, and one in the middle with three edge points.

/// Labels one component; forgets earlier labels of it.
/// @param first  corner of the component's first face that is an old vertex, or 3: it is in the middle
/// @return empty, or why there is no such labelling: one sentence that names a vertex or face
[[nodiscard]] std::string label_triangles(const Adjacency& adjacency,
                                          const std::vector<FaceId>& component, int first,
                                          VertexOrigins& origins);

/// unsplit() for triangles: a coarse face for every middle one, in their order; its first corner is
/// the old vertex beyond the middle's last side, as refine() numbers them. No face points.
[[nodiscard]] Unsplit unsplit_triangles(const Adjacency& adjacency, const VertexOrigins& origins,
                                        const std::vector<FaceId>& faces, bool all_vertices);

}  // namespace limes
