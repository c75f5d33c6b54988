#pragma once

#include <vector>

#include "limes/mesh/seams.h"
#include "limes/study/problem.h"
#include "limes/subdiv/forest_mesh.h"

namespace limes {

using Edge = std::array<VertexId, 2>;

/// Of each face the exact surface of its part; none: it has no exact surface.
/// @throws InputError naming a part that the mesh does not have
[[nodiscard]] std::vector<const GeometrySettings*> geometry_of_faces(const Problem& problem,
                                                                     const Mesh& mesh);

/// The edges that the problem's seams tie in the control mesh.
/// @throws InputError with the seam's line: a part that is not there, a part that touches no other of
///         its seam, or as tie_parts()
[[nodiscard]] std::vector<TiedEdge> seams_of(const Problem& problem, const Mesh& control);

/// The same edges after `levels` quadrisections.
[[nodiscard]] std::vector<TiedEdge> refined_seams(const Mesh& control, std::vector<TiedEdge> edges,
                                                  int levels);

/// The edges that follow each of the problem's curves, after `levels` quadrisections.
/// @throws InputError for a curve without any
[[nodiscard]] std::vector<std::vector<Edge>> curve_edges(const Problem& problem,
                                                         const Mesh& control, int levels);

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

/// The same for the vertices of a forest, bitwise, which takes vertices halfway between others.
/// @param control  as in the file; not needed any more afterwards
/// @param levels   the forest is that on refined_on_surfaces(problem, control, levels)
/// @param problem  must outlive the placement
/// @throws InputError as above, also from the placement
[[nodiscard]] Placement exact_placement(const Problem& problem, const Mesh& control, int levels);

/// @throws InputError naming two tied vertices of the refined mesh that are not in one place
void require_coincident(const Problem& problem, const Mesh& mesh,
                        const std::vector<TiedEdge>& edges, double diagonal);

}  // namespace limes
