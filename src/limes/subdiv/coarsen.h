#pragma once

#include <string>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/subdiv/refine.h"

namespace limes {

struct CoarsenOptions {
  std::string_view scheme = "catmull-clark";  ///< or an interpolatory scheme of quads
  RefineOptions refine = {};  ///< how the mesh was refined; tension and corners count
  /// Largest distance between the mesh and the refined result, as part of the diagonal; a mesh that
  /// is farther from being refined is refused. Files with six decimals need about 1e-6.
  double tolerance = 1e-6;
};

struct CoarsenResult {
  Mesh mesh;
  double residual;  ///< largest distance between the given mesh and the refined result
  /// What could not be carried over exactly, one sentence each.
  std::vector<std::string> remarks;
};

/// Undoes one step of Catmull-Clark subdivision, see docs/theory/coarsen.md: finds out which vertices
/// were old ones, edge points and face points, then solves S x = y with the operator S of the coarse
/// mesh; of an interpolatory scheme, drops the new vertices. Faces of any size, boundaries, creases, corners and several components; the numbering of
/// vertices and faces does not matter, but if it is the one refine() makes, the coarse mesh has its
/// numbering back. Creases and corners become sharper by one again; what had a sharpness of 1 or
/// less left no tag and cannot be found again.
/// @throws InputError for a mesh that is not refined, naming the vertex or face where that shows and
///         by how much, and for one whose coarse positions are not unique
[[nodiscard]] CoarsenResult coarsen(const Mesh& mesh, const CoarsenOptions& options = {});

}  // namespace limes
