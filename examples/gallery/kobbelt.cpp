// Figures 5 and 14 of [kobbelt_1996].

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "drawing.h"
#include "limes/io/io.h"
#include "limes/mesh/shapes.h"
#include "limes/report/pictures.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "pictures.h"

namespace gallery {

using namespace limes;

namespace {

Mesh refined(const Mesh& mesh, int levels) {
  return refine(mesh, find_scheme("kobbelt"), {.levels = levels});
}

// Figure 5: sharp features ------------------------------------------------------------------------

/// A bulging leaf of 4 x 4 quads: its boundary is smooth but for the two tips.
Mesh leaf() {
  Mesh mesh = shapes::grid(4, 4);
  for (Vec3& x : mesh.points) {
    const double along = (x.x() + x.y()) / 4 - 1;  // -1 and 1 at the tips
    const double across = (x.x() - x.y()) / 4;
    const double width = 1 - std::abs(along);  // |across| there
    const double rim = width > 0 ? across / width : 1;
    x = Vec3(1.9 * along, 1.4 * across * (1 + std::abs(along)),
             0.3 * along * along + 0.55 * (1 - along * along) * (1 - rim * rim));
  }
  return mesh;
}

/// A roof of 6 x 4 quads with a curved ridge, whose edges are tagged.
Mesh roof() {
  Mesh mesh = shapes::grid(6, 4);
  for (Vec3& x : mesh.points) {
    const double side = x.x() - 3;
    const double along = x.y() / 2 - 1;
    x = Vec3(0.6 * side + 0.35 * along * along, 1.7 * along,
             1.1 * std::exp(-0.55 * std::abs(side)) - 0.25 * along * along);
  }
  for (int j = 0; j < 4; ++j)
    mesh.tags.creases.push_back(
        {VertexId(3 + 7 * j), VertexId(3 + 7 * (j + 1)), infinite_sharpness});
  return mesh;
}

/// A dome of five rings of 16 quads; the boundary above shrank to a point.
Mesh dome() {
  constexpr std::array radii{1.0, 1.12, 0.9, 0.5, 0.2, 0.0};
  Mesh mesh = shapes::cylinder(16, 5);
  for (Vec3& x : mesh.points) {
    const double radius = radii[static_cast<std::size_t>(std::lround(x.z()))];
    x = Vec3(radius * x.x(), radius * x.y(), 0.42 * x.z());
  }
  return mesh;
}

/// A refined net with the edges of the net it interpolates: every vertex of them is on the surface.
Scene through_scene(const Mesh& fine, const Mesh& control) {
  Scene scene = surface_scene(fine);
  scene.markers.clear();
  Markers vertices;
  vertices.points = control.points.vector();
  vertices.size = 4.5;
  vertices.fill = control_colour;
  vertices.edge = control_colour;
  scene.markers.push_back(std::move(vertices));
  return scene;
}

/// Vertices that the refined net has tagged and the control net has not: breakpoints.
Markers breakpoints(const Mesh& fine) {
  Markers markers = tagged_vertices(fine);
  markers.size = 9;
  markers.shape = MarkerShape::diamond;
  return markers;
}

LegendEntry control_vertex_legend() {
  return {"control vertex", LegendEntry::Kind::marker, control_colour};
}

struct Feature {
  std::string name;
  Mesh control;
  Vec3 direction;
};

FigureGrid sharp_features(const Settings& settings) {
  const std::vector<Feature> features{
      {"piecewise smooth boundary", leaf(), Vec3(-0.45, 0.75, -0.8)},
      {"crease", roof(), Vec3(-0.5, 0.75, -0.7)},
      {"cusp", dome(), Vec3(-0.5, 0.8, -0.3)}};
  FigureGrid grid{.columns = 3, .title = "Sharp features of interpolatory surfaces (Fig. 5)"};
  std::vector<Figure> below;
  for (const Feature& feature : features) {
    const Mesh fine = refined(feature.control, settings.steps(4));
    const Scene control = control_scene(feature.control);
    Scene through = through_scene(fine, feature.control);
    through.markers.push_back(breakpoints(fine));
    Scene both = control;  // both fit into the picture
    both.surfaces.push_back(through.surfaces.front());
    const Viewer viewer(
        both, {.direction = feature.direction, .size = {290, 240}, .density = settings.density});
    grid.figures.push_back(viewer.figure(
        control, feature.name, fmt::format("{} quads", feature.control.topology.num_faces())));
    below.push_back(viewer.figure(
        through, "",
        fmt::format("after {} steps: {} quads", settings.steps(4), fine.topology.num_faces())));
    below.back().legend = {
        control_vertex_legend(),
        {"breakpoint", LegendEntry::Kind::marker, tag_colour, MarkerShape::diamond}};
    if (!feature.control.tags.creases.empty()) {
      below.back().legend.push_back(tag_legend(feature.control).front());
    }
  }
  grid.figures.insert(grid.figures.end(), below.begin(), below.end());
  return grid;
}

// Figure 14: a complex shape ----------------------------------------------------------------------

FigureGrid complex_shape(const Settings& settings) {
  const Mesh control = read_mesh(settings.models / "menger.obj").mesh;
  const Scene first = control_scene(control);
  const Mesh twice = refined(control, settings.steps(2));
  const Mesh fine = refined(control, settings.steps(4));
  const Scene smooth = through_scene(fine, control);
  const View view{
      .direction = Vec3(-0.55, 0.75, -0.5), .size = {300, 300}, .density = settings.density};
  const Viewer viewer(smooth, view);
  FigureGrid grid{.columns = 3, .title = "A complex shape by interpolation (Fig. 14)"};
  const auto add = [&](const Scene& scene, const Mesh& mesh, const char* title) {
    grid.figures.push_back(
        viewer.figure(scene, title, fmt::format("{} quads", mesh.topology.num_faces())));
  };
  add(first, control, "control net");
  add(control_scene(twice), twice, "refined twice");
  add(smooth, fine, "refined four times");
  grid.figures.back().legend = {control_vertex_legend()};
  return grid;
}

}  // namespace

std::vector<Picture> kobbelt_pictures(const Settings& settings) {
  return {{"gallery-features", sharp_features(settings)},
          {"gallery-complex", complex_shape(settings)}};
}

}  // namespace gallery
