#pragma once

#include "limes/mesh/mesh.h"
#include "limes/subdiv/breakpoints.h"
#include "limes/subdiv/quasi_four_eight.h"
#include "limes/subdiv/scheme.h"

namespace limes {

struct RefineOptions {
  int levels = 1;
  BoundaryRule boundary = BoundaryRule::edges;  ///< of Boundary::creases
  /// Boundary stencils of [biermann_2000], see sector.h; catmull-clark only.
  bool sector_stencils = false;
  QuasiOptions quasi = {};                    ///< of quasi-four-eight; its levels do not count
  CornerRule corners = CornerRule::by_angle;  ///< of Boundary::open_net
  double tension = 1.0;                       ///< of schemes that have one
  ExtraordinaryWeights weights = ExtraordinaryWeights::standard;  ///< catmull-clark, loop
};

/// The features of a control mesh as a scheme works with them: its tags, breakpoints and options.
/// @throws InputError as resolve_tags()
[[nodiscard]] Features control_features(const Adjacency& adjacency, const Mesh& mesh,
                                        const Scheme& scheme, const RefineOptions& options);

/// Uniform refinement of a mesh with its tags, groups and parts. With BoundaryRule::none the faces
/// that touch the boundary shape the others and are then left out. Faces that a dual scheme makes
/// across edges and around vertices belong where one of the faces there does.
/// @throws InputError for a mesh that cannot be refined (see mesh/defects.h), or that the scheme does
///         not fit
[[nodiscard]] Mesh refine(const Mesh& mesh, const Scheme& scheme, const RefineOptions& options);

}  // namespace limes
