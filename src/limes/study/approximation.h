#pragma once

#include <vector>

namespace limes {

// How well the scheme `kobbelt` approximates surfaces from points on them: the studies of
// [kobbelt_1996], Tables 1 and 2. docs/theory/kobbelt.md says how the tables were read.

struct ApproximationOptions {
  double tension = 1.0;
  int levels = 3;  ///< refinement steps after which the error is measured
};

/// Errors of the surface through samples of cos r, r^2 = x^2 + y^2.
struct GraphError {
  double h;     ///< the paper's; the samples are h / 3 apart
  double mean;  ///< of |z - cos r| over [0, 1]^2, from the vertices there
  double max;
};
/// The net goes on beyond the square, so that its boundary has no influence.
/// @param inverse_step  1 / h >= 1
[[nodiscard]] GraphError graph_error(int inverse_step, const ApproximationOptions& options);

/// Errors of the surface through points of the unit sphere, as integrals of the distance divided by
/// the volume of the ball.
struct SphereError {
  double h;        ///< the paper's: 1 for a cube
  double regular;  ///< over what comes of the faces that touch no vertex of valence 3
  double total;
};
/// The points are those of a cube refined by the scheme itself, projected onto the sphere.
/// @param steps  h = 2^-steps
[[nodiscard]] SphereError sphere_error(int steps, const ApproximationOptions& options);

}  // namespace limes
