#pragma once

#include <array>
#include <functional>

#include "limes/core/types.h"

namespace limes {

// The four-node shell element with assumed transverse shear strains, [dvorkin_1984]; the form used
// here is that of docs/theory/mitc4.md. Every node has a displacement u and a rotation vector theta;
// its director V turns to V + theta x V. Unknown 6 a + i of an element is u_i, 6 a + 3 + i is
// theta_i of node a. Rotation about the director ("drilling") does no work in the element: its matrix
// has a zero eigenvalue for each node, which the model takes out or another element stiffens.

/// Membrane strains of the middle surface. Assumed ones are for convex elements, or nearly so.
enum class MembraneStrain {
  displacement,  ///< as the displacements give them: plain MITC4
  assumed        ///< tied, and with constant in-plane shear: thin warped elements do not lock
};

/// Isotropic, of constant thickness.
struct ShellSection {
  double young = 1;                 ///< > 0
  double poisson = 0;               ///< in (-1, 1/2)
  double thickness = 1;             ///< > 0
  double shear_factor = 5.0 / 6.0;  ///< of the transverse shear stiffness, > 0
  MembraneStrain membrane = MembraneStrain::displacement;
};

/// Corners in order, counter-clockwise seen from where the directors point to. Natural coordinates
/// (r, s) in [-1, 1]^2: corner 0 is (-1, -1), r grows towards corner 1, s towards corner 3.
struct ShellQuad {
  std::array<Vec3, 4> x;
  std::array<Vec3, 4> director;  ///< of length 1

  [[nodiscard]] Vec3 position(const Vec2& rs) const;
  /// Of the bilinear middle surface, times its area per unit of (r, s).
  [[nodiscard]] Vec3 area_normal(const Vec2& rs) const;
};

using ShellMatrix = Eigen::Matrix<double, 24, 24>;
using ShellVector = Eigen::Matrix<double, 24, 1>;

/// Stiffness, by 2 x 2 x 2 Gauss points; symmetric to the last bit.
[[nodiscard]] ShellMatrix mitc4_stiffness(const ShellQuad& quad, const ShellSection& section);

/// What the element carries at one point, as tensors of the space, so that no local axes are needed;
/// both in the surface. Positive bending stretches the side that the director points to.
struct ShellResultants {
  Mat3 membrane;  ///< force per length, integral of stress over the thickness
  Mat3 bending;   ///< moment per length, integral of stress times distance from the middle
  Vec3 shear;     ///< transverse force per length; shear . n is that on a cut with normal n
  Vec3 normal;    ///< unit normal of the element there
};
/// @param u   unknowns of the element
/// @param rs  where; membrane and bending are best at the centre
[[nodiscard]] ShellResultants mitc4_resultants(const ShellQuad& quad, const ShellSection& section,
                                               const ShellVector& u, const Vec2& rs);

/// Von Mises stress from membrane and bending at the distance z from the middle, |z| <= thickness/2.
[[nodiscard]] double shell_von_mises(const ShellResultants& resultants, double thickness, double z);

/// Force per area at a point with the unit normal of the surface.
using ShellDensity = std::function<Vec3(const Vec3& x, const Vec3& normal)>;
/// f_a = integral of N_a p over the bilinear middle surface, 2 x 2 Gauss points.
[[nodiscard]] ShellVector shell_area_load(const ShellQuad& quad, const ShellDensity& p);
/// f_a = integral of N_a p along the side from corner `side` to the next, 2 Gauss points.
[[nodiscard]] ShellVector shell_side_load(const ShellQuad& quad, int side,
                                          const std::function<Vec3(const Vec3& x)>& p);

}  // namespace limes
