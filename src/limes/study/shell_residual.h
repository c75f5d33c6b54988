#pragma once

#include <vector>

#include "limes/study/shell_solution.h"

namespace limes {

/// Squared error of every face in the energy norm, estimated by what the resultants of the elements leave
/// unbalanced [babuska_1987, kelly_1983]: with a face's area a,
///
///     a / 24 integral of r . A^-1 r + sum over sides of the mean of a / 6 j . A^-1 j,
///
/// once for forces, r = Div (N + V Q^T) + p, and once for moments, r = Div M - Q, with the directors V as
/// the surface's normals. Of r the mean over the face is taken out: the sides see it, too
/// [carstensen_1999]. On a side R is what the forces N nu + V (Q . nu), or the moments V x (M nu), of
/// all faces that meet there lack to balance in space, with the load along it and without what supports
/// hold; each of k faces has j = R / k. A is the stiffness of the section against a change along nu, the
/// mean of the faces', inside that of two directions:
///
///     membrane  E t (1 / (1 - nu^2) along nu, 1 / (2 (1 + nu)) across it),   moments  t^2 / 12 of that,
///     along V   1 / ( 1 / (k G t) + h^2 / (60 D) ),   D = E t^3 / (12 (1 - nu^2)),
///
/// the last of a beam of the length h whose ends are held, which can deflect without shear; h is the
/// face's area by the length of the side. On a border whose rotations are free twisting moments act in a
/// layer as wide as the shell is thick: their A is multiplied by x / tanh x, x = h / 6 sqrt(12 k) / t. The
/// sides alone are exact for solutions of second order on rectangles. Forces and moments at vertices are
/// no part of it. A side in which a node hangs is taken by halves: each has its own j, of the resultants of both
/// elements there, seen along the chord and the directors of the small one, and counts by half for the large one.
[[nodiscard]] std::vector<double> residual_estimate(const ShellModel& model,
                                                    const ShellSolution& solution);

}  // namespace limes
