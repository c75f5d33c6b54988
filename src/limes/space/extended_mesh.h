#pragma once

#include <span>
#include <vector>

#include "limes/core/types.h"
#include "limes/subdiv/features.h"

namespace limes {

/// The mesh that carries a field: the control mesh, and beyond its boundary one ring of ghost faces
/// whose vertices are further degrees of freedom ("free ghosts").
///
/// The standard boundary of a Catmull-Clark surface makes the second normal derivative of *every*
/// function vanish there, which caps the convergence of a field at 2.5 / 1.5 in L2 / H1. With free
/// ghosts a boundary vertex is an interior vertex of the field's mesh, so the field is any spline;
/// the geometry, for which ghost = 2 b - c, is one of them (docs/theory/boundary.md).
///
///      g---g---g       k faces meet at a boundary vertex b of the control mesh. Ghost faces make it
///      |   |   |       regular: k = 2 (one side of a straight boundary) gets 2, a sharp corner with
///    --b---b---b--     k = 1 gets 3, a sharp re-entrant corner with k = 3 gets 1.
///      |   |   |
///      c   c   c       Where that cannot be, or where the geometry would not be in the space any
///                      more, the standard functions stay: the two boundary edges at such a vertex
///                      and at its boundary neighbours are creases of the field.
struct ExtendedMesh {
  Topology topology;  ///< first the vertices and faces of the control mesh, same numbers
  Features features;  ///< sharpness for the field
  int num_control_vertices = 0;
  int num_control_faces = 0;

  /// A ghost's position when the geometry is continued: 2 b - c, or its tensor product at a corner.
  struct Continuation {
    std::vector<std::pair<VertexId, double>> sources;  ///< control vertices and weights
  };
  std::vector<Continuation> ghosts;  ///< of vertex num_control_vertices + i

  /// Control vertices on the boundary that keep the standard functions.
  std::vector<VertexId> standard_vertices;

  /// Values at all vertices, from values at the control vertices.
  [[nodiscard]] std::vector<Vec3> continued(std::span<const Vec3> control) const;
};

/// The field's mesh without ghosts: the control mesh itself ("phantom" boundary, the standard
/// functions of the scheme everywhere).
[[nodiscard]] ExtendedMesh without_ghosts(const Adjacency& control, const Features& features);

/// The field's mesh with free ghosts.
/// @param points  control points; a re-entrant corner is made regular only if they are continued
///                exactly by the regular functions there
[[nodiscard]] ExtendedMesh with_ghosts(const Adjacency& control, const Features& features,
                                       std::span<const Vec3> points);

}  // namespace limes
