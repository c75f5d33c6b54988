// Local refinement: docs/theory/local-refinement.md.

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "drawing.h"
#include "limes/limit/forest_limits.h"
#include "limes/mesh/shapes.h"
#include "limes/report/pictures.h"
#include "limes/subdiv/bisection_forest.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/schemes.h"
#include "pictures.h"

namespace gallery {

using namespace limes;

namespace {

/// Splits, in each round, leaves with all corners in a ball, which shrinks from round to round.
void refine_to(LocalRefinement& forest, const Vec3& point, double radius, int rounds,
               double shrinks) {
  for (int round = 0; round < rounds; ++round, radius *= shrinks) {
    std::vector<FaceId> marked;
    for (const FaceId f : forest.leaves()) {
      const auto corners = forest.corners(f);
      if (std::all_of(corners.begin(), corners.end(),
                      [&](VertexId v) { return (forest.position(v) - point).norm() < radius; }))
        marked.push_back(f);
    }
    forest.refine(marked);
  }
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

/// The vertex that is seen best.
Vec3 towards_viewer(const Mesh& mesh) {
  return *std::max_element(
      mesh.points.begin(), mesh.points.end(), [](const Vec3& a, const Vec3& b) {
        return a.z() + 0.3 * a.x() - 0.3 * a.y() < b.z() + 0.3 * b.x() - 0.3 * b.y();
      });
}

void add_figure(const Settings& settings, const ForestMesh& made, const char* title,
                FigureGrid& grid) {
  const Scene scene = scene_of(made);
  const Viewer viewer(
      scene,
      {.direction = Vec3(-0.35, 0.75, -0.85), .size = {300, 230}, .density = settings.density});
  grid.figures.push_back(
      viewer.figure(scene, title, fmt::format("{} faces", made.mesh.topology.num_faces())));
  if (!made.hanging.empty())
    grid.figures.back().legend = {{"hanging vertex", LegendEntry::Kind::marker, tag_colour}};
}

FigureGrid closures(const Settings& settings) {
  const Mesh control = shapes::torus(12, 8);
  const Vec3 point = towards_viewer(control);
  const double radius = 0.9 * control.points[VertexId(0)].norm();
  FigureGrid grid{.columns = 3, .title = "Refined towards a point, kobbelt on a torus of 96 quads"};
  const auto add = [&](Closure closure, SplitUnit unit, const char* title) {
    Forest forest(control, find_scheme("kobbelt"), {}, unit);
    refine_to(forest, point, radius, 4, 0.5);
    add_figure(settings, forest_mesh(forest, closure), title, grid);
  };
  add(Closure::conforming, SplitUnit::families, "conforming");
  add(Closure::triangles, SplitUnit::faces, "triangles");
  add(Closure::hanging, SplitUnit::faces, "hanging");
  return grid;
}

/// The torus with its quads cut in two.
Mesh triangle_torus() {
  Mesh mesh = shapes::torus(12, 8);
  std::vector<VertexId> corners;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto v = mesh.topology.face(FaceId(f));
    corners.insert(corners.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
  }
  mesh.topology = Topology(mesh.topology.num_vertices(), 3, std::move(corners));
  return mesh;
}

FigureGrid triangles(const Settings& settings) {
  const Mesh control = triangle_torus();
  const double radius = 0.9 * control.points[VertexId(0)].norm();
  FigureGrid grid{.columns = 3, .title = "Refined towards a point, a torus of 192 triangles"};
  const auto by_loop = [&](Closure closure, const char* title) {
    const Scheme& loop = find_scheme("loop");
    Forest forest(control, loop, {}, SplitUnit::faces, forest_limits(loop));
    Mesh limit = control;
    for (int v = 0; v < limit.points.size(); ++v)
      limit.points[VertexId(v)] = forest.position(VertexId(v));
    refine_to(forest, towards_viewer(limit), radius, 4, 0.5);
    add_figure(settings, forest_mesh(forest, closure), title, grid);
  };
  by_loop(Closure::conforming, "loop, conforming: red and green");
  by_loop(Closure::hanging, "loop, hanging");
  BisectionForest halves(control);
  refine_to(halves, towards_viewer(control), radius, 8, std::numbers::sqrt2 / 2);
  add_figure(settings, forest_mesh(halves), "linear, bisected", grid);
  return grid;
}

}  // namespace

std::vector<Picture> adaptive_pictures(const Settings& settings) {
  return {{"local-refinement", closures(settings)},
          {"local-refinement-triangles", triangles(settings)}};
}

}  // namespace gallery
