#include "limes/mesh/topology.h"

#include <utility>

#include "limes/core/error.h"

namespace limes {

Topology::Topology(int num_vertices, int face_size, std::vector<VertexId> corners)
    : num_vertices_(num_vertices), face_size_(face_size), corners_(std::move(corners)) {
  LIMES_ASSERT(face_size > 0 && corners_.size() % static_cast<std::size_t>(face_size) == 0);
  num_faces_ = num_corners() / face_size;
}

Topology::Topology(int num_vertices, std::vector<int> offsets, std::vector<VertexId> corners)
    : num_vertices_(num_vertices), offsets_(std::move(offsets)), corners_(std::move(corners)) {
  LIMES_ASSERT(!offsets_.empty() && offsets_.front() == 0 && offsets_.back() == num_corners());
  num_faces_ = static_cast<int>(offsets_.size()) - 1;
  bool uniform = num_faces_ > 0;
  for (int f = 0; f < num_faces_; ++f) {
    LIMES_ASSERT(offset(f) < offset(f + 1));
    uniform = uniform && offset(f + 1) - offset(f) == offset(1);
  }
  if (uniform) {
    face_size_ = offset(1);
    offsets_ = {};
  }
}

}  // namespace limes
