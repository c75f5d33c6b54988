// Every scheme on the same three models.

#include <fmt/core.h>

#include <optional>

#include "drawing.h"
#include "limes/io/io.h"
#include "limes/report/pictures.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "meshes.h"
#include "pictures.h"

namespace gallery {

using namespace limes;

namespace {

Mesh refined(const Mesh& mesh, const Scheme& scheme, int levels) {
  return refine(mesh, scheme, {.levels = levels});
}

struct Start {
  Mesh mesh;
  std::string how;  ///< what was done to the model; empty: nothing
};

/// The model as the scheme can take it.
Start start_for(const Scheme& scheme, const Mesh& model) {
  const int corners = model.topology.uniform_face_size();
  if (scheme.faces == FaceKind::triangles && corners != 3) {
    Mesh cut = triangulated(model);
    std::string how = fmt::format("cut into {} triangles, then ", cut.topology.num_faces());
    return {std::move(cut), std::move(how)};
  }
  if (scheme.faces == FaceKind::quads && corners != 4) {
    Mesh quads = refined(model, find_scheme("linear"), 1);
    std::string how = fmt::format("split into {} quads, then ", quads.topology.num_faces());
    return {std::move(quads), std::move(how)};
  }
  return {model, ""};
}

const Colour cut_colour = palette::series[1];

/// The control mesh, and in colour where it is cut for triangle schemes.
Figure control_figure(const Mesh& model, const Viewer& viewer) {
  Scene scene = control_scene(model);
  std::vector<LegendEntry> legend;
  if (model.topology.uniform_face_size() != 3) {
    const Mesh cut = triangulated(model);
    Lines lines = edge_lines(cut.topology, cut.points.span());
    lines.width = 0.7;
    lines.colour = cut_colour;
    scene.lines.insert(scene.lines.begin(), std::move(lines));
    legend.push_back({"cut for triangle schemes", LegendEntry::Kind::line, cut_colour, {}, 0.7});
  }
  Figure figure = viewer.figure(
      scene, "control mesh",
      fmt::format("{} faces, {} vertices", model.topology.num_faces(), model.points.size()));
  figure.legend = std::move(legend);
  return figure;
}

struct Refined {
  Mesh mesh;
  int levels = 0;
  /// Faces after one step more, if that adds hardly any or takes some away.
  std::optional<int> next = {};
};

/// As many steps as keep within `most_faces`, as long as each adds a quarter of the faces at least.
Refined refined_far(const Mesh& control, const Scheme& scheme, int most_faces) {
  Refined best{control, 0};
  for (int levels = 1;; ++levels) {
    Mesh next = refined(control, scheme, levels);
    const int before = best.mesh.topology.num_faces();
    const int after = next.topology.num_faces();
    if (after > most_faces) return best;
    if (4 * after < 5 * before) return {std::move(best.mesh), best.levels, after};
    best = {std::move(next), levels};
  }
}

std::string caption(const Mesh& control, const Start& start, const Refined& fine) {
  std::string text =
      fmt::format("{}{} steps, {} faces", start.how, fine.levels, fine.mesh.topology.num_faces());
  const std::optional<double> before = volume(control);
  const std::optional<double> after = volume(fine.mesh);
  if (before && after) text += fmt::format(", {:.0f} % of the volume", 100 * *after / *before);
  if (fine.next) text += fmt::format("; another step leaves {}", *fine.next);
  return text;
}

struct Model {
  std::string file, name;
  View view;
};

FigureGrid all_schemes_on(const Model& model, const Settings& settings) {
  const Mesh control = read_mesh(settings.models / model.file).mesh;
  View view = model.view;
  view.density = settings.density;
  const Viewer viewer(control_scene(control), view);
  FigureGrid grid{.columns = 3, .title = "Every scheme on the same control mesh: " + model.name};
  grid.figures.push_back(control_figure(control, viewer));
  for (const Scheme& scheme : all_schemes()) {
    const Start start = start_for(scheme, control);
    const Refined fine = refined_far(start.mesh, scheme, settings.most_faces);
    // No tags: the models have none, and breakpoints of kobbelt are shown elsewhere.
    grid.figures.push_back(viewer.figure(surface_scene(without_tags(fine.mesh)),
                                         std::string(scheme.name), caption(control, start, fine)));
  }
  return grid;
}

}  // namespace

std::vector<Picture> scheme_pictures(const Settings& settings) {
  const Model spot{"spot.obj", "Spot", {.direction = Vec3(-0.8, -0.35, 1), .up = Vec3(0, 1, 0)}};
  const Model tee{
      "pipe_tee.obj", "a pipe tee", {.direction = Vec3(0.4, -0.8, 0.55), .up = Vec3(-1, 0, 0)}};
  const Model cat{
      "cat_head.obj", "a cat's head", {.direction = Vec3(0.3, -0.2, -1), .up = Vec3(0, 1, 0)}};
  return {{"gallery-spot", all_schemes_on(spot, settings)},
          {"gallery-tee", all_schemes_on(tee, settings)},
          {"gallery-cat", all_schemes_on(cat, settings)}};
}

}  // namespace gallery
