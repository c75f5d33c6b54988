#include <cmath>

#include "limes/io/vtu.h"
#include "limes/study/field_cells.h"
#include "limes/study/result_files.h"

namespace limes {
namespace {

constexpr int degree = 3;  // displacements of regular elements are bicubic
constexpr int rings = 8;   // of cells around an extraordinary vertex

/// Collects the grid cell by cell; every cell has its own points, because stresses may jump.
class ResultGrid {
 public:
  explicit ResultGrid(const PlaneModel& model) : model_(model) {}

  void add(const FieldCell& cell) {
    const auto first = static_cast<std::int64_t>(grid_.points.size());
    std::vector<std::int64_t> ids;
    for (const auto& [i, j] : vtk_quad_points(degree)) {
      ids.push_back(first + static_cast<std::int64_t>(ids.size()));
      add_point(cell.states[static_cast<std::size_t>(j * (degree + 1) + i)]);
    }
    grid_.add_cell(VtkCell::lagrange_quad, ids);
    const auto e = static_cast<std::size_t>(cell.element);
    material_.push_back(model_.material_of_element[e]);
    face_.push_back(model_.space->elements()[e].face.value);
  }

  /// A field of the elements, given by face.
  void add_errors(const std::string& name, const std::vector<double>& squares) {
    std::vector<double> error;
    for (const std::int64_t face : face_)
      error.push_back(std::sqrt(squares[static_cast<std::size_t>(face)]));
    errors_.push_back({name, 1, std::move(error)});
  }

  VtuGrid take() {
    grid_.point_data = {{"displacement", 3, std::move(displacement_)},
                        {"stress", 3, std::move(stress_)},
                        {"strain", 3, std::move(strain_)},
                        {"von_mises", 1, std::move(von_mises_)}};
    grid_.cell_data = {{"material", 1, std::move(material_)}, {"face", 1, std::move(face_)}};
    for (VtuArray& field : errors_)
      grid_.cell_data.push_back(std::move(field));
    return std::move(grid_);
  }

 private:
  void add_point(const PlaneState& s) {
    grid_.points.push_back(s.x);
    displacement_.insert(displacement_.end(), {s.u.x(), s.u.y(), 0.0});
    stress_.insert(stress_.end(), {s.stress(0), s.stress(1), s.stress(2)});
    strain_.insert(strain_.end(), {s.strain(0), s.strain(1), s.strain(2)});
    von_mises_.push_back(s.von_mises);
  }

  const PlaneModel& model_;
  VtuGrid grid_;
  std::vector<double> displacement_, stress_, strain_, von_mises_;
  std::vector<std::int64_t> material_, face_;
  std::vector<VtuArray> errors_;
};

}  // namespace

void write_result_vtu(const ByteSink& sink, const PlaneResult& result) {
  ResultGrid grid(result.model);
  for_each_field_cell(result.model, result.solution, degree, rings,
                      [&](const FieldCell& cell) { grid.add(cell); });
  if (result.adaptive) grid.add_errors("error", result.adaptive->squares);
  if (result.adaptive && !result.adaptive->finer_squares.empty())
    grid.add_errors("error_against_finer", result.adaptive->finer_squares);
  write_vtu(sink, grid.take());
}

}  // namespace limes
