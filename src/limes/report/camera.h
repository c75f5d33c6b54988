#pragma once

#include "limes/report/scene.h"

namespace limes {

enum class Projection { orthographic, perspective };

/// Where a scene is seen from. The frame is right-handed: x to the right, y up, z towards the eye.
struct Camera {
  Projection projection = Projection::orthographic;
  Vec3 eye = Vec3(0, 0, 1);
  Mat3 axes = Mat3::Identity();  ///< rows: right, up, towards the eye; orthonormal
  double half_height = 1;        ///< orthographic: of the view, in units of the model;
                                 ///< perspective: its tangent seen from the eye

  /// Coordinates relative to the eye; what is seen has z < 0.
  [[nodiscard]] Vec3 to_view(const Vec3& p) const { return axes * (p - eye); }
};

struct FitOptions {
  Projection projection = Projection::perspective;
  double margin = 0.04;       ///< free share of the picture at each side, 0 to 0.45
  double opening_angle = 24;  ///< degrees, from the lower to the upper edge; perspective only
};

/// The camera that looks along `direction` and has all of the scene tightly in the picture.
/// @param up      points upwards in the picture; not parallel to direction
/// @param aspect  width / height of the picture
/// @throws InputError if the scene has no points or is broken (check_scene), or if up and direction
///         are parallel
[[nodiscard]] Camera fit_camera(const Scene& scene, const Vec3& direction, const Vec3& up,
                                double aspect, const FitOptions& options = {});

/// The view of a plane model from +z, x to the right, y up.
[[nodiscard]] Camera top_camera(const Scene& scene, double aspect, double margin = 0.04);

/// From the front, right and above, z up: the usual view of a solid.
[[nodiscard]] inline Vec3 default_direction() {
  return {-0.55, 0.75, -0.42};
}

struct PictureSize {
  int width, height;
};
/// The largest size within the given one whose aspect ratio is the scene's seen from +z, but not
/// narrower or lower than a quarter of it.
[[nodiscard]] PictureSize size_for_plane(const Scene& scene, PictureSize most);

}  // namespace limes
