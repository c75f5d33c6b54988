#pragma once

#include "limes/adapt/residual.h"
#include "limes/study/plane_model.h"

namespace limes {

/// The loads of a plane problem, of elasticity or Poisson's equation, at single points, as
/// assemble_loads() and poisson_loads() integrate them; without forces at vertices. A side is held
/// where supports hold both of its ends. The model must outlive it.
/// @throws InputError when called, for a formula without a value
[[nodiscard]] LoadDensity load_density(const PlaneModel& model);

}  // namespace limes
