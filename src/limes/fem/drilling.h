#pragma once

#include <array>

#include "limes/fem/mitc4.h"

namespace limes {

/// Stiffness against the rotation of nodes about the normal n of an element's centre, as far as it is not
/// the rotation of the element in its plane there, omega = n . curl u / 2: at each node a that is meant
/// the energy is
///
///     1/2 factor G t A/4 (theta_a . n - omega)^2,
///
/// G the shear modulus, t the thickness, A the area [hughes_1989]. Rigid motions have none.
/// @param nodes  which corners are meant
[[nodiscard]] ShellMatrix drilling_stiffness(const ShellQuad& quad, const ShellSection& section,
                                             const std::array<bool, 4>& nodes, double factor);

}  // namespace limes
