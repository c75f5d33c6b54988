#pragma once

#include <functional>
#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"

namespace limes {

// Superconvergent patch recovery [zienkiewicz_1992]: a field that is most accurate at the centres of
// bilinear elements is fitted by a linear function on the elements around a vertex, and the fit's
// value at the vertex is the recovered one.

/// Whether a fit may use the faces on both sides of an inner edge.
using JoinsFaces = std::function<bool(HalfedgeId inner)>;

/// Faces whose samples give the recovered value at some corners of one vertex.
struct RecoveryPatch {
  VertexId vertex;
  std::vector<HalfedgeId> corners;  ///< which start at the vertex; joined with each other
  std::vector<FaceId> faces;        ///< those of the corners first
};

/// Every corner of every face is in exactly one patch. Where fewer than three faces are joined around a
/// vertex, as on a boundary, the patch grows by the faces joined to its own, ring by ring, until it has
/// three or there are no more.
[[nodiscard]] std::vector<RecoveryPatch> recovery_patches(const Adjacency& adjacency,
                                                          const JoinsFaces& joined);

/// Value at the origin of the linear function that fits samples best; of several, the one with the
/// least slope.
/// @param at      places, (m, 2)
/// @param values  (m, c)
/// @return        (c)
[[nodiscard]] VectorX fitted_at_origin(const Eigen::Matrix<double, Eigen::Dynamic, 2>& at,
                                       const MatrixX& values);

}  // namespace limes
