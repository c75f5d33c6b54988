#pragma once

#include "limes/report/pictures.h"
#include "limes/report/view3d.h"
#include "limes/study/shell_layers.h"
#include "limes/study/shell_result.h"

namespace limes {

/// From where shells are seen.
[[nodiscard]] inline Vec3 shell_view_direction() {
  return {-1, -1.5, -1};
}

enum class ShellSide {
  top,  ///< the one that the directors point to
  bottom
};

/// The pictures of a solved shell, in space, with the axes of the view beside them. Borders of smooth pieces
/// (boundary, seams, kinks, changes of the material) are drawn darker than sides of elements.
class ShellPictures {
 public:
  /// Keeps a reference to the result.
  explicit ShellPictures(const ShellResult& result);

  /// Length of the displacement, on the deformed shape, before the borders of the undeformed one.
  [[nodiscard]] Figure displacement() const;
  /// One value per element, at its centre: nothing is averaged. Both sides have the same scale, from 0.
  [[nodiscard]] Figure von_mises(ShellSide side) const;
  /// The stress at the top as a model to turn; none of a mesh so fine that it would make the report large.
  [[nodiscard]] std::optional<View3d> view() const;

 private:
  /// Triangles with a corner of their own at every corner of a face; values are still missing.
  [[nodiscard]] FieldPicture surface(const std::vector<Vec3>& points) const;
  [[nodiscard]] FieldPicture stress_field(const std::vector<double>& values) const;
  [[nodiscard]] std::string sides_seen() const;

  const ShellResult& result_;
  std::vector<double> top_, bottom_;  ///< von Mises stress per face
  ColourScale stress_scale_;
};

}  // namespace limes
