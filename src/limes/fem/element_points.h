#pragma once

#include <optional>

#include "limes/space/subdivision_space.h"

namespace limes {

/// An element's table carried to physical space: q points, k functions. For plane models, where the
/// surface lies in the xy plane.
struct ElementPoints {
  Eigen::Matrix<double, Eigen::Dynamic, 3> x;  ///< (q, 3)
  VectorX J;                                   ///< d(x, y)/d(u, v), signed, (q)
  MatrixX Nx, Ny;                              ///< physical gradients, (q, k)
};

/// @param P  control points of the element, (m, 3)
void to_physical(const ElementTable& table, const Eigen::Matrix<double, Eigen::Dynamic, 3>& P,
                 ElementPoints& out);

/// A place where the map from parameters to the plane is not one to one.
struct Fold {
  FaceId face;
  Vec3 x;
};

/// The first quadrature point at which det J changes its sign or vanishes.
[[nodiscard]] std::optional<Fold> find_fold(const SubdivisionSpace& space);

}  // namespace limes
