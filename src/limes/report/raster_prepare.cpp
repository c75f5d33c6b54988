#include <algorithm>
#include <array>
#include <cmath>

#include "limes/core/parallel.h"
#include "limes/report/raster.h"

namespace limes::raster {
namespace {

/// A point in the camera's frame with what travels along when a triangle is cut.
struct ViewVertex {
  Vec3 position;
  float value;
  Colour colour;
  Vec3 normal;
};

ViewVertex between(const ViewVertex& a, const ViewVertex& b, double t) {
  const auto tf = static_cast<float>(t);
  return {a.position + t * (b.position - a.position), a.value + tf * (b.value - a.value),
          mix(a.colour, b.colour, tf), a.normal + t * (b.normal - a.normal)};
}

/// From the camera's frame to samples.
class Projector {
 public:
  Projector(const Camera& camera, const Frame& frame)
      : perspective_(frame.perspective),
        scale_(frame.height / 2.0 / camera.half_height),
        centre_(frame.width / 2.0, frame.height / 2.0) {
    const double guard = 8.0 * std::max(frame.width, frame.height);
    guard_ = guard / scale_;
  }

  [[nodiscard]] double distance(const Vec3& p) const { return perspective_ ? -p[2] : 1; }
  [[nodiscard]] Vec2 screen(const Vec3& p) const {
    const double s = scale_ / distance(p);
    return {centre_[0] + s * p[0], centre_[1] - s * p[1]};
  }
  [[nodiscard]] float depth(const Vec3& p) const {
    return static_cast<float>(perspective_ ? 1 / -p[2] : p[2]);
  }
  /// Depth of something that shall win against what lies up to `samples` samples beside it.
  [[nodiscard]] float raised(float depth, double samples) const {
    const double share = samples / scale_;
    return static_cast<float>(perspective_ ? depth * (1 + share) : depth + share);
  }

  static constexpr int num_planes = 5;
  /// >= 0 on the visible side. Plane 0: before the eye; the others: within eight pictures beside
  /// it, so that integers do not overflow.
  [[nodiscard]] double plane(int i, const Vec3& p) const {
    if (i == 0) return -p[2] - near;
    const double limit = guard_ * distance(p);
    const double x = i < 3 ? p[0] : p[1];
    return i % 2 == 0 ? limit - x : limit + x;
  }
  [[nodiscard]] bool is_inside(const Vec3& p) const {
    for (int i = 0; i < num_planes; ++i)
      if (plane(i, p) < 0) return false;
    return true;
  }

  double near = 0;

 private:
  bool perspective_;
  double scale_;
  Vec2 centre_;
  double guard_;
};

Vertex to_vertex(const ViewVertex& v, const Projector& projector) {
  const Vec2 s = projector.screen(v.position) * subpixels;
  return {static_cast<std::int32_t>(std::lround(s[0])),
          static_cast<std::int32_t>(std::lround(s[1])),
          projector.depth(v.position),
          static_cast<float>(1 / projector.distance(v.position)),
          v.value,
          v.colour,
          {static_cast<float>(v.normal[0]), static_cast<float>(v.normal[1]),
           static_cast<float>(v.normal[2])}};
}

/// The part of a polygon on the visible side of a plane. A cut is computed from the visible end,
/// whichever way round the edge is seen: neighbours get the same point.
std::vector<ViewVertex> cut(const std::vector<ViewVertex>& polygon, int plane,
                            const Projector& projector) {
  std::vector<ViewVertex> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ViewVertex& a = polygon[i];
    const ViewVertex& b = polygon[(i + 1) % polygon.size()];
    const double da = projector.plane(plane, a.position);
    const double db = projector.plane(plane, b.position);
    if (da >= 0) kept.push_back(a);
    if ((da >= 0) != (db >= 0))
      kept.push_back(da >= 0 ? between(a, b, da / (da - db)) : between(b, a, db / (db - da)));
  }
  return kept;
}

class SurfacePreparation {
 public:
  SurfacePreparation(const Surface& surface, const Camera& camera, const Projector& projector)
      : surface_(surface), camera_(camera), projector_(projector) {}

  PreparedSurface run() {
    result_.surface = &surface_;
    for (const double value : surface_.scale.iso_lines)
      result_.iso_lines.push_back(static_cast<float>(surface_.scale.normalised(value)));
    const auto count = static_cast<std::int64_t>(surface_.points.size());
    std::vector<char> inside(surface_.points.size());
    result_.vertices.resize(surface_.points.size());
    for_each_index(count, [&](std::int64_t i) {
      const auto p = static_cast<std::size_t>(i);
      const ViewVertex v = view_vertex(p);
      inside[p] = projector_.is_inside(v.position);
      if (inside[p]) result_.vertices[p] = to_vertex(v, projector_);
    });
    if (surface_.shading != Shading::flat && surface_.normals.empty()) add_facets();
    result_.triangles.reserve(surface_.triangles.size());
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      const auto& [a, b, c] = surface_.triangles[t];
      const auto is_in = [&](int i) { return inside[static_cast<std::size_t>(i)] != 0; };
      if (is_in(a) && is_in(b) && is_in(c)) {
        result_.triangles.push_back({a, b, c, static_cast<int>(t)});
      } else {
        add_cut_triangle(t);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] ViewVertex view_vertex(std::size_t p) const {
    const Surface& s = surface_;
    ViewVertex v{camera_.to_view(s.points[p]), 0, s.colour, Vec3::Zero()};
    if (!s.values.empty()) v.value = static_cast<float>(s.scale.normalised(s.values[p]));
    if (!s.point_colours.empty()) v.colour = s.point_colours[p];
    if (!s.normals.empty()) v.normal = camera_.axes * s.normals[p];
    return v;
  }

  void add_facets() {
    result_.facets.resize(surface_.triangles.size());
    for_each_index(static_cast<std::int64_t>(surface_.triangles.size()), [&](std::int64_t i) {
      const auto t = static_cast<std::size_t>(i);
      const auto point = [&](std::size_t corner) -> const Vec3& {
        return surface_.points[static_cast<std::size_t>(surface_.triangles[t][corner])];
      };
      const Vec3 n = (point(1) - point(0)).cross(point(2) - point(0));
      result_.facets[t] = (camera_.axes * n.normalized()).cast<float>();
    });
  }

  void add_cut_triangle(std::size_t t) {
    std::vector<ViewVertex> polygon;
    for (const int i : surface_.triangles[t])
      polygon.push_back(view_vertex(static_cast<std::size_t>(i)));
    for (int plane = 0; plane < Projector::num_planes && !polygon.empty(); ++plane)
      polygon = cut(polygon, plane, projector_);
    if (polygon.size() < 3) return;
    const int first = static_cast<int>(result_.vertices.size());
    for (const ViewVertex& v : polygon)
      result_.vertices.push_back(to_vertex(v, projector_));
    for (int i = 1; i + 1 < static_cast<int>(polygon.size()); ++i)
      result_.triangles.push_back({first, first + i, first + i + 1, static_cast<int>(t)});
  }

  const Surface& surface_;
  const Camera& camera_;
  const Projector& projector_;
  PreparedSurface result_{};
};

PreparedLines prepare_lines(const Lines& lines, std::uint32_t group, const Camera& camera,
                            const Projector& projector, double unit) {
  PreparedLines result{&lines, lines.width * unit / 2, {}};
  result.segments.reserve(lines.segments.size());
  for (const auto& [ia, ib] : lines.segments) {
    Vec3 a = camera.to_view(lines.points[static_cast<std::size_t>(ia)]);
    Vec3 b = camera.to_view(lines.points[static_cast<std::size_t>(ib)]);
    bool seen = true;
    for (int i = 0; i < Projector::num_planes && seen; ++i) {
      const double da = projector.plane(i, a);
      const double db = projector.plane(i, b);
      seen = da >= 0 || db >= 0;
      if (da < 0 && db >= 0) a = b + db / (db - da) * (a - b);
      if (db < 0 && da >= 0) b = a + da / (da - db) * (b - a);
    }
    if (!seen) continue;
    const double raise = 2 * result.half_width + 2;
    const Vec2 sa = projector.screen(a);
    const Vec2 sb = projector.screen(b);
    result.segments.push_back({sa[0], sa[1], sb[0], sb[1],
                               projector.raised(projector.depth(a), raise),
                               projector.raised(projector.depth(b), raise), group});
  }
  return result;
}

void prepare_markers(const Markers& markers, const Camera& camera, const Projector& projector,
                     Frame& frame) {
  const double radius = markers.size / 2 * frame.unit;
  for (const Vec3& point : markers.points) {
    const Vec3 p = camera.to_view(point);
    if (!projector.is_inside(p)) continue;
    const Vec2 s = projector.screen(p);
    frame.markers.push_back({&markers, s[0], s[1], radius, markers.edge_width * frame.unit,
                             projector.raised(projector.depth(p), 3 * radius)});
  }
}

}  // namespace

Frame prepare(const Scene& scene, const Camera& camera, const RenderOptions& options) {
  const auto pixels = [&](int length) {
    return std::max(1, static_cast<int>(std::lround(length * options.density)));
  };
  Frame frame{};
  frame.samples = options.samples;
  frame.width = pixels(options.size.width) * options.samples;
  frame.height = pixels(options.size.height) * options.samples;
  frame.unit = options.density * options.samples;
  frame.perspective = camera.projection == Projection::perspective;
  frame.background = scene.background;

  Projector projector(camera, frame);
  double farthest = 0;
  for (const Surface& s : scene.surfaces)
    for (const Vec3& p : s.points)
      farthest = std::max(farthest, -camera.to_view(p)[2]);
  projector.near = std::max(1e-4 * farthest, 1e-300);

  for (const Surface& s : scene.surfaces)
    frame.surfaces.push_back(SurfacePreparation(s, camera, projector).run());
  std::uint32_t group = 0;
  for (const Lines& l : scene.lines)
    frame.lines.push_back(prepare_lines(l, ++group, camera, projector, frame.unit));
  for (const Markers& m : scene.markers)
    prepare_markers(m, camera, projector, frame);
  return frame;
}

}  // namespace limes::raster
