#pragma once

#include <vector>

#include "limes/limit/ring_kind.h"

namespace limes {

/// A square of an element's parameter square [0, 1]^2 on which all limit functions are polynomials,
/// or what is left over around an extraordinary vertex.
struct ParameterTile {
  Vec2 origin;  ///< lowest corner
  double size;  ///< length of its sides
};

/// One kind of ring and the place in it where an element begins.
struct KindOfElement {
  const RingKinds* kinds;
  int kind;
};

/// Tiles that suit several sets of limit functions at once (geometry and field): every ring of
/// tiles around a corner where functions are not polynomial, down to `depth` rings, then the square
/// that is left over. A regular element is one tile.
/// @param face_size, corner  of the element's face, see LimitBasis
[[nodiscard]] std::vector<ParameterTile> element_tiles(std::vector<KindOfElement> functions,
                                                       int face_size, int corner, int depth);

}  // namespace limes
