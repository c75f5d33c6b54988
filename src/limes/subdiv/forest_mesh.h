#pragma once

#include "limes/subdiv/closure.h"
#include "limes/subdiv/forest.h"
#include "limes/subdiv/leaf_mesh.h"

namespace limes {

/// The leaves of a forest as a mesh.
///
/// The closure is no part of the forest and is made anew each time; the vertices it needs are those of
/// the next level, and the forest keeps them. Costs as much as the mesh is large.
///
/// Closure of triangles, conforming or triangles: red-green refinement [bank_sherman_weiser_1983]. A leaf
/// with one split side becomes two, with two split sides three, of which two share the shorter
/// diagonal, and with three it is split as the forest would. All three exist on the next level's vertices.
///
/// All-quad closure, for the leaves of a family: where a neighbour of their parent is split twice, the
/// two sides there are split, and the inner side that meets them is, too. Then every leaf has none,
/// two adjacent or four split sides: it stays, becomes three quads (a Y) or four. Leaves that are
/// control faces have no siblings: those with an odd number of split sides are joined in pairs, or to
/// the boundary, by shortest paths across faces whose sides are split as well.
[[nodiscard]] ForestMesh forest_mesh(Forest& forest, Closure closure);

}  // namespace limes
