#include "limes/mesh/topology.h"

#include <algorithm>
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

FaceId Topology::face_of(HalfedgeId h) const {
  if (face_size_) return FaceId(h.value / face_size_);
  const auto after = std::upper_bound(offsets_.begin(), offsets_.end(), h.value);
  return FaceId(after - offsets_.begin() - 1);
}

HalfedgeId Topology::next(HalfedgeId h) const {
  const FaceId f = face_of(h);
  const HalfedgeId start = halfedge(f, 0);
  return h.value + 1 < start.value + face_size(f) ? HalfedgeId(h.value + 1) : start;
}

}  // namespace limes
