#pragma once

#include <vector>

#include "limes/study/shell_solution.h"

namespace limes {

/// Squared error of every face in the energy norm, estimated by what the resultants of the elements leave
/// unbalanced [babuska_1987, kelly_1983]: with h the square root of a face's area,
///
///     h^2 / 24 integral of r . A^-1 r + h / 6 sum over sides of the integral of j . A^-1 j,
///
/// once for forces, r = Div (N + V Q^T) + p, and once for moments, r = Div M - Q, with the directors V as
/// the surface's normals. On a side R is what the forces N nu + V (Q . nu), or the moments V x (M nu), of
/// all faces that meet there lack to balance in space, with the load along it and without what supports
/// hold; each of k faces has j = R / k. A is the stiffness that the section has against a change along
/// nu, the mean of the faces', inside that of two directions:
///
///     membrane  E t (1 / (1 - nu^2) along nu, 1 / (2 (1 + nu)) across it),   moments  t^2 / 12 of that,
///     along V   1 / ( 1 / (k G t) + h^2 / (60 D) ),   D = E t^3 / (12 (1 - nu^2)),
///
/// the last of a beam whose ends are held: a deflection with the wavelength of an element can do without
/// shear. Forces and moments at vertices are no part of it.
[[nodiscard]] std::vector<double> residual_estimate(const ShellModel& model,
                                                    const ShellSolution& solution);

}  // namespace limes
