#pragma once

#include "limes/adapt/zienkiewicz_zhu.h"
#include "limes/study/plane_model.h"

namespace limes {

/// Squared errors of the faces by the estimator that [adapt] names.
/// @param energy  of the solution
[[nodiscard]] std::vector<double> estimate_error(const PlaneModel& model,
                                                 const EnergyDensity& energy);

}  // namespace limes
