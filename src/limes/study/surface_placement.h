#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "limes/mesh/seams.h"
#include "limes/problem/surface_settings.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/placement.h"

namespace limes {

// Vertices on exact surfaces, of shells and of meshes alone.

/// What a vertex lies on, in the order of the file.
using SurfaceList = std::vector<const GeometrySettings*>;
using Edge = std::array<VertexId, 2>;

/// Of each face the exact surface of its part; none: it has no exact surface.
/// @throws InputError naming a part that the mesh does not have
[[nodiscard]] std::vector<const GeometrySettings*> geometry_of_faces(
    const SurfaceSettings& settings, const Mesh& mesh);

/// The edges that the seams tie in the control mesh, and those of its junctions if they are tied.
/// @throws InputError with the seam's line: a part that is not there, a part that touches no other of
///         its seam, or as tie_parts()
[[nodiscard]] std::vector<TiedEdge> seams_of(const SurfaceSettings& settings, const Mesh& control);

/// The same edges after `levels` quadrisections.
[[nodiscard]] std::vector<TiedEdge> refined_seams(const Mesh& control, std::vector<TiedEdge> edges,
                                                  int levels);

/// The edges that follow each of the curves, after `levels` quadrisections.
/// @throws InputError for a curve without any
[[nodiscard]] std::vector<std::vector<Edge>> curve_edges(const SurfaceSettings& settings,
                                                         const Mesh& control, int levels);

/// What edges of a forest's control mesh have become in a mesh of the forest.
[[nodiscard]] std::vector<Edge> parts_of_edges(const Forest& forest, const ForestMesh& mesh,
                                               const std::vector<Edge>& edges);

/// @pre there is a surface
/// @throws InputError naming a face without one
void require_surfaces(const SurfaceSettings& settings, const Mesh& mesh);

/// What every vertex must lie on: the surfaces of the parts that it belongs to or is tied to, and its
/// curves. Empty for vertices without faces.
[[nodiscard]] std::vector<SurfaceList> surfaces_of_vertices(
    const SurfaceSettings& settings, const Mesh& mesh, const std::vector<TiedEdge>& tied,
    const std::vector<std::vector<Edge>>& curves);

/// The point of all surfaces near x; x if there is none.
/// @throws InputError "FILE:LINE: ..." if they do not meet near x, or beyond the largest number
[[nodiscard]] Vec3 placed(const SurfaceList& surfaces, const Vec3& x);

/// @param geometry  of each face, as geometry_of_faces()
/// @param name      of a face of the mesh in messages: "face 3"
/// @throws InputError with the surface's place for a face without area: its vertices came to one point of
///         the surface, or onto one curve
void require_faces_with_area(const Mesh& mesh, std::span<const GeometrySettings* const> geometry,
                             const std::function<std::string(FaceId)>& name);

/// Puts the vertices of a control mesh where they must lie.
/// @throws InputError for a face without exact surface, a vertex that cannot be placed, or a face that has
///         lost its area
void place_control(const SurfaceSettings& settings, Mesh& control);

/// Puts the new vertices of a forest, which lie halfway between others, onto the surfaces: bitwise where
/// uniform refinement puts them, with quads' centres as between_sides().
/// @param control   not needed any more afterwards
/// @param levels    the forest's control mesh is this one after as many quadrisections, all placed
/// @param settings  must outlive the placement
/// @throws InputError as place_control(), also from the placement
[[nodiscard]] Placement exact_placement(const SurfaceSettings& settings, const Mesh& control,
                                        int levels = 0);

}  // namespace limes
