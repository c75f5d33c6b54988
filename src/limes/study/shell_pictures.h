#pragma once

#include "limes/report/pictures.h"
#include "limes/report/view3d.h"
#include "limes/study/shell_pieces.h"
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
  explicit ShellPictures(ShellResult&&) = delete;

  /// Length of the displacement, on the deformed shape, before the borders of the undeformed one.
  [[nodiscard]] Figure displacement() const;
  /// One value per element, at its centre: nothing is averaged. Both sides have the same scale, from 0.
  [[nodiscard]] Figure von_mises(ShellSide side) const;
  /// Of both sides.
  [[nodiscard]] const ColourScale& stress_scale() const { return stress_scale_; }

  static constexpr int most_faces_to_turn = 5'000;  ///< some 200 bytes of the report each
  /// The stress at the top as a model to turn; none with more faces than that.
  [[nodiscard]] std::optional<View3d> view() const;

 private:
  /// Sides of elements and, darker, borders of smooth pieces.
  void add_lines(const std::vector<Vec3>& points, FieldPicture& field) const;
  [[nodiscard]] std::string largest_text(const std::vector<double>& stress) const;
  [[nodiscard]] FieldPicture stress_field(const std::vector<double>& values) const;

  const ShellResult& result_;
  PieceEdges edges_;
  std::vector<double> top_, bottom_;  ///< von Mises stress per face
  ColourScale stress_scale_;
  std::string sides_;  ///< which of them these pictures show
};

}  // namespace limes
