#include "limes/study/error_estimate.h"

#include "limes/adapt/residual.h"
#include "limes/study/load_density.h"

namespace limes {

std::vector<double> estimate_error(const PlaneModel& model, const EnergyDensity& energy) {
  const EstimatorKind kind =
      model.problem.adapt ? model.problem.adapt->estimator : EstimatorKind::zienkiewicz_zhu;
  const HangingFaces* const hanging = model.closed ? &model.closed->faces : nullptr;
  if (kind == EstimatorKind::residual)
    return residual_estimate(*model.space, energy, load_density(model), hanging);
  return zienkiewicz_zhu(*model.space, energy, model.same_material(), hanging);
}

}  // namespace limes
