#include "limes/mesh/duplicates.h"

#include <algorithm>
#include <array>

namespace limes {
namespace {

/// A face as it is written from its lowest vertex towards the lower neighbour of that vertex.
struct CanonicalFace {
  FaceId face;
  bool reversed;
  std::span<const VertexId> corners;
};

bool same_corners(const CanonicalFace& a, const CanonicalFace& b) {
  return std::equal(a.corners.begin(), a.corners.end(), b.corners.begin(), b.corners.end());
}

/// Writes the corners in canonical order to `out`; true if that turned them around.
bool write_canonical(std::span<const VertexId> face, VertexId* out) {
  const auto lowest = std::min_element(face.begin(), face.end());
  std::rotate_copy(face.begin(), lowest, face.end(), out);
  const bool reversed = face.size() > 2 && out[face.size() - 1] < out[1];
  if (reversed) std::reverse(out + 1, out + face.size());
  return reversed;
}

std::vector<CanonicalFace> canonical_faces(const Topology& topology,
                                           std::vector<VertexId>& storage) {
  std::vector<CanonicalFace> faces;
  storage.resize(static_cast<std::size_t>(topology.num_corners()));
  std::vector<VertexId> scratch;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    if (repeated_vertex(face, scratch).valid()) continue;
    VertexId* const out = storage.data() + topology.halfedge(FaceId(f), 0).value;
    const bool reversed = write_canonical(face, out);
    faces.push_back({FaceId(f), reversed, {out, face.size()}});
  }
  return faces;
}

}  // namespace

VertexId repeated_vertex(std::span<const VertexId> face, std::vector<VertexId>& scratch) {
  if (face.size() <= 8) {  // comparing pairs beats sorting
    for (std::size_t i = 1; i < face.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (face[i] == face[j]) return face[i];
    return {};
  }
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end());
  const auto twice = std::adjacent_find(scratch.begin(), scratch.end());
  return twice == scratch.end() ? VertexId() : *twice;
}

DuplicateFaces find_duplicate_faces(const Topology& topology) {
  std::vector<VertexId> storage;
  auto faces = canonical_faces(topology, storage);
  std::sort(faces.begin(), faces.end(), [](const CanonicalFace& a, const CanonicalFace& b) {
    if (same_corners(a, b)) return a.face < b.face;
    return std::lexicographical_compare(a.corners.begin(), a.corners.end(), b.corners.begin(),
                                        b.corners.end());
  });
  DuplicateFaces found;
  std::array<FaceId, 2> firsts;  // with the present corners: as sorted, reversed
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i == 0 || !same_corners(faces[i - 1], faces[i])) firsts = {};
    FaceId& first = firsts[faces[i].reversed ? 1 : 0];
    const FaceId opposite = firsts[faces[i].reversed ? 0 : 1];
    if (first.valid())
      found.same_order.push_back({first, faces[i].face});
    else if (opposite.valid())
      found.opposite_order.push_back({opposite, faces[i].face});
    if (!first.valid()) first = faces[i].face;
  }
  const auto by_later = [](const FacePair& a, const FacePair& b) { return a.later < b.later; };
  std::sort(found.same_order.begin(), found.same_order.end(), by_later);
  std::sort(found.opposite_order.begin(), found.opposite_order.end(), by_later);
  return found;
}

}  // namespace limes
