#pragma once

#include <vector>

#include "limes/core/types.h"
#include "limes/space/constraints.h"

namespace limes {

/// A node of a shell, as seen from a side of an element.
struct SideNode {
  Vec3 x;
  Vec3 director;       ///< of length 1; of the element whose side it is
  bool smooth = true;  ///< has no other director, so that rotation about it does no work
  int first = 0;       ///< unknowns first, first + 1, first + 2 are u, the next three theta
};

/// The six conditions on a node that hangs inside the side from a to b of an element of
/// fem/mitc4.h, because what lies on the other side is split. With the side's length L, its direction
/// e and the offset d of the node from the middle of the ends,
///
///     u     = (u_a + u_b) / 2 + (theta_a + theta_b) / 2 x d + L/8 e x (theta_b - theta_a),
///     theta = (theta_a + theta_b) / 2.
///
/// The last term of u is the deflection of a side that bends: with it the transverse shear along each
/// half is that along the whole, which is constant. So on flat meshes fields of constant strain and of
/// constant curvature fulfil the conditions, and everywhere rigid motions do: rotations about a
/// director, which need be no unknowns, are taken from how the side turns. At a smooth node theta has
/// no part along its director. docs/theory/mitc4.md.
/// @param node  hangs; smooth unless the side lies on a kink
/// @param a, b  not in one place; directors not along the side
[[nodiscard]] std::vector<ConstraintRow> hanging_constraints(const SideNode& node,
                                                             const SideNode& a, const SideNode& b);

}  // namespace limes
