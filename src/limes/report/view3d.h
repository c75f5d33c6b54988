#pragma once

#include "limes/report/camera.h"
#include "limes/report/image.h"

namespace limes {

/// A scene for the interactive view of a report (viewer.js). Its triangles and lines go into the
/// page, some 50 bytes per point: keep it below a few hundred thousand triangles. Values are
/// coloured per point there; markers and iso-lines are only in the still picture.
struct View3d {
  Scene scene;
  Vec3 direction = default_direction();
  Vec3 up = Vec3(0, 0, 1);
  PictureSize size{760, 520};
  std::string description = {};  ///< for people who cannot see the picture
};

/// The element of an HTML page: still picture, canvas, controls, data. The page must hold viewer.js.
/// @throws InputError as render() and fit_camera()
[[nodiscard]] std::string to_html(const View3d& view);

}  // namespace limes
