#include "limes/fem/material.h"

#include <cmath>

namespace limes {

Mat3 plane_elasticity_matrix(const Isotropic& material, PlaneAssumption model) {
  const double E = material.young;
  const double nu = material.poisson;
  Mat3 C;
  if (model == PlaneAssumption::stress) {
    C << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
    return E / (1 - nu * nu) * C;
  }
  C << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, (1 - 2 * nu) / 2;
  return E / ((1 + nu) * (1 - 2 * nu)) * C;
}

double von_mises(const Vec3& stress, const Isotropic& material, PlaneAssumption model) {
  const double x = stress(0);
  const double y = stress(1);
  const double z = model == PlaneAssumption::strain ? material.poisson * (x + y) : 0.0;
  const double shear = stress(2);
  return std::sqrt(0.5 * ((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) +
                   3.0 * shear * shear);
}

}  // namespace limes
