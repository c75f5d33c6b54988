#pragma once

#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"
#include "limes/mesh/seams.h"

namespace limes {

struct CutMesh {
  Mesh mesh;
  int num_edges = 0;  ///< that were cut
};

/// Cuts a mesh along its junctions, the edges with three faces or more, so that what remains are surfaces
/// with boundaries there. Faces stay as they are; each fan of faces at an end of such an edge has a vertex
/// of its own: the first one the old vertex, the others follow after all vertices, in order of the
/// corners. Where junctions end or branch the boundaries get infinitely sharp corners, so that schemes
/// bend all of them alike. Fans that touch a junction with a corner only are left, for find_defects(); so
/// is a mesh with repeated faces or corners without a vertex.
/// @throws InputError naming a junction of one edge with both ends inside a piece, which it does not cut
[[nodiscard]] CutMesh cut_junctions(const Mesh& mesh);

/// Boundary edges that lie in the same place as two others at least, each tied to all others there: those
/// of cut_junctions(), and those of faces that had vertices of their own. Places are compared by bits.
[[nodiscard]] std::vector<TiedEdge> junction_edges(const Mesh& mesh, const Adjacency& adjacency);

}  // namespace limes
