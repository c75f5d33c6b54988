#include "boundary_faces.h"

#include <algorithm>
#include <cstdint>

namespace limes::app {

std::vector<bool> boundary_faces(const Adjacency& adjacency) {
  const Topology& topology = adjacency.topology();
  std::vector<bool> result;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    result.push_back(std::any_of(face.begin(), face.end(),
                                 [&](VertexId v) { return adjacency.is_boundary(v); }));
  }
  return result;
}

std::vector<bool> children_of_marked(const Topology& topology, const std::vector<bool>& marked,
                                     int levels) {
  if (levels == 0) return marked;
  const std::int64_t per_corner = std::int64_t{1} << (2 * (levels - 1));
  std::vector<bool> result;
  for (int f = 0; f < topology.num_faces(); ++f)
    result.insert(result.end(),
                  static_cast<std::size_t>(topology.face_size(FaceId(f)) * per_corner),
                  marked[static_cast<std::size_t>(f)]);
  return result;
}

}  // namespace limes::app
