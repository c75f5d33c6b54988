#pragma once

#include <map>
#include <optional>
#include <span>

#include "limes/limit/limit_surface.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Masks of star_masks.h by valence.
using StarTangents = std::map<int, std::optional<Eigen::Matrix<double, 2, Eigen::Dynamic>>>;

/// The limit surface of the scheme `kobbelt` on a net of quads, at (face, u, v): (0, 0) is the face's
/// first corner, u runs towards the second, v towards the fourth.
///
/// Where the 6 x 6 vertices around a face lie on a regular grid without curves between them, the
/// surface is the tensor product of four-point curves, whose values and first derivatives are exact
/// at every parameter (four_point.h). Elsewhere the net around the face is refined until the quarter
/// that holds the point is of that kind, or the point is a vertex: vertices lie on the surface. What
/// is left are points on curves that are no vertex of any level up to max_depth.
class InterpolatorySurface {
 public:
  /// Halvings of a face after which a point on a curve is interpolated in what is left.
  static constexpr int max_depth = 26;
  /// The same for a point that close to an extraordinary vertex.
  static constexpr int max_depth_at_vertex = 100;

  /// Keeps references. The adjacency, and so all faces, must be the mesh's.
  /// @param points  one per vertex
  /// @throws InputError if the scheme does not fit the faces or the features
  InterpolatorySurface(const Adjacency& mesh, const Features& features, const Scheme& scheme,
                       std::span<const Vec3> points);

  /// Position; both derivatives where they exist and can be had: everywhere but on curves and at
  /// extraordinary vertices; the normal there and at interior vertices. The surface is C1 and has no
  /// second derivatives.
  [[nodiscard]] SurfacePoint evaluate(FaceId f, const Vec2& uv) const;

 private:
  const Adjacency* mesh_;
  const Features* features_;
  const Scheme* scheme_;
  std::span<const Vec3> points_;
  StarTangents tangents_;
};

}  // namespace limes
