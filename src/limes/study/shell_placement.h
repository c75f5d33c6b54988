#pragma once

#include <vector>

#include "limes/mesh/seams.h"
#include "limes/problem/problem.h"
#include "limes/study/surface_placement.h"
#include "limes/subdiv/forest_mesh.h"

namespace limes {

/// Vertices halfway between others (of quads see between_sides()), then on the exact surface of their
/// part, level by level: on a seam on those of all parts there, on a [[curve]] on that as well. Then the
/// shapes of elements are optimised as [mesh] says.
/// @throws InputError for a face without exact surface, or a vertex that cannot be placed
[[nodiscard]] Mesh refined_on_surfaces(const Problem& problem, Mesh mesh, int levels);

/// The same for a mesh whose vertices are placed and stay where they are; nothing is smoothed.
/// @param tied    its edges on seams
/// @param curves  its edges that follow each of the problem's curves
[[nodiscard]] Mesh refined_on_surfaces(const Problem& problem, Mesh mesh, int levels,
                                       std::vector<TiedEdge> tied,
                                       std::vector<std::vector<Edge>> curves);

/// What edges of the control mesh of a forest have become in its mesh, such as those of curve_edges().
[[nodiscard]] std::vector<std::vector<Edge>> edges_in_forest(
    const Forest& forest, const ForestMesh& mesh, const std::vector<std::vector<Edge>>& control);

/// Areas that faces should have after `levels` quadrisections: equal parts of those of the control faces.
[[nodiscard]] std::vector<double> wanted_areas(const Mesh& control, int levels);

/// Optimises the shapes of elements of a mesh of a forest as [mesh] smoothing says; nothing if no face is
/// refined.
/// @param areas   that the faces of the forest's control mesh should have, see wanted_areas()
/// @param tied    its edges on seams
/// @param curves  edges of the control mesh, see curve_edges()
void smooth_on_surfaces(const Problem& problem, const Forest& forest,
                        const std::vector<double>& areas,
                        const std::vector<std::vector<Edge>>& curves,
                        const std::vector<TiedEdge>& tied, ForestMesh& mesh);

/// Puts the vertices that a split of every face of a mesh with hanging vertices adds where they lie on exact
/// surfaces; the others stay where that mesh has them.
/// @param coarse    of a forest, with vertices anywhere on their surfaces
/// @param surfaces  what every vertex of `split` lies on
/// @param split     of the same forest with every leaf split once
void place_children(const ForestMesh& coarse, const std::vector<SurfaceList>& surfaces,
                    ForestMesh& split);

/// @throws InputError naming two tied vertices of the refined mesh that are not in one place
void require_coincident(const Problem& problem, const Mesh& mesh,
                        const std::vector<TiedEdge>& edges, double diagonal);

}  // namespace limes
