#pragma once

#include <vector>

#include "limes/limit/limit_basis.h"

namespace limes {

/// A square of an element's parameter square [0, 1]^2 on which all limit functions are polynomials,
/// or what is left over around an extraordinary vertex.
struct ParameterTile {
  Vec2 origin;  ///< lowest corner
  double size;  ///< length of its sides
};

/// Which element of which face, and the functions on it.
struct ElementShape {
  const LimitBasis* geometry;
  const LimitBasis* field;
  FaceId face;
  int corner;  ///< quadrant of the face, see LimitBasis
};

/// Tiles that suit geometry and field at once: every ring of tiles around a corner where functions
/// are not polynomial, down to `depth` rings, then the square that is left over. A regular element
/// is one tile.
[[nodiscard]] std::vector<ParameterTile> element_tiles(const ElementShape& shape, int depth);

}  // namespace limes
