#pragma once

#include <vector>

#include "limes/space/element_tiles.h"

namespace limes {

/// Basis functions at fixed points of an element: everything that depends only on the kinds of its
/// rings, computed once per kind. q points, m geometry functions, k field functions; derivatives
/// are with respect to the element's u and v.
struct ElementTable {
  Eigen::Matrix<double, Eigen::Dynamic, 2> uv;  ///< (q, 2)
  VectorX weight;                               ///< (q), sums to 1; empty for sample tables
  MatrixX G, Gu, Gv;                            ///< geometry, (q, m)
  MatrixX N, Nu, Nv;                            ///< field, (q, k)
  /// The field functions that do not vanish on the element: positions among the controls of its
  /// face, (k).
  std::vector<int> active;
};

/// Gauss points on all tiles of an element.
struct ElementQuadrature {
  int points = 3;  ///< per direction and tile
  int depth = 4;   ///< rings of tiles around an extraordinary vertex
};

/// Points and weights of a rule on an element of this shape.
[[nodiscard]] ElementTable quadrature_table(const ElementShape& shape,
                                            const ElementQuadrature& quadrature);

/// Values at given points. Where derivatives of the geometry or of the field do not exist, at an
/// extraordinary vertex, those of both are taken at one point 2^-20 of the element further inside,
/// where physical gradients have converged.
/// @param active  the field functions to keep
[[nodiscard]] ElementTable sample_table(const ElementShape& shape, const std::vector<Vec2>& points,
                                        const std::vector<int>& active);

}  // namespace limes
