#pragma once

#include "limes/limit/limit_basis.h"
#include "limes/limit/tile_kernel.h"

namespace limes {

/// A point beyond what a tile tree keeps.
struct DeepPoint {
  LimitBasis::Point kind;
  int depth;  ///< the tile's parameters run 2^depth times as fast as u and v
};

/// Refines the controls of a deep square towards one point until the limit there is one polynomial;
/// at an extraordinary vertex it is the constant position.
/// @param deep     index in tree.deep
/// @param numbers  what the face stores
/// @param tile     written: the polynomial
/// @param point    written: where to evaluate it
DeepPoint deep_tile(const RingKinds& kinds, const TileTree& tree, int deep, const double* numbers,
                    const Vec2& uv, TileCoefficients& tile, TilePoint& point);

}  // namespace limes
