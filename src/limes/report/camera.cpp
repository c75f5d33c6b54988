#include "limes/report/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "limes/core/error.h"

namespace limes {
namespace {

template <class Visit>
void visit_points(const Scene& scene, const Visit& visit) {
  // Only points in use: a mesh may carry vertices that no face needs.
  for (const Surface& s : scene.surfaces)
    for (const auto& t : s.triangles)
      for (const int i : t)
        visit(s.points[static_cast<std::size_t>(i)]);
  for (const Lines& l : scene.lines)
    for (const auto& segment : l.segments)
      for (const int i : segment)
        visit(l.points[static_cast<std::size_t>(i)]);
  for (const Markers& m : scene.markers)
    for (const Vec3& p : m.points)
      visit(p);
}

/// The box of the scene in the camera's frame, relative to the model's origin.
struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  [[nodiscard]] Vec3 centre() const { return (low + high) / 2; }
  [[nodiscard]] Vec3 size() const { return high - low; }
};

Box box_along(const Scene& scene, const Mat3& axes) {
  check_scene(scene);
  Box box;
  visit_points(scene, [&](const Vec3& p) {
    const Vec3 q = axes * p;
    box.low = box.low.cwiseMin(q);
    box.high = box.high.cwiseMax(q);
  });
  if (!(box.low[0] <= box.high[0])) throw InputError("picture: the scene has no points");
  return box;
}

double length_of(const Box& box) {
  const double size = box.size().norm();
  return size > 0 ? size : 1;  // a single point still has a picture
}

Mat3 axes_for(const Vec3& direction, const Vec3& up) {
  const Vec3 back = -direction.normalized();
  const Vec3 right = up.cross(back);
  if (!(right.norm() > 1e-9 * up.norm()))
    throw InputError("picture: the view direction and the upward direction are parallel");
  Mat3 axes;
  axes.row(0) = right.normalized();
  axes.row(1) = back.cross(right.normalized());
  axes.row(2) = back;
  return axes;
}

/// Places the eye so that all points lie between the four planes through it: per direction the two
/// planes that touch the points are intersected, the farther eye wins.
void fit_perspective(Camera& camera, const Scene& scene, const Box& box, double aspect,
                     double margin) {
  const double inside = 1 - 2 * margin;
  const Vec2 slope(camera.half_height * aspect * inside, camera.half_height * inside);
  Vec2 most = Vec2::Constant(-std::numeric_limits<double>::infinity());
  Vec2 least = -most;
  visit_points(scene, [&](const Vec3& p) {
    const Vec3 q = camera.axes * p;
    for (int i = 0; i < 2; ++i) {  // the eye e needs |q_i - e_i| <= slope_i (e_z - q_z)
      most[i] = std::max(most[i], q[i] + slope[i] * q[2]);
      least[i] = std::min(least[i], q[i] - slope[i] * q[2]);
    }
  });
  Vec3 eye;
  eye.head<2>() = (most + least) / 2;
  eye[2] = ((most - least).array() / (2 * slope.array())).maxCoeff();
  eye[2] = std::max(eye[2], box.high[2] + 1e-3 * length_of(box));
  camera.eye = camera.axes.transpose() * eye;
}

}  // namespace

Camera fit_camera(const Scene& scene, const Vec3& direction, const Vec3& up, double aspect,
                  const FitOptions& options) {
  LIMES_ASSERT(aspect > 0 && options.margin >= 0 && options.margin <= 0.45);
  Camera camera;
  camera.projection = options.projection;
  camera.axes = axes_for(direction, up);
  const Box box = box_along(scene, camera.axes);
  if (options.projection == Projection::perspective) {
    camera.half_height = std::tan(options.opening_angle / 2 * std::numbers::pi / 180);
    fit_perspective(camera, scene, box, aspect, options.margin);
    return camera;
  }
  const Vec3 size = box.size();
  camera.half_height = std::max(size[1], size[0] / aspect) / 2 / (1 - 2 * options.margin);
  if (!(camera.half_height > 0)) camera.half_height = length_of(box) / 2;
  const Vec3 centre = box.centre();
  camera.eye = camera.axes.transpose() * Vec3(centre[0], centre[1], box.high[2] + length_of(box));
  return camera;
}

Camera top_camera(const Scene& scene, double aspect, double margin) {
  return fit_camera(scene, Vec3(0, 0, -1), Vec3(0, 1, 0), aspect,
                    {.projection = Projection::orthographic, .margin = margin});
}

PictureSize size_for_plane(const Scene& scene, PictureSize most) {
  const Vec3 size = box_along(scene, Mat3::Identity()).size();
  const double scale =
      std::min(most.width / std::max(size[0], 1e-300), most.height / std::max(size[1], 1e-300));
  const auto pixels = [&](double length, int limit) {
    return std::clamp(static_cast<int>(std::ceil(length * scale)), (limit + 3) / 4, limit);
  };
  return {pixels(size[0], most.width), pixels(size[1], most.height)};
}

}  // namespace limes
