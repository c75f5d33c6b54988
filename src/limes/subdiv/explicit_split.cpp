#include "limes/subdiv/explicit_split.h"

#include <algorithm>
#include <limits>

#include "limes/core/error.h"
#include "limes/subdiv/splits.h"

namespace limes {

void require_numbers(std::int64_t num_vertices, std::int64_t num_faces, int face_size) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (std::max(num_vertices, face_size * num_faces) > most)
    throw InputError("refinement would have {} faces; at most {} can be numbered", num_faces,
                     most / face_size);
}

ExplicitSplit explicit_split(const Adjacency& parent, const Features& features, Split split) {
  switch (split) {
    case Split::dual:
      return dual_split(parent);
    case Split::mid_edge:
      return mid_edge_split(parent);
    case Split::sqrt3:
      return sqrt3_split(parent, features.level % 2 == 1);
    case Split::four_eight:
      return four_eight_split(parent, features.level);
    case Split::quads:
    case Split::triangles:
    case Split::longest_edges:
      break;
  }
  LIMES_ASSERT(!"made elsewhere");
  return {};
}

}  // namespace limes
