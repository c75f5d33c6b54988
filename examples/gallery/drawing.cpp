#include "drawing.h"

#include <cmath>
#include <numbers>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/triangulate.h"
#include "limes/report/pictures.h"

namespace gallery {

using namespace limes;

namespace {

Vec3 area_vector(const Surface& surface, const std::array<int, 3>& triangle) {
  const auto at = [&](int i) { return surface.points[static_cast<std::size_t>(i)]; };
  return 0.5 * (at(triangle[1]) - at(triangle[0])).cross(at(triangle[2]) - at(triangle[0]));
}

/// Every triangle gets corners of its own, each with the sum of the area vectors of those triangles
/// at its vertex that do not meet it in a sharp edge.
Surface smoothly_shaded(const Surface& surface) {
  std::vector<Vec3> areas;
  std::vector<std::vector<int>> at_vertex(surface.points.size());
  for (const auto& triangle : surface.triangles) {
    for (const int v : triangle)
      at_vertex[static_cast<std::size_t>(v)].push_back(static_cast<int>(areas.size()));
    areas.push_back(area_vector(surface, triangle));
  }
  const double least_cosine = std::cos(sharp_angle * std::numbers::pi / 180);
  Surface shaded;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const int first = static_cast<int>(shaded.points.size());
    shaded.triangles.push_back({first, first + 1, first + 2});
    for (const int v : surface.triangles[t]) {
      Vec3 normal = Vec3::Zero();
      for (const int other : at_vertex[static_cast<std::size_t>(v)]) {
        const Vec3& area = areas[static_cast<std::size_t>(other)];
        if (area.dot(areas[t]) >= least_cosine * area.norm() * areas[t].norm()) normal += area;
      }
      shaded.points.push_back(surface.points[static_cast<std::size_t>(v)]);
      shaded.normals.push_back(normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::Zero()));
    }
  }
  return shaded;
}

}  // namespace

Surface surface_of(const Mesh& mesh, Normals normals) {
  Surface surface;
  surface.points = mesh.points.vector();
  surface.triangles = triangulate(mesh.topology, mesh.points.span()).triangles;
  if (normals == Normals::smooth) surface = smoothly_shaded(surface);
  surface.colour = mix(palette::clay, palette::paper, 0.35F);
  return surface;
}

Lines tagged_edges(const Mesh& mesh) {
  Lines lines;
  lines.points = mesh.points.vector();
  for (const CreaseTag& crease : mesh.tags.creases)
    lines.segments.push_back({crease.a.value, crease.b.value});
  lines.width = 2.4;
  lines.colour = tag_colour;
  return lines;
}

Markers tagged_vertices(const Mesh& mesh) {
  Markers markers;
  for (const CornerTag& corner : mesh.tags.corners)
    markers.points.push_back(mesh.points[corner.vertex]);
  markers.size = 8;
  markers.fill = tag_colour;
  markers.edge = palette::paper;
  return markers;
}

Scene control_scene(const Mesh& mesh) {
  Scene scene;
  scene.surfaces.push_back(surface_of(mesh, Normals::facets));
  scene.lines.push_back(edge_lines(mesh.topology, mesh.points.span()));
  scene.lines.back().width = 0.9;
  scene.lines.push_back(tagged_edges(mesh));
  scene.markers.push_back(tagged_vertices(mesh));
  return scene;
}

Scene surface_scene(const Mesh& mesh) {
  Scene scene;
  scene.surfaces.push_back(surface_of(mesh, Normals::smooth));
  scene.lines.push_back(tagged_edges(mesh));
  scene.markers.push_back(tagged_vertices(mesh));
  return scene;
}

std::vector<LegendEntry> tag_legend(const Mesh& mesh) {
  std::vector<LegendEntry> legend;
  if (!mesh.tags.creases.empty())
    legend.push_back({"tagged edge", LegendEntry::Kind::line, tag_colour, {}, 2.4});
  if (!mesh.tags.corners.empty())
    legend.push_back({"tagged vertex", LegendEntry::Kind::marker, tag_colour});
  return legend;
}

Viewer::Viewer(const Scene& first, const View& view)
    : view_(view),
      camera_(fit_camera(first, view.direction, view.up,
                         static_cast<double>(view.size.width) / view.size.height)) {}

Figure Viewer::figure(const Scene& scene, std::string title, std::string caption) const {
  Figure figure;
  figure.image = render(scene, camera_, {.size = view_.size, .density = view_.density});
  figure.density = view_.density;
  figure.title = std::move(title);
  figure.caption = std::move(caption);
  return figure;
}

Figure plane_figure(const Scene& scene, const View& view, std::string title, std::string caption) {
  return scene_figure(scene, {.title = std::move(title),
                              .caption = std::move(caption),
                              .size = view.size,
                              .density = view.density});
}

}  // namespace gallery
