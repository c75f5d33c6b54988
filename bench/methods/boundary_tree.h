#pragma once

#include <array>

#include "refined_ring.h"

namespace bench {

/// Evaluation of a regular Catmull-Clark face at the boundary by a binary tree [barendrecht_2013,
/// section 4, Figs. 14 to 17]: of the four parts of a face, the two away from the boundary are
/// regular, the two at it are boundary faces again. The way down to the part that holds a point is
/// a sequence of the matrices E_L and E_R, which no power or eigenvector shortens.
///
/// A boundary face has the boundary at v = 0 and 4 x 3 controls (index 4 j + i, line j = 0 on the
/// boundary); a corner face with a sharp corner at (0, 0) has 3 x 3 controls (index 3 j + i).
class BoundaryTree {
 public:
  enum class Face { boundary, corner };

  explicit BoundaryTree(Face face);

  [[nodiscard]] int num_controls() const { return face_ == Face::boundary ? 12 : 9; }

  /// Position and derivatives.
  /// @param uv  in [0, 1]^2, v > 0, and u > 0 in a corner face: the boundary is in no regular part
  /// @throws limes::InputError at the boundary
  [[nodiscard]] limes::SurfaceJet evaluate(const Points& controls, const limes::Vec2& uv) const;

  /// Levels of the tree that a point needs.
  [[nodiscard]] int depth(const limes::Vec2& uv) const;

  [[nodiscard]] std::size_t memory() const;  ///< bytes

  /// What one step does in one direction. `end`: the boundary is at 0, three controls; otherwise
  /// four. half 0: [0, 1/2], which is an end again; half 1: [1/2, 1], four controls.
  [[nodiscard]] static limes::MatrixX half_step(bool end, int half);

  /// E_L and E_R of a boundary face, (12, 12).
  [[nodiscard]] static limes::MatrixX left_step();
  [[nodiscard]] static limes::MatrixX right_step();

 private:
  Face face_;
  /// Index 8 end_u + 4 end_v + 2 half_u + half_v.
  std::array<limes::MatrixX, 16> steps_;
};

/// The 16 controls of the one patch that is the whole face, from those of BoundaryTree: "phantoms"
/// 2 b - c, at a corner in both directions. [barendrecht_2013] prints the corner phantom as
/// P1 = 4 P7 + 4 P10 + P11 - 8 P6; right is the tensor product, 4 P6 - 2 P7 - 2 P10 + P11.
[[nodiscard]] limes::MatrixX phantom_matrix(BoundaryTree::Face face);

}  // namespace bench
