#pragma once

#include <string>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes {

struct RepairResult {
  Mesh mesh;
  /// One sentence for each thing done, with the faces and vertices of the given mesh; empty: the
  /// mesh is unchanged.
  std::vector<std::string> done;
};

/// Mends what can be mended without inventing shape, in this order: leaves out tags on what does not
/// exist; leaves out faces that repeat another corner for corner; turns faces around so that
/// neighbours run alike (the larger part of each piece stays); gives each fan of faces at a bow-tie
/// vertex its own vertex (the first fan keeps the old one, the others come after all vertices);
/// removes vertices of no face. Positions, the first corner of every face, groups, parts, face lines
/// and tags are kept; creases and corners follow to every copy of their vertices.
/// What it cannot mend is left: find_defects() on the result tells.
/// @throws InputError for a piece with one side (Moebius strip) and for corners without a vertex
[[nodiscard]] RepairResult repair(const Mesh& mesh);

}  // namespace limes
