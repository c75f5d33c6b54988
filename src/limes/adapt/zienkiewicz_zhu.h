#pragma once

#include "limes/adapt/recovery.h"
#include "limes/space/subdivision_space.h"
#include "limes/subdiv/hanging_faces.h"

namespace limes {

/// The energy of a solution of bilinear elements: e . D e / 2 per area, with a gradient e of c
/// components (of a scalar; strains) and its flux D e (or stresses).
struct EnergyDensity {
  /// e at the points of a table of the element's shape, (q, c).
  std::function<MatrixX(int element, const ElementTable& table)> gradient;
  std::function<MatrixX(int element)> stiffness;  ///< D, (c, c), positive definite
};

/// Squared error of every face in the energy norm, by comparison of the solution's flux with the
/// recovered one: integral of (q* - q) . D^-1 (q* - q) [zienkiewicz_1987, eq. 6]. q* is bilinear
/// between recovered values at the corners.
/// Precondition: the space is that of the scheme `linear`, on quads.
/// @param joined   recovery does not cross other edges, such as those between materials
/// @param hanging  if vertices hang in sides: patches and `joined` are about its halfedges, so that the patch of
///                 a hanging vertex has the element in whose side it is
/// @return         by face; 0 for holes
[[nodiscard]] std::vector<double> zienkiewicz_zhu(const SubdivisionSpace& space,
                                                  const EnergyDensity& energy,
                                                  const JoinsFaces& joined,
                                                  const HangingFaces* hanging = nullptr);

}  // namespace limes
