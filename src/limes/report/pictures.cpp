#include "limes/report/pictures.h"

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"
#include "limes/mesh/adjacency.h"

namespace limes {
namespace {

struct CategoryLook {
  const char* label;
  Colour colour;
};
constexpr std::array<CategoryLook, 4> category_looks{{{"regular", palette::green},
                                                      {"extraordinary", palette::yellow},
                                                      {"boundary", palette::orange},
                                                      {"corner", palette::red}}};

int regular_valence(const Topology& topology) {
  return topology.uniform_face_size() == 3 ? 6 : 4;
}

bool is_extraordinary(const Adjacency& adjacency, VertexId v) {
  if (!adjacency.ring_start(v).valid()) return false;
  const int regular = regular_valence(adjacency.topology());
  const int faces = adjacency.num_ring_faces(v);
  return adjacency.is_boundary(v) ? faces != regular / 2 && faces != 1 : faces != regular;
}

FaceCategory classify(const Adjacency& adjacency, FaceId f) {
  const Topology& topology = adjacency.topology();
  const auto face = topology.face(f);
  const auto any = [&](auto&& condition) {
    return std::any_of(face.begin(), face.end(), condition);
  };
  if (any([&](VertexId v) { return adjacency.is_boundary(v) && adjacency.num_ring_faces(v) == 1; }))
    return FaceCategory::corner;
  if (any([&](VertexId v) { return adjacency.is_boundary(v); })) return FaceCategory::boundary;
  const int corners = regular_valence(topology) == 6 ? 3 : 4;
  if (topology.face_size(f) != corners ||
      any([&](VertexId v) { return is_extraordinary(adjacency, v); }))
    return FaceCategory::extraordinary;
  return FaceCategory::regular;
}

Camera camera_for(const Scene& scene, const PictureOptions& options, const PictureSize& size) {
  const double aspect = static_cast<double>(size.width) / size.height;
  constexpr double plane_margin = 0.005;  // room for the half width of lines
  return options.direction ? fit_camera(scene, *options.direction, options.up, aspect)
                           : top_camera(scene, aspect, plane_margin);
}

std::vector<bool> are_holes(int num_faces, std::span<const FaceId> holes) {
  std::vector<bool> out(static_cast<std::size_t>(num_faces), false);
  for (const FaceId f : holes)
    out[static_cast<std::size_t>(f.value)] = true;
  return out;
}

bool has_segments(const Lines& lines) {
  return !lines.segments.empty();
}

}  // namespace

std::vector<FaceCategory> classify_faces(const Topology& topology) {
  const Adjacency adjacency(topology);
  std::vector<FaceCategory> result;
  for (int f = 0; f < topology.num_faces(); ++f)
    result.push_back(classify(adjacency, FaceId(f)));
  return result;
}

std::vector<VertexId> extraordinary_vertices(const Topology& topology) {
  const Adjacency adjacency(topology);
  std::vector<VertexId> result;
  for (int v = 0; v < topology.num_vertices(); ++v)
    if (is_extraordinary(adjacency, VertexId(v))) result.emplace_back(v);
  return result;
}

Lines edge_lines(const Topology& topology, std::span<const Vec3> points,
                 std::span<const FaceId> holes) {
  LIMES_ASSERT(static_cast<int>(points.size()) >= topology.num_vertices());
  Lines lines;
  lines.points.assign(points.begin(), points.end());
  const std::vector<bool> hole = are_holes(topology.num_faces(), holes);
  for (int f = 0; f < topology.num_faces(); ++f) {
    if (hole[static_cast<std::size_t>(f)]) continue;
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [a, b] = std::minmax({face[i].value, face[(i + 1) % face.size()].value});
      lines.segments.push_back({a, b});
    }
  }
  std::sort(lines.segments.begin(), lines.segments.end());
  lines.segments.erase(std::unique(lines.segments.begin(), lines.segments.end()),
                       lines.segments.end());
  return lines;
}

Figure scene_figure(const Scene& scene, const PictureOptions& options) {
  const PictureSize size = options.direction ? options.size : size_for_plane(scene, options.size);
  Figure figure;
  const Camera camera = camera_for(scene, options, size);
  figure.image = render(scene, camera, {.size = size, .density = options.density});
  if (options.direction) {
    constexpr double margin = 10;
    figure.image = trimmed(figure.image, scene.background,
                           static_cast<int>(std::lround(margin * options.density)));
    if (options.axes) figure.axes = camera.axes;
  }
  figure.density = options.density;
  figure.title = options.title;
  figure.caption = options.caption;
  return figure;
}

Figure control_mesh_figure(const Mesh& mesh, const PictureOptions& options) {
  const std::vector<FaceCategory> categories = classify_faces(mesh.topology);
  const Triangulation cells = triangulate(mesh.topology, mesh.points.span());
  Surface surface;
  surface.points = mesh.points.vector();
  surface.shading = options.direction ? Shading::lit : Shading::flat;
  const std::vector<bool> hole = are_holes(mesh.topology.num_faces(), mesh.tags.holes);
  std::array<bool, category_looks.size()> occurs{};
  for (std::size_t t = 0; t < cells.triangles.size(); ++t) {
    const auto face = static_cast<std::size_t>(cells.source[t]);
    if (hole[face]) continue;
    const auto category = static_cast<std::size_t>(categories[face]);
    surface.triangles.push_back(cells.triangles[t]);
    surface.triangle_colours.push_back(category_looks[category].colour);
    occurs[category] = true;
  }
  Scene scene;
  scene.surfaces.push_back(std::move(surface));
  scene.lines.push_back(edge_lines(mesh.topology, mesh.points.span()));
  scene.lines.back().width = 1.3;
  Markers markers;
  for (const VertexId v : extraordinary_vertices(mesh.topology))
    markers.points.push_back(mesh.points[v]);
  scene.markers.push_back(markers);

  Figure figure = scene_figure(scene, options);
  for (std::size_t c = 0; c < category_looks.size(); ++c) {
    if (occurs[c])
      figure.legend.push_back(
          {.label = category_looks[c].label, .colour = category_looks[c].colour});
  }
  if (!markers.points.empty())
    figure.legend.push_back({.label = "extraordinary vertex",
                             .kind = LegendEntry::Kind::marker,
                             .colour = palette::paper});
  return figure;
}

FieldPicture corner_field(const Topology& topology, std::span<const Vec3> points,
                          std::vector<double> values, std::span<const FaceId> holes) {
  FieldPicture out;
  out.values = std::move(values);
  const std::vector<bool> hole = are_holes(topology.num_faces(), holes);
  for (int f = 0; f < topology.num_faces(); ++f) {
    const int first = static_cast<int>(out.points.size());
    for (const VertexId v : topology.face(FaceId(f)))
      out.points.push_back(points[static_cast<std::size_t>(v.value)]);
    if (hole[static_cast<std::size_t>(f)]) continue;
    for (int k = 2; k < topology.face_size(FaceId(f)); ++k)
      out.triangles.push_back({first, first + k - 1, first + k});
  }
  return out;
}

Scene field_scene(const FieldPicture& field, const ColourScale& scale, bool in_space) {
  if (field.values.size() != field.points.size())
    throw InputError("picture: {} values for {} points", field.values.size(), field.points.size());
  Surface surface;
  surface.points = field.points;
  surface.triangles = field.triangles;
  surface.values = field.values;
  surface.scale = scale;
  surface.shading = in_space ? Shading::faint : Shading::flat;
  if (in_space)
    surface.normals =
        field.normals.empty() ? smooth_normals(field.points, field.triangles) : field.normals;
  Scene scene;
  scene.surfaces.push_back(std::move(surface));
  for (const Lines* lines : {&field.behind, &field.mesh_lines, &field.borders})
    if (has_segments(*lines)) scene.lines.push_back(*lines);
  return scene;
}

Figure field_figure(const FieldPicture& field, const PictureOptions& options) {
  const Range all = range_of(field.values);
  ColourBar bar{.scale = field.scale ? *field.scale
                                     : scale_for(robust_range_of(field.values, field.outliers)),
                .quantity = field.quantity,
                .unit = field.unit};
  const double rounding = 1e-9 * std::max(std::abs(bar.scale.low), std::abs(bar.scale.high));
  bar.tip_below = all.low < bar.scale.low - rounding;
  bar.tip_above = all.high > bar.scale.high + rounding;
  Figure figure =
      scene_figure(field_scene(field, bar.scale, options.direction.has_value()), options);
  figure.bar = std::move(bar);
  return figure;
}

Figure surface_figure(const SurfacePicture& picture, const PictureOptions& options) {
  Surface surface;
  surface.points = picture.points;
  surface.triangles = picture.triangles;
  surface.normals =
      picture.normals.empty() ? smooth_normals(picture.points, picture.triangles) : picture.normals;
  Scene scene;
  scene.surfaces.push_back(std::move(surface));
  if (has_segments(picture.control_mesh)) scene.lines.push_back(picture.control_mesh);
  PictureOptions seen = options;
  if (!seen.direction) seen.direction = default_direction();
  Figure figure = scene_figure(scene, seen);
  if (has_segments(picture.control_mesh))
    figure.legend.push_back({.label = "control mesh",
                             .kind = LegendEntry::Kind::line,
                             .colour = picture.control_mesh.colour,
                             .width = picture.control_mesh.width});
  return figure;
}

}  // namespace limes
