#pragma once

#include "limes/study/plane_model.h"

namespace limes {

/// A vertex at which a support gives the solution.
struct HeldVertex {
  int dof;
  double value;
  int support;  ///< the first of those that hold it
};

/// @throws InputError for a face that is no quad, a piece of the mesh without a held vertex, a vertex
///         with two values, a formula without a value
[[nodiscard]] std::vector<HeldVertex> held_vertices(const PlaneModel& model);

/// Sources on faces and fluxes along boundary sides together, one entry per dof.
/// @throws InputError for selections that meet nothing, and formulas without a value
[[nodiscard]] VectorX poisson_loads(const PlaneModel& model);

/// Degree of freedom of a vertex, which is the field's value there; -1 if only holes have it.
/// Precondition: the scheme is `linear`, in one region.
[[nodiscard]] int dof_of_vertex(const SubdivisionSpace& space, VertexId v);

}  // namespace limes
