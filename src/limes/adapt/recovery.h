#pragma once

#include <functional>
#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"

namespace limes {

// Superconvergent patch recovery [zienkiewicz_1992]: a field that is most accurate at the centres of
// bilinear elements is fitted by a linear function on the elements around a vertex, and the fit's
// value at the vertex is the recovered one. A vertex with elements on one side only takes the mean of
// the values there of the fits around its inner neighbours: its own would be extrapolated from one
// row of elements.

/// Whether a fit may use the faces on both sides of an inner edge.
using JoinsFaces = std::function<bool(HalfedgeId inner)>;

/// Faces whose samples give the recovered value at some corners of one vertex.
struct RecoveryPatch {
  VertexId vertex;
  std::vector<HalfedgeId> corners;  ///< which start at the vertex; joined with each other
  std::vector<FaceId> faces;        ///< those of the corners first
  bool inner = false;               ///< all faces around the vertex, which is not on the boundary
};

/// Every corner of every face is in exactly one patch. Where fewer than three faces are joined around a
/// vertex, as on a boundary, the patch grows by the faces joined to its own, ring by ring, until it has
/// three or there are no more.
[[nodiscard]] std::vector<RecoveryPatch> recovery_patches(const Adjacency& adjacency,
                                                          const JoinsFaces& joined);

/// For each patch the patches whose fits give its values: itself if it is inner, else the inner ones
/// at other corners of its corners' faces, and itself only if there are none.
[[nodiscard]] std::vector<std::vector<int>> recovering_patches(
    const Adjacency& adjacency, const std::vector<RecoveryPatch>& patches);

/// A linear function of two variables with several components.
struct LinearFit {
  Eigen::RowVector2d middle;
  Eigen::RowVectorXd value;                        ///< there
  Eigen::Matrix<double, 2, Eigen::Dynamic> slope;  ///< (2, c)

  [[nodiscard]] VectorX at(const Vec2& x) const {
    return (value + (x.transpose() - middle) * slope).transpose();
  }
};

/// The linear function that fits samples best; of several, the one with the least slope.
/// @param at      places, (m, 2), m >= 1
/// @param values  (m, c)
[[nodiscard]] LinearFit linear_fit(const Eigen::Matrix<double, Eigen::Dynamic, 2>& at,
                                   const MatrixX& values);

}  // namespace limes
