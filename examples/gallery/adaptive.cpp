// Local refinement: docs/theory/local-refinement.md.

#include <fmt/core.h>

#include <algorithm>

#include "drawing.h"
#include "limes/mesh/shapes.h"
#include "limes/report/pictures.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/schemes.h"
#include "pictures.h"

namespace gallery {

using namespace limes;

namespace {

/// Four times: leaves with all corners in a ball, which has half the radius each time.
Forest refined_to(const Mesh& control, const Vec3& point, double radius, SplitUnit unit) {
  Forest forest(control, find_scheme("kobbelt"), {}, unit);
  for (int round = 0; round < 4; ++round, radius /= 2) {
    std::vector<FaceId> marked;
    for (const FaceId f : forest.leaves()) {
      const auto corners = forest.corners(f);
      if (std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
            return (forest.nodes().position(v) - point).norm() < radius;
          }))
        marked.push_back(f);
    }
    forest.refine(marked);
  }
  return forest;
}

Scene scene_of(const ForestMesh& made) {
  Scene scene;
  scene.surfaces.push_back(surface_of(made.mesh, Normals::smooth));
  scene.lines.push_back(edge_lines(made.mesh.topology, made.mesh.points.span()));
  scene.lines.back().width = 0.7;
  Markers& hanging = scene.markers.emplace_back();
  for (const HangingVertex& h : made.hanging)
    hanging.points.push_back(made.mesh.points[h.vertex]);
  hanging.size = 4;
  hanging.fill = hanging.edge = tag_colour;
  return scene;
}

FigureGrid closures(const Settings& settings) {
  const Mesh control = shapes::torus(12, 8);
  const auto highest = std::max_element(
      control.points.begin(), control.points.end(), [](const Vec3& a, const Vec3& b) {
        return a.z() + 0.3 * a.x() - 0.3 * a.y() < b.z() + 0.3 * b.x() - 0.3 * b.y();
      });
  const double radius = 0.9 * (control.points[VertexId(0)] - Vec3(0, 0, 0)).norm();
  FigureGrid grid{.columns = 3, .title = "Refined towards a point, kobbelt on a torus of 96 quads"};
  const auto add = [&](Closure closure, SplitUnit unit, const char* title) {
    Forest forest = refined_to(control, *highest, radius, unit);
    const ForestMesh made = forest_mesh(forest, closure);
    const Scene scene = scene_of(made);
    const Viewer viewer(
        scene,
        {.direction = Vec3(-0.35, 0.75, -0.85), .size = {300, 230}, .density = settings.density});
    grid.figures.push_back(
        viewer.figure(scene, title, fmt::format("{} faces", made.mesh.topology.num_faces())));
    if (!made.hanging.empty())
      grid.figures.back().legend = {{"hanging vertex", LegendEntry::Kind::marker, tag_colour}};
  };
  add(Closure::conforming, SplitUnit::families, "conforming");
  add(Closure::triangles, SplitUnit::faces, "triangles");
  add(Closure::hanging, SplitUnit::faces, "hanging");
  return grid;
}

}  // namespace

std::vector<Picture> adaptive_pictures(const Settings& settings) {
  return {{"local-refinement", closures(settings)}};
}

}  // namespace gallery
