#include "limes/study/shell_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "limes/report/ticks.h"
#include "limes/study/result_pictures.h"
#include "limes/study/shell_layers.h"

namespace limes {
namespace {

std::vector<double> values_of(const std::vector<ShellState>& states, double LayerStress::*layer) {
  std::vector<double> out;
  out.reserve(states.size());
  for (const ShellState& s : states)
    out.push_back(s.von_mises.*layer);
  return out;
}

/// From 0 to the largest value, or without the half percent of the elements in which it is largest where that
/// is a peak: under a point load or in a corner.
ColourScale common_scale(const std::vector<double>& top, const std::vector<double>& bottom) {
  const auto high = [&](double outliers) {
    return std::max(robust_range_of(top, outliers).high, robust_range_of(bottom, outliers).high);
  };
  constexpr double peak = 1.5;
  const double largest = high(0), most = high(0.005);
  return {.low = 0, .high = largest > peak * most && most > 0 ? most : largest};
}

std::string point_text(const Vec3& p, double diagonal) {
  const auto shown = [&](double x) {
    return format_readable(std::abs(x) < 1e-9 * diagonal ? 0 : x, 4);
  };
  return fmt::format("({}, {}, {})", shown(p.x()), shown(p.y()), shown(p.z()));
}

/// In pixels of a picture.
struct SidesSeen {
  int top = 0, bottom = 0;
};

/// Draws the faces small, in one colour per side, and counts.
SidesSeen sides_seen(const ShellModel& model) {
  constexpr std::array colours{palette::red, palette::green};  // top, bottom
  const PictureOptions options;
  FieldPicture faces = corner_field(model.mesh->topology, model.mesh->points.span(), {});
  Scene scene;
  Surface& surface = scene.surfaces.emplace_back();
  surface.points = std::move(faces.points);
  surface.triangles = std::move(faces.triangles);
  surface.shading = Shading::flat;
  const Camera camera = fit_camera(scene, shell_view_direction(), options.up,
                                   static_cast<double>(options.size.width) / options.size.height);
  for (const auto& [a, b, c] : surface.triangles) {
    const auto at = [&](int i) { return surface.points[static_cast<std::size_t>(i)]; };
    const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
    surface.triangle_colours.push_back(colours[normal.dot(camera.eye - at(a)) > 0 ? 0 : 1]);
  }
  const Image image = render(scene, camera, {.size = options.size, .density = 0.5, .samples = 1});
  SidesSeen out;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const auto is = [&](const Colour& c) {
        return std::ranges::equal(image.pixel(x, y), to_bytes(c));
      };
      out.top += is(colours[0]) ? 1 : 0;
      out.bottom += is(colours[1]) ? 1 : 0;
    }
  return out;
}

std::string text_of(const SidesSeen& seen) {
  constexpr double little = 0.001;  // pixels along an outline
  const std::string first = "Top is the side that the faces' normals point to; this view shows ";
  if (seen.top + seen.bottom == 0) return first + "neither side.";
  if (seen.bottom < little * seen.top) return first + "the top.";
  if (seen.top < little * seen.bottom) return first + "the bottom.";
  return first + "both sides.";
}

}  // namespace

ShellPictures::ShellPictures(const ShellResult& result)
    : result_(result),
      edges_(edges_of_pieces(result.model)),
      sides_(text_of(sides_seen(result.model))) {
  const std::vector<ShellState> states = states_at_centres(result.model, result.solution);
  top_ = values_of(states, &LayerStress::top);
  bottom_ = values_of(states, &LayerStress::bottom);
  stress_scale_ = common_scale(top_, bottom_);
}

void ShellPictures::add_lines(const std::vector<Vec3>& points, FieldPicture& field) const {
  field.borders = {.points = points, .segments = edges_.borders, .width = 1.4};
  if (result_.model.mesh->topology.num_faces() < most_faces_with_sides)
    field.mesh_lines = {.points = points, .segments = edges_.inside, .width = 0.4};
}

Figure ShellPictures::displacement() const {
  const ShellModel& model = result_.model;
  const Topology& t = model.mesh->topology;
  std::vector<double> length;
  for (int v = 0; v < t.num_vertices(); ++v)
    length.push_back(result_.solution.u.segment<3>(6 * v).stableNorm());
  const double factor = exaggeration(range_of(length).high, model.diagonal);
  const std::vector<Vec3>& points = model.mesh->points.vector();
  std::vector<Vec3> moved = points;
  for (int v = 0; v < t.num_vertices(); ++v)
    moved[static_cast<std::size_t>(v)] += factor * result_.solution.u.segment<3>(6 * v);
  std::vector<double> values;
  for (int i = 0; i < t.num_corners(); ++i)
    values.push_back(length[static_cast<std::size_t>(t.corner(HalfedgeId(i)).value)]);
  FieldPicture field = corner_field(t, moved, std::move(values));
  field.scale = ColourScale{.low = 0, .high = range_of(length).high};
  field.quantity = "|u|";
  field.unit = model.problem.units.length;
  add_lines(moved, field);
  field.behind = {
      .points = points, .segments = edges_.borders, .width = 1.0, .colour = palette::muted};
  const std::string times = factor == 1 ? "" : format_readable(factor) + " times ";
  return field_figure(field, {.title = "Length of the displacement",
                              .caption = "Displacements are drawn " + times +
                                         "as large as they are; grey: the borders before.",
                              .direction = shell_view_direction(),
                              .axes = true});
}

FieldPicture ShellPictures::stress_field(const std::vector<double>& values) const {
  const ShellModel& model = result_.model;
  const Topology& t = model.mesh->topology;
  std::vector<double> at_corners;
  for (int f = 0; f < t.num_faces(); ++f)
    at_corners.insert(at_corners.end(), static_cast<std::size_t>(t.face_size(FaceId(f))),
                      values[static_cast<std::size_t>(f)]);
  FieldPicture field = corner_field(t, model.mesh->points.span(), std::move(at_corners));
  field.normals = model.director.vector();
  add_lines(model.mesh->points.vector(), field);
  field.quantity = "σ_{vM}";
  field.unit = stress_unit(model.problem.units);
  field.scale = stress_scale_;
  return field;
}

std::string ShellPictures::largest_text(const std::vector<double>& stress) const {
  const auto largest = std::max_element(stress.begin(), stress.end());
  if (!(*largest > 0)) return "No stress.";
  const FaceId where(static_cast<int>(largest - stress.begin()));
  const ShellModel& model = result_.model;
  const UnitSettings& units = model.problem.units;
  const std::string point = point_text(model.quad(where).position(Vec2::Zero()), model.diagonal);
  return fmt::format("Largest: {} at {}.", with_unit(format_readable(*largest), stress_unit(units)),
                     with_unit(point, units.length));
}

Figure ShellPictures::von_mises(ShellSide side) const {
  const std::vector<double>& values = side == ShellSide::top ? top_ : bottom_;
  return field_figure(stress_field(values),
                      {.title = fmt::format("Von Mises stress at the {}",
                                            side == ShellSide::top ? "top" : "bottom"),
                       .caption = largest_text(values) + " " + sides_,
                       .direction = shell_view_direction(),
                       .axes = true});
}

std::optional<View3d> ShellPictures::view() const {
  if (result_.model.mesh->topology.num_faces() > most_faces_to_turn) return std::nullopt;
  FieldPicture field = stress_field(top_);
  field.mesh_lines = {};  // lines have one width there, however fine the mesh
  return View3d{.scene = field_scene(field, stress_scale_, true),
                .direction = shell_view_direction(),
                .description = "Von Mises stress at the top"};
}

}  // namespace limes
