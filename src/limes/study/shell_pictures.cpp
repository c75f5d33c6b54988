#include "limes/study/shell_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "limes/report/ticks.h"
#include "limes/study/result_pictures.h"
#include "limes/study/shell_pieces.h"

namespace limes {
namespace {

/// With more faces than this, their sides would hide the colours.
constexpr int most_faces = 20'000;

std::vector<double> values_of(const std::vector<ShellState>& states, double LayerStress::*layer) {
  std::vector<double> out;
  out.reserve(states.size());
  for (const ShellState& s : states)
    out.push_back(s.von_mises.*layer);
  return out;
}

/// From 0 to the largest value, or without the half percent of the elements in which it is largest where that
/// is a peak: under a point load or in a corner.
ColourScale stress_scale(const std::vector<double>& top, const std::vector<double>& bottom) {
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

/// Draws the sides of the elements and, darker, the borders of smooth pieces.
void add_lines(const ShellModel& model, const std::vector<Vec3>& points, FieldPicture& field) {
  const PieceEdges edges = edges_of_pieces(model);
  field.borders = {.points = points, .segments = edges.borders, .width = 1.4};
  if (model.mesh->topology.num_faces() < most_faces)
    field.mesh_lines = {.points = points, .segments = edges.inside, .width = 0.4};
}

}  // namespace

ShellPictures::ShellPictures(const ShellResult& result) : result_(result) {
  const std::vector<ShellState> states = states_at_centres(result.model, result.solution);
  top_ = values_of(states, &LayerStress::top);
  bottom_ = values_of(states, &LayerStress::bottom);
  stress_scale_ = stress_scale(top_, bottom_);
}

FieldPicture ShellPictures::surface(const std::vector<Vec3>& points) const {
  const ShellModel& model = result_.model;
  const Topology& t = model.mesh->topology;
  FieldPicture out;
  for (int f = 0; f < t.num_faces(); ++f) {
    const HalfedgeId start = t.halfedge(FaceId(f), 0);
    for (int k = 0; k < t.face_size(FaceId(f)); ++k) {
      const HalfedgeId corner(start.value + k);
      out.points.push_back(points[static_cast<std::size_t>(t.corner(corner).value)]);
      out.normals.push_back(model.director[corner]);
      if (k >= 2) out.triangles.push_back({start.value, corner.value - 1, corner.value});
    }
  }
  return out;
}

Figure ShellPictures::displacement() const {
  const ShellModel& model = result_.model;
  const Topology& t = model.mesh->topology;
  std::vector<double> length;
  for (int v = 0; v < t.num_vertices(); ++v)
    length.push_back(result_.solution.u.segment<3>(6 * v).norm());
  const double factor = exaggeration(range_of(length).high, model.diagonal);
  const std::vector<Vec3>& points = model.mesh->points.vector();
  std::vector<Vec3> moved = points;
  for (int v = 0; v < t.num_vertices(); ++v)
    moved[static_cast<std::size_t>(v)] += factor * result_.solution.u.segment<3>(6 * v);
  FieldPicture field = surface(moved);
  field.normals.clear();  // those of the undeformed shape
  for (int i = 0; i < t.num_corners(); ++i)
    field.values.push_back(length[static_cast<std::size_t>(t.corner(HalfedgeId(i)).value)]);
  field.scale = ColourScale{.low = 0, .high = range_of(length).high};
  field.quantity = "|u|";
  field.unit = model.problem.units.length;
  const PieceEdges edges = edges_of_pieces(model);
  add_lines(model, moved, field);
  field.behind = {
      .points = points, .segments = edges.borders, .width = 1.0, .colour = palette::muted};
  const std::string times = factor == 1 ? "" : format_readable(factor) + " times ";
  return field_figure(field, {.title = "Length of the displacement",
                              .caption = "Displacements are drawn " + times +
                                         "as large as they are; grey: the borders before.",
                              .direction = shell_view_direction(),
                              .axes = true});
}

std::string ShellPictures::sides_seen() const {
  const ShellModel& model = result_.model;
  double top = 0, bottom = 0;  // areas as they are projected, hidden or not
  for (int f = 0; f < model.mesh->topology.num_faces(); ++f) {
    const Vec3 normal = model.quad(FaceId(f)).area_normal(Vec2::Zero());
    const double towards_eye = -normal.dot(shell_view_direction());
    (towards_eye > 0 ? top : bottom) += std::abs(towards_eye);
  }
  constexpr double little = 0.001;
  const std::string first = "Top is the side that the faces' normals point to; ";
  if (bottom < little * top) return first + "this view shows the top.";
  if (top < little * bottom) return first + "this view shows the bottom.";
  return first + "this view shows both sides.";
}

FieldPicture ShellPictures::stress_field(const std::vector<double>& values) const {
  const ShellModel& model = result_.model;
  const Topology& t = model.mesh->topology;
  FieldPicture field = surface(model.mesh->points.vector());
  for (int f = 0; f < t.num_faces(); ++f)
    field.values.insert(field.values.end(), static_cast<std::size_t>(t.face_size(FaceId(f))),
                        values[static_cast<std::size_t>(f)]);
  add_lines(model, model.mesh->points.vector(), field);
  field.quantity = "σ_{vM}";
  field.unit = stress_unit(model.problem.units);
  field.scale = stress_scale_;
  return field;
}

Figure ShellPictures::von_mises(ShellSide side) const {
  const std::vector<double>& values = side == ShellSide::top ? top_ : bottom_;
  const FieldPicture field = stress_field(values);
  const auto largest = std::max_element(values.begin(), values.end());
  const FaceId where(static_cast<int>(largest - values.begin()));
  return field_figure(
      field,
      {.title =
           fmt::format("Von Mises stress at the {}", side == ShellSide::top ? "top" : "bottom"),
       .caption = fmt::format(
           "Largest: {} at {}. {}", with_unit(format_readable(*largest), field.unit),
           point_text(result_.model.quad(where).position(Vec2::Zero()), result_.model.diagonal),
           sides_seen()),
       .direction = shell_view_direction(),
       .axes = true});
}

std::optional<View3d> ShellPictures::view() const {
  constexpr int most_faces_to_turn = 5'000;  // some 200 bytes of the report each
  if (result_.model.mesh->topology.num_faces() > most_faces_to_turn) return std::nullopt;
  FieldPicture field = stress_field(top_);
  field.mesh_lines = {};  // lines have one width there, however fine the mesh
  return View3d{.scene = field_scene(field, stress_scale_, true),
                .direction = shell_view_direction(),
                .description = "Von Mises stress at the top"};
}

}  // namespace limes
