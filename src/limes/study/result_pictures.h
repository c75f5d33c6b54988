#pragma once

#include "limes/report/pictures.h"
#include "limes/study/field_cells.h"
#include "limes/study/result_files.h"

namespace limes {

/// The pictures of a solution, made from one sampling of its fields.
class ResultPictures {
 public:
  /// Keeps a reference to the result.
  explicit ResultPictures(const PlaneResult& result);

  [[nodiscard]] Figure stress_xx() const;
  [[nodiscard]] Figure von_mises() const;
  /// The deformed shape, its displacements drawn as many times as large as the caption says, before the
  /// outline of the undeformed one.
  [[nodiscard]] Figure deformed() const;

 private:
  void add(const FieldCell& cell, int n);
  void add_borders(const FieldCell& cell, int first, int n);
  /// A field of the undeformed shape with the borders of the faces on it.
  [[nodiscard]] Figure stress(const std::vector<double>& values, const std::string& quantity,
                              const std::string& title) const;

  const PlaneResult& result_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Vec3> points_;
  std::vector<Vec2> displacement_;
  std::vector<double> stress_xx_, von_mises_;
  std::vector<std::array<int, 2>> borders_;  ///< along the sides of faces, each side once
  std::vector<std::array<int, 2>> outline_;  ///< those at the boundary of the domain
};

/// How many times as large displacements of at most `largest` are drawn on a model of this diagonal: 1, 2
/// or 5 times a power of ten, so that they are between 4 % and 10 % of it. 1 if nothing moves.
[[nodiscard]] double exaggeration(double largest, double diagonal);

}  // namespace limes
