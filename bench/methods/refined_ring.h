#pragma once

#include <vector>

#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/ring.h"
#include "limes/subdiv/scheme.h"

namespace bench {

/// One step of a scheme on the ring of a face: the ring of child `child` (the sub-face at that
/// corner, its own corner 0 there), whose controls are A times the ring's.
struct RefinedRing {
  limes::Ring ring;
  limes::MatrixX A;  ///< (num_controls of the child's ring, num_controls)
};
[[nodiscard]] RefinedRing refine_ring(const limes::Ring& ring, const limes::Scheme& scheme,
                                      int child);

/// A face's parameters in those of its child, which is turned so that (0, 0) is at corner `child`:
/// turned(child, uv) is the point before the child is stretched by two.
[[nodiscard]] limes::Vec2 turned(int child, const limes::Vec2& uv);
/// Derivative of turned(child, uv): a rotation by a multiple of 90 degrees.
[[nodiscard]] limes::Mat2 turn(int child);

/// The child that holds a point: corner 0 has (0, 0), the middle belongs to it.
[[nodiscard]] int quadrant_of(const limes::Vec2& uv);

/// Weights of the 16 control points of a bicubic patch (index 4 j + i) at (s, t) in column 0; in
/// columns 1 to 5 those of d/du, d/dv, d2/du2, d2/dudv, d2/dv2, where J is d(s, t)/d(u, v).
using PatchWeights = Eigen::Matrix<double, 16, 6>;
[[nodiscard]] PatchWeights bicubic_weights(const limes::Vec2& st, const limes::Mat2& J);

/// Position and derivatives from six rows of values: x, xu, xv, xuu, xuv, xvv.
[[nodiscard]] limes::SurfaceJet jet_of(const Eigen::Matrix<double, 6, 3>& rows);

/// Rows of control points.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;
/// The control points of a ring.
[[nodiscard]] Points controls_of(const limes::Ring& ring, std::span<const limes::Vec3> points);

}  // namespace bench
