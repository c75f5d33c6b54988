// Figures 5 to 11 of [velho_quasi48].

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <random>

#include "drawing.h"
#include "limes/io/io.h"
#include "limes/mesh/adjacency.h"
#include "limes/report/pictures.h"
#include "limes/subdiv/quasi_four_eight.h"
#include "meshes.h"
#include "pictures.h"

namespace gallery {

using namespace limes;

namespace {

Mesh after(const Mesh& mesh, int steps, const QuasiSmoothingRules& rules = {}) {
  return refine_quasi_four_eight(mesh, {.levels = steps, .rules = rules}).mesh;
}

std::string faces_after(const Mesh& mesh, int steps) {
  if (steps == 0) return fmt::format("control mesh: {} triangles", mesh.topology.num_faces());
  return fmt::format("{} step{}: {} triangles", steps, steps == 1 ? "" : "s",
                     mesh.topology.num_faces());
}

/// Vertices inside the surface by their number of edges: those of a 4-8 mesh and all others.
struct Valences {
  std::vector<Vec3> four, eight, other;
};
Valences valences(const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  Valences result;
  for (int v = 0; v < mesh.points.size(); ++v) {
    if (adjacency.is_boundary(VertexId(v))) continue;
    const int n = adjacency.valence(VertexId(v));
    (n == 4   ? result.four
     : n == 8 ? result.eight
              : result.other)
        .push_back(mesh.points[VertexId(v)]);
  }
  return result;
}

Markers valence_markers(std::vector<Vec3> points, double size, const Colour& fill) {
  Markers markers;
  markers.points = std::move(points);
  markers.size = size;
  markers.fill = fill;
  markers.edge_width = 1;
  return markers;
}

std::vector<LegendEntry> other_valence_legend() {
  return {{"inner vertex of a valence other than 4 and 8", LegendEntry::Kind::marker, tag_colour}};
}

// Figures 5 to 8: plane polygons ------------------------------------------------------------------

/// A regular n-gon on the unit circle as a fan of triangles; the middle is vertex 0.
Mesh fan(int n) {
  std::vector<Vec3> points{Vec3::Zero()};
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return from_triangles(std::move(points), triangles);
}

/// The inner edge to the right twice as long as the one to the left.
Mesh stretched_hexagon() {
  Mesh mesh = fan(6);
  for (Vec3& x : mesh.points)
    if (x.x() > 1e-9) x.x() *= 2;
  return mesh;
}

/// Radii of the corners in [1 - amplitude, 1 + amplitude], from a fixed seed.
Mesh perturbed_hexagon(double amplitude) {
  Mesh mesh = fan(6);
  std::mt19937 random(7);
  for (int v = 1; v <= 6; ++v) {
    const double unit = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    mesh.points[VertexId(v)] *= 1 + amplitude * (2 * unit - 1);
  }
  return mesh;
}

Figure fan_figure(const Mesh& control, int steps, const std::string& title, double density) {
  const Mesh mesh = after(control, steps);
  Scene scene;
  scene.lines.push_back(edge_lines(mesh.topology, mesh.points.span()));
  scene.lines.back().width = 1.0;
  scene.markers.push_back(valence_markers(valences(mesh).other, 8, tag_colour));
  Figure figure = plane_figure(scene, {.size = {280, 260}, .density = density}, title, "");
  figure.caption = fmt::format("{}; middle valence {}", faces_after(mesh, steps),
                               Adjacency(mesh.topology).valence(VertexId(0)));
  figure.legend = other_valence_legend();
  return figure;
}

FigureGrid fans(const Settings& settings) {
  FigureGrid grid{.columns = 4, .title = "Plane polygons under quasi-four-eight"};
  const auto add = [&](const Mesh& control, int steps, const std::string& title) {
    grid.figures.push_back(fan_figure(control, settings.steps(steps), title, settings.density));
  };
  for (const int n : {3, 4, 5, 6})
    add(fan(n), 6, fmt::format("Fig. 5{}: {} corners", "abcd"[n - 3], n));
  add(stretched_hexagon(), 0, "Fig. 6a: right half stretched");
  add(stretched_hexagon(), 6, "Fig. 6b");
  add(perturbed_hexagon(0.1), 6, "Fig. 7a: radii within 0.1");
  add(perturbed_hexagon(0.3), 6, "Fig. 7b: radii within 0.3");
  add(fan(12), 1, "Fig. 8a: 12 corners");
  add(fan(12), 5, "Fig. 8b");
  add(fan(9), 1, "Fig. 8c: 9 corners");
  add(fan(9), 5, "Fig. 8d");
  return grid;
}

// Figure 9: a torus -------------------------------------------------------------------------------

Scene torus_scene(const Mesh& mesh) {
  Scene scene = control_scene(mesh);
  const double size = mesh.points.size() < 500 ? 7 : 5;
  const Valences at = valences(mesh);
  scene.markers.push_back(valence_markers(at.four, size, palette::paper));
  scene.markers.push_back(valence_markers(at.eight, size, palette::ink));
  scene.markers.push_back(valence_markers(at.other, size, tag_colour));
  return scene;
}

std::vector<LegendEntry> torus_legend() {
  std::vector<LegendEntry> legend{{"valence 4", LegendEntry::Kind::marker, palette::paper},
                                  {"valence 8", LegendEntry::Kind::marker, palette::ink}};
  legend.push_back({"another valence", LegendEntry::Kind::marker, tag_colour});
  return legend;
}

FigureGrid torus(const Settings& settings) {
  const Mesh control = read_mesh(settings.models / "torus.obj").mesh;
  const Scene first = torus_scene(control);
  const Viewer viewer(
      first,
      {.direction = Vec3(-0.55, 0.75, -0.55), .size = {300, 220}, .density = settings.density});
  FigureGrid grid{.columns = 3, .title = "A torus becomes a regular 4-8 mesh"};
  for (const int wanted : {0, 2, 4}) {
    const int steps = settings.steps(wanted);
    const Mesh mesh = after(control, steps);
    const Valences at = valences(mesh);
    grid.figures.push_back(viewer.figure(
        torus_scene(mesh), fmt::format("Fig. 9{}", "abc"[wanted / 2]),
        fmt::format("{}; {} vertices of valence 4, {} of 8, {} others", faces_after(mesh, steps),
                    at.four.size(), at.eight.size(), at.other.size())));
    grid.figures.back().legend = torus_legend();
  }
  return grid;
}

// Figure 10: a head -------------------------------------------------------------------------------

FigureGrid head(const Settings& settings) {
  const Mesh control = read_mesh(settings.models / "nefertiti.off").mesh;
  const Viewer viewer(control_scene(control), {.direction = Vec3(0.45, 0.15, -1),
                                               .up = Vec3(0, 1, 0),
                                               .size = {300, 380},
                                               .density = settings.density});
  FigureGrid grid{.columns = 3, .title = "A head under quasi-four-eight"};
  const auto add = [&](const Scene& scene, const char* title, const std::string& caption) {
    grid.figures.push_back(viewer.figure(scene, title, caption));
  };
  add(control_scene(control), "Fig. 10a: control mesh",
      fmt::format("{} triangles", control.topology.num_faces()));
  const Mesh two = after(control, settings.steps(2));
  add(control_scene(two), "Fig. 10b", faces_after(two, settings.steps(2)));
  const Mesh nine = after(control, settings.steps(9));
  Scene flat;
  flat.surfaces.push_back(surface_of(nine, Normals::facets));
  add(flat, "Fig. 10c: flat shading", faces_after(nine, settings.steps(9)));
  return grid;
}

// Figure 11: a box with two open sides -------------------------------------------------------------

FigureGrid box(const Settings& settings) {
  const int steps = settings.steps(10);
  const View view{
      .direction = Vec3(-0.55, 0.85, -0.6), .size = {290, 290}, .density = settings.density};
  const Mesh boundary = read_mesh(settings.models / "box_boundary.obj").mesh;
  const Mesh edge = read_mesh(settings.models / "box_edge.obj").mesh;
  const Viewer viewer(control_scene(edge), view);
  FigureGrid grid{.columns = 3, .title = "A box with two open sides: what tags do"};
  const auto add = [&](const Mesh& mesh, const Scene& scene, const char* title, const char* what) {
    grid.figures.push_back(viewer.figure(
        scene, title, fmt::format("{}; {} triangles", what, mesh.topology.num_faces())));
    grid.figures.back().legend = tag_legend(mesh);
  };
  const QuasiSmoothingRules curves{QuasiBoundary::curve, QuasiTags::curves};
  const auto add_refined = [&](const Mesh& control, const QuasiSmoothingRules& rules,
                               const char* title, const char* what) {
    const Mesh mesh = after(control, steps, rules);
    Scene scene = surface_scene(mesh);
    scene.markers.clear();
    scene.markers.push_back(tagged_vertices(control));
    add(mesh, scene, title, what);
    grid.figures.back().legend = tag_legend(control);
  };
  add(boundary, control_scene(boundary), "Fig. 11a with the tags of b", "control mesh");
  add_refined(boundary, {}, "Fig. 11b: boundary tagged", "tags held");
  add_refined(without_tags(edge), {}, "without tags", "boundary along the normal");
  add(edge, control_scene(edge), "Fig. 11a with the tag of c", "control mesh");
  add_refined(edge, {}, "Fig. 11c: one inner edge tagged", "boundary along the normal");
  add_refined(edge, curves, "tags as curves", "--boundary curve --tags curves");
  return grid;
}

}  // namespace

std::vector<Picture> velho_pictures(const Settings& settings) {
  return {{"gallery-fans", fans(settings)},
          {"gallery-torus", torus(settings)},
          {"gallery-head", head(settings)},
          {"gallery-box", box(settings)}};
}

}  // namespace gallery
