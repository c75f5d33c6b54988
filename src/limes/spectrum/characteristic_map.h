#pragma once

#include <vector>

#include "limes/spectrum/eigen.h"

namespace limes {

/// The characteristic map of a scheme around a vertex or face [reif_1995]: the surface in the plane
/// whose control points are the eigenvectors of the subdominant pair. After a period it is the same, smaller.
struct CharacteristicMap {
  std::vector<Vec2> points;  ///< control points at the places of all rings
  double eigenvalue;

  /// Least Jacobian at the corners of the faces in the outermost period of rings, relative to their
  /// mean: where it is positive, the map is regular up to that resolution.
  double least_jacobian;
  /// Turns of the outermost ring of faces around the middle; if 1 and regular, the map is injective.
  int winding_number;
};

/// @param eigenvalue  of block 1, real, positive, simple there
[[nodiscard]] CharacteristicMap characteristic_map(const LocalSubdivision& local,
                                                   const Scheme& scheme, double eigenvalue);

/// Whether the surface is smooth beside the middle, as far as a few periods show: a factor by which
/// the turns between edges shrink in a period, for values that are 1 at one vertex beside the middle
/// and 0 elsewhere. Below 1: the first differences converge; 1: there are kinks.
[[nodiscard]] double kink_factor(const LocalSubdivision& local, const Scheme& scheme);

}  // namespace limes
