#pragma once

#include "limes/limit/limit_basis.h"

namespace limes {

/// A point of a limit surface. Fields that do not exist there are empty: at an extraordinary vertex
/// all derivatives and curvatures, at a vertex without tangent plane also the normal.
struct SurfacePoint {
  struct First {
    Vec3 xu, xv;
  };
  struct Second {
    Vec3 xuu, xuv, xvv;
  };
  struct Curvature {
    double mean;   ///< (k1 + k2) / 2, positive on a sphere whose normal points out
    double gauss;  ///< k1 k2
  };
  Vec3 x;
  std::optional<First> first;
  std::optional<Second> second;
  std::optional<Vec3> normal;  ///< unit length, out of counter-clockwise faces
  std::optional<Curvature> curvature;
};

/// A point that is not extraordinary: normal and curvature from its derivatives.
[[nodiscard]] SurfacePoint ordinary_point(const Vec3& x, const SurfacePoint::First& first,
                                          const SurfacePoint::Second& second);

/// Limit functions with control points: position, derivatives, normal and curvature at
/// (face, corner, u, v). Parameters as in LimitBasis. Keeps references.
class LimitSurface {
 public:
  /// @param points  one per vertex of the basis
  LimitSurface(const LimitBasis& basis, std::span<const Vec3> points);

  [[nodiscard]] const LimitBasis& basis() const { return *basis_; }
  [[nodiscard]] Vec3 position(FaceId f, int corner, const Vec2& uv) const;
  [[nodiscard]] SurfacePoint evaluate(FaceId f, int corner, const Vec2& uv) const;

 private:
  const LimitBasis* basis_;
  std::span<const Vec3> points_;
};

/// Limit position of every vertex; a vertex that no face uses stays where it is.
[[nodiscard]] IdArray<VertexId, Vec3> limit_positions(const LimitSurface& surface,
                                                      std::span<const Vec3> points);

}  // namespace limes
