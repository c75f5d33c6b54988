#pragma once

#include <functional>
#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"
#include "limes/subdiv/leaf_mesh.h"

namespace limes {

/// Where the vertices of a mesh may go.
struct Sliding {
  /// Of a vertex at x the unit directions, orthogonal to each other, in which it may move: as columns,
  /// two on a surface, one on a curve, none if it stays.
  std::function<Eigen::Matrix<double, 3, Eigen::Dynamic>(VertexId v, const Vec3& x)> directions;
  /// The place near x that it may take.
  std::function<Vec3(VertexId v, const Vec3& x)> placed;
};

struct SmoothingResult {
  int sweeps = 0;
  double worst_before = 0, worst_after = 0;  ///< largest distortion of a corner
};

/// Distortion of a quad's corner with the sides a and b: (|a|^2 + |b|^2) / (2 a x b . n), the condition
/// number of the corner's Jacobian [knupp_2000]: 1 for a square, above in any other corner, infinite
/// if it is flat or turned over.
[[nodiscard]] double corner_distortion(const Vec3& a, const Vec3& b, const Vec3& normal);

/// Largest distortion of any corner, seen along the normals of the faces.
[[nodiscard]] double worst_distortion(const Mesh& quads);

/// Of every face, whatever its number of corners.
[[nodiscard]] std::vector<double> face_areas(const Mesh& mesh);

/// Optimises the shapes of elements: moves each vertex in turn so that the sum over the corners that it
/// is part of, of
///     distortion * ((|a|^2 + |b|^2) / area)^2,
/// becomes less, by a Newton step in its directions, shortened until it does. The second factor is
/// what keeps sizes: distortions alone are least in conformal meshes, whose faces at a border's corner
/// grow without bound. No sum grows and no corner turns over; vertices of corners that are turned over
/// stay. Ends after `sweeps` rounds, or when no vertex moves by a thousandth of its longest side.
///
/// @param areas  that the faces should have, > 0; only their ratios count
/// @param node   the lowest vertex that each is tied to, which move together; see tied_nodes()
/// @param hanging  vertices inside sides, which do not move by themselves: they stay in the middle of the ends
///                 of their sides, as `placed` puts it, and the faces there count for these ends. Not tied;
///                 their ends do not hang.
/// Serial, in order of the vertices: the result does not depend on threads.
/// @pre all faces are quads
SmoothingResult improve_shapes(Mesh& quads, const std::vector<double>& areas,
                               const IdArray<VertexId, VertexId>& node, const Sliding& sliding,
                               int sweeps, std::span<const HangingVertex> hanging = {});

}  // namespace limes
