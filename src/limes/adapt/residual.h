#pragma once

#include <functional>

#include "limes/adapt/zienkiewicz_zhu.h"

namespace limes {

/// What a solution should balance, with d components: 1 of a scalar, 2 of displacements. Loads at
/// points are no part of it. Called by one thread at a time, so that it may evaluate expressions.
struct LoadDensity {
  /// Per area of an element, (d).
  std::function<VectorX(int element, const Vec3& x)> on_element;
  /// Per length of a side of the domain with its outward normal, (d).
  std::function<VectorX(HalfedgeId side, const Vec3& x, const Vec2& normal)> on_side;
  /// Whether the solution's component is given along a side of the domain.
  std::function<bool(HalfedgeId side, int component)> held;
};

/// Squared error of every face in the energy norm, estimated by what the solution leaves unbalanced
/// [babuska_1987, kelly_1983]: with a face's area a,
///   a / 24 integral of r . A^-1 r + sum over sides of the mean of a / 6 j . A^-1 j,
/// r = f + div q in the face without its mean there, which the sides see, too [carstensen_1999]; on an inner
/// side j is half of the jump of the flux q . n, on the border g - q . n where the solution is not given.
/// A(n) is the stiffness against a gradient along n, on a side the mean of both faces', inside that of x
/// and y. The sides are exact for functions of second order on rectangles.
/// Precondition: as zienkiewicz_zhu().
/// @param hanging  if vertices hang in the middles of sides: each half has its own jump
/// @return         by face; 0 for holes
[[nodiscard]] std::vector<double> residual_estimate(const SubdivisionSpace& space,
                                                    const EnergyDensity& energy,
                                                    const LoadDensity& load,
                                                    const HangingFaces* hanging = nullptr);

}  // namespace limes
