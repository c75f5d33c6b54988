#include "limes/subdiv/hanging_faces.h"

#include <map>
#include <utility>

namespace limes {

HalfedgeId HangingFaces::inside(FaceId face, int i) const {
  const int next = i < 3 ? corner(face, i + 1).value
                         : topology.halfedge(face, 0).value + topology.face_size(face);
  const int after = corner(face, i).value + 1;
  return after < next ? HalfedgeId(after) : HalfedgeId();
}

int HangingFaces::side(FaceId face, HalfedgeId h) const {
  int i = 3;
  while (h < corner(face, i))
    --i;
  return i;
}

HangingFaces hanging_faces(const Topology& quads, std::span<const HangingVertex> hanging) {
  // The ends are in the order of the face in whose side the vertex hangs.
  std::map<std::pair<VertexId, VertexId>, VertexId> inside;
  for (const HangingVertex& h : hanging)
    inside[{h.ends[0], h.ends[1]}] = h.vertex;
  HangingFaces out;
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (int f = 0; f < quads.num_faces(); ++f) {
    const auto face = quads.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      out.corners.push_back(HalfedgeId(corners.size()));
      corners.push_back(face[i]);
      const auto at = inside.find({face[i], face[(i + 1) % face.size()]});
      if (at != inside.end()) corners.push_back(at->second);
    }
    offsets.push_back(static_cast<int>(corners.size()));
  }
  out.topology = hanging.empty()
                     ? quads
                     : Topology(quads.num_vertices(), std::move(offsets), std::move(corners));
  return out;
}

}  // namespace limes
