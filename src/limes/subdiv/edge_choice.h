#pragma once

#include <span>
#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"

namespace limes {

// Which edges of a triangle mesh a binary step splits: at most one of every face. Each function
// returns them ascending by (lower, higher) vertex, the order in which their middles are numbered.

/// Lengths within this part of the longest of their class count as equal.
constexpr double equal_lengths = 1e-9;

/// Algorithm 1 of [velho_quasi48]: the longest edge first, and each chosen edge takes its faces out of
/// the game. A face whose neighbours all chose other edges keeps none.
///
/// Edges of equal length go vertex by vertex - interior vertices before those on the boundary, larger
/// valence first, lower number first - and around a vertex counter-clockwise, from the lowest
/// neighbour or the boundary. The paper says "radially around each vertex"; this order gives all its
/// figures, whatever the numbering.
/// Precondition: faces are triangles, coordinates finite.
[[nodiscard]] std::vector<EdgeId> longest_edges(const Adjacency& mesh,
                                                std::span<const Vec3> points);

/// The edges between vertices of valence 8 of a regular 4-8 mesh, section 2.2 of [velho_quasi48]: every
/// face has one vertex of valence 4 and two of valence 8. Boundary vertices take the place that the
/// faces around them leave.
/// @throws InputError for another mesh, naming a vertex or face that does not fit
[[nodiscard]] std::vector<EdgeId> edges_between_valence_8(const Adjacency& mesh);

/// The edges opposite the first corners, of a mesh that bisect() or four_eight_split() left with the
/// newest vertex there.
[[nodiscard]] std::vector<EdgeId> newest_vertex_edges(const Adjacency& mesh);

}  // namespace limes
