#pragma once

#include "limes/core/types.h"

namespace limes {

enum class PlaneAssumption { stress, strain };

struct Isotropic {
  double young = 1;    ///< > 0
  double poisson = 0;  ///< in (-1, 1/2)
};

/// Elasticity matrix of a plane model: stress = C strain in Voigt order xx, yy, xy with engineering
/// shear strain.
[[nodiscard]] Mat3 plane_elasticity_matrix(const Isotropic& material, PlaneAssumption model);

/// Von Mises stress from stresses in Voigt order; in plane strain with sigma_zz = nu (xx + yy).
[[nodiscard]] double von_mises(const Vec3& stress, const Isotropic& material,
                               PlaneAssumption model);

}  // namespace limes
