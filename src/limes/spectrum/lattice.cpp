#include "limes/spectrum/lattice.h"

#include "limes/core/error.h"

namespace limes {

Lattice lattice(int face_size, Region region, int reach) {
  LIMES_ASSERT(face_size == 3 || face_size == 4);
  const int left = region == Region::quadrant ? 0 : -reach;
  const int bottom = region == Region::plane ? -reach : 0;
  const int width = reach - left + 1, height = reach - bottom + 1;
  const auto at = [&](int i, int j) { return VertexId(i - left + width * (j - bottom)); };
  Lattice result;
  for (int j = bottom; j <= reach; ++j)
    for (int i = left; i <= reach; ++i)
      result.mesh.points.push_back(Vec3(i, j, 0));
  std::vector<VertexId> corners;
  for (int j = bottom; j < reach; ++j)
    for (int i = left; i < reach; ++i) {
      const VertexId a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (face_size == 4)
        corners.insert(corners.end(), {a, b, c, d});
      else
        corners.insert(corners.end(), {a, b, c, a, c, d});
    }
  result.mesh.topology = Topology(width * height, face_size, std::move(corners));
  result.middle = at(0, 0);
  return result;
}

void add_crease(Lattice& lattice, CreaseLine line, float sharpness) {
  const Topology& topology = lattice.mesh.topology;
  const auto on_line = [&](VertexId v) {
    const Vec3& x = lattice.mesh.points[v];
    return x.y() == 0 && (line == CreaseLine::through || x.x() >= 0);
  };
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const VertexId a = face[i], b = face[(i + 1) % face.size()];
      // Every edge of the line once: from the face above.
      if (on_line(a) && on_line(b) && lattice.mesh.points[a].x() < lattice.mesh.points[b].x())
        lattice.mesh.tags.creases.push_back({a, b, sharpness});
    }
  }
}

}  // namespace limes
