#pragma once

#include <span>
#include <vector>

#include "limes/mesh/seams.h"
#include "limes/subdiv/forest_mesh.h"

namespace limes {

/// Splits leaves on one side of a seam where those on the other are split, until both sides have the
/// same edges in any mesh with a closure. Any number of parts may meet.
/// @param seams  edges of the control mesh; the control faces there are split, or none of them are
void match_seams(Forest& forest, std::span<const TiedEdge> seams);

/// The edges that are tied in a mesh of the forest. Precondition: match_seams().
[[nodiscard]] std::vector<TiedEdge> tied_edges(const Forest& forest, const ForestMesh& mesh,
                                               std::span<const TiedEdge> seams);

}  // namespace limes
