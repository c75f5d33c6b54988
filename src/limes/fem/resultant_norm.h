#pragma once

#include "limes/fem/mitc4.h"

namespace limes {

/// Resultants in the plane normal to another direction, by the shortest turn.
/// @param normal  of length 1, not opposite to that of the resultants
[[nodiscard]] ShellResultants turned(const ShellResultants& r, const Vec3& normal);

/// Twice the energy per area of what two states with one normal differ by,
///
///     ( |N|^2 + 12/t^2 |M|^2 ) / (E t) + Q . Q / (k G t),   |A|^2 = (1 + nu) A : A - nu (tr A)^2.
[[nodiscard]] double energy_between(const ShellResultants& a, const ShellResultants& b,
                                    const ShellSection& section);

}  // namespace limes
