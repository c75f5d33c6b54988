#include "limes/study/result_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "limes/report/ticks.h"

namespace limes {
namespace {

/// One side of a tile: where it lies, its first grid point and the step to the next.
struct TileSide {
  int number;       ///< 0: v = 0, 1: u = 1, 2: v = 1, 3: u = 0
  bool on_element;  ///< part of the element's own side
  int start, step;
};

/// The sides of a tile with (n + 1)^2 points, u fastest.
std::array<TileSide, 4> sides_of(const ParameterTile& tile, int n) {
  const Vec2 low = tile.origin;
  const Vec2 high = tile.origin + Vec2::Constant(tile.size);
  return {{{0, low.y() == 0, 0, 1},
           {1, high.x() == 1, n, n + 1},
           {2, high.y() == 1, n * (n + 1), 1},
           {3, low.x() == 0, 0, n + 1}}};
}

/// The edge of a face that a side of one of its elements lies on; none between quadrants of a face.
HalfedgeId edge_at(const Topology& topology, const Element& element, int side) {
  const int size = topology.face_size(element.face);
  if (size == 4) return topology.halfedge(element.face, side);
  if (side == 0) return topology.halfedge(element.face, element.corner);
  if (side == 3) return topology.halfedge(element.face, (element.corner + size - 1) % size);
  return {};
}

/// More faces than this would hide the field under their borders.
constexpr std::size_t most_faces = 4000;

}  // namespace

ResultPictures::ResultPictures(const PlaneResult& result) : result_(result) {
  // Some 300,000 triangles, however many elements there are.
  const auto elements = static_cast<double>(result.model.space->elements().size());
  const int n = std::clamp(static_cast<int>(std::sqrt(150'000 / elements)), 2, 12);
  for_each_field_cell(result.model, result.solution, n, 3,
                      [&](const FieldCell& cell) { add(cell, n); });
}

void ResultPictures::add(const FieldCell& cell, int n) {
  const int first = static_cast<int>(points_.size());
  for (const PlaneState& s : cell.states) {
    points_.push_back(s.x);
    displacement_.push_back(s.u);
    stress_xx_.push_back(s.stress(0));
    von_mises_.push_back(s.von_mises);
  }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = first + j * (n + 1) + i;
      triangles_.push_back({v, v + 1, v + n + 2});
      triangles_.push_back({v, v + n + 2, v + n + 1});
    }
  add_borders(cell, first, n);
}

/// Of two neighbours, the one whose halfedge comes first has the border.
void ResultPictures::add_borders(const FieldCell& cell, int first, int n) {
  const SubdivisionSpace& space = *result_.model.space;
  const Adjacency& adjacency = result_.model.neighbours();
  const Element& element = space.elements()[static_cast<std::size_t>(cell.element)];
  for (const TileSide& side : sides_of(cell.tile, n)) {
    const HalfedgeId h = edge_at(space.mesh().topology, element, side.number);
    if (!side.on_element || !h.valid()) continue;
    const HalfedgeId own = result_.model.among_neighbours(h), twin = adjacency.twin(own);
    const bool outer = !twin.valid() || !space.has_element(adjacency.face(twin));
    if (!outer && twin < own && !result_.model.closed) continue;
    for (int k = 0, v = first + side.start; k < n; ++k, v += side.step) {
      borders_.push_back({v, v + side.step});
      if (outer) outline_.push_back({v, v + side.step});
    }
  }
}

Figure ResultPictures::stress(const std::vector<double>& values, const std::string& quantity,
                              const std::string& title) const {
  FieldPicture picture{points_, triangles_, values, quantity,
                       stress_unit(result_.model.problem.units)};
  picture.scale = scale_for(range_of(values));
  if (result_.model.space->elements().size() < most_faces) {
    // The sequential map is dark, the middle of the diverging one nearly white.
    const bool dark = picture.scale->map == &ColourMap::sequential();
    picture.mesh_lines = {.points = points_,
                          .segments = borders_,
                          .width = 0.5,
                          .colour = dark ? palette::paper : palette::muted,
                          .on_top = true};
  }
  return field_figure(picture, {.title = title});
}

Figure ResultPictures::stress_xx() const {
  return stress(stress_xx_, "σ_{xx}", "Stress in x");
}

Figure ResultPictures::von_mises() const {
  return stress(von_mises_, "σ_{vM}", "Von Mises stress");
}

Figure ResultPictures::deformed() const {
  std::vector<double> length;
  for (const Vec2& u : displacement_)
    length.push_back(u.stableNorm());
  const double diagonal = result_.model.diagonal;
  const double factor = exaggeration(range_of(length).high, diagonal);
  FieldPicture picture{points_, triangles_, length, "|u|", result_.model.problem.units.length};
  for (std::size_t i = 0; i < points_.size(); ++i)
    picture.points[i].head<2>() += factor * displacement_[i];
  picture.mesh_lines = {
      .points = picture.points, .segments = outline_, .width = 1.0, .on_top = true};
  Lines undeformed{.points = points_, .segments = outline_, .width = 1.0, .colour = palette::muted};
  for (Vec3& x : undeformed.points)
    x.z() -= 0.1 * diagonal;  // behind the deformed shape
  picture.behind = undeformed;
  const std::string times = factor == 1 ? "" : format_readable(factor) + " times ";
  return field_figure(picture, {.title = "Deformed shape",
                                .caption = "Displacements are drawn " + times +
                                           "as large as they are; grey: the outline "
                                           "before."});
}

double exaggeration(double largest, double diagonal) {
  if (!(largest > 0)) return 1;
  const double most = 0.1 * diagonal / largest;
  if (!std::isfinite(most)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most) return step * power;
  return power;
}

}  // namespace limes
