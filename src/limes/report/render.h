#pragma once

#include "limes/report/camera.h"
#include "limes/report/image.h"

namespace limes {

/// Sizes are in units of the picture (CSS pixels); the image has `density` pixels per unit, so the
/// same scene with another density looks the same, only finer.
struct RenderOptions {
  PictureSize size{900, 675};
  double density = 2;
  int samples = 3;  ///< per pixel and direction, 1 to 8
};

/// Draws a scene into pixels: z-buffer, every pixel from samples^2 samples, values interpolated and
/// coloured per sample. Adjacent triangles neither leave gaps nor overlap. Both sides of a triangle
/// are seen; of two at the same depth the earlier one wins. The same bytes for any number of
/// threads. Cost: about proportional to triangles + samples.
/// @throws InputError for a scene whose arrays do not fit (check_scene)
[[nodiscard]] Image render(const Scene& scene, const Camera& camera, const RenderOptions& options);

/// Where a point appears, in units of the picture from its upper left corner, for labels.
[[nodiscard]] Vec2 project(const Vec3& point, const Camera& camera, const PictureSize& size);

}  // namespace limes
