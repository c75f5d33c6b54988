#include "limes/limit/grid_block.h"

namespace limes {
bool is_regular(const Adjacency& mesh, const Sharpness& sharpness, VertexId v) {
  const HalfedgeId start = mesh.ring_start(v);
  HalfedgeId h = start;
  for (int i = 0; i < 4; ++i) {
    if (!mesh.twin(h).valid() || sharpness.edge(mesh.edge(h)) > 0) return false;
    if (mesh.topology().face_size(mesh.face(h)) != 4) return false;
    h = mesh.ring_next(h);
    if (!h.valid() || (h == start) != (i == 3)) return false;
  }
  return true;
}

std::optional<GridBlock> grid_block(const Adjacency& mesh, const Sharpness& sharpness, FaceId f) {
  const auto regular_face = [&](HalfedgeId h) {
    for (int i = 0; i < 4; ++i, h = mesh.next(h))
      if (!is_regular(mesh, sharpness, mesh.from(h))) return false;
    return true;
  };
  const GridWalk walk(mesh);
  const HalfedgeId middle = mesh.topology().halfedge(f, 0);
  if (mesh.topology().face_size(f) != 4 || !regular_face(middle)) return {};
  // The 3 x 3 faces exist now; with their vertices regular, so do the 5 x 5.
  const HalfedgeId low = walk.left(walk.down(middle));
  HalfedgeId line = low;
  for (int j = 0; j < 3; ++j) {
    if (j > 0) line = walk.up(line);
    for (const HalfedgeId h : {line, walk.right(line), walk.right(walk.right(line))})
      if (!regular_face(h)) return {};
  }
  GridBlock block;
  line = walk.left(walk.down(low));
  for (std::size_t j = 0; j < 5; ++j) {
    if (j > 0) line = walk.up(line);
    HalfedgeId h = line;
    for (std::size_t i = 0; i < 5; ++i) {
      if (i > 0) h = walk.right(h);
      const std::size_t at = 6 * j + i;
      block[at] = mesh.from(h);
      block[at + 1] = mesh.to(h);
      block[at + 6] = mesh.from(mesh.prev(h));
      block[at + 7] = mesh.to(mesh.next(h));
    }
  }
  return block;
}

}  // namespace limes
