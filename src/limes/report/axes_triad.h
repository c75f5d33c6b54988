#pragma once

#include <array>

#include "limes/core/types.h"
#include "limes/report/canvas.h"

namespace limes {

/// Of x, y, z; in the views to turn as well.
inline constexpr std::array axis_colours{palette::series[1], palette::series[2],
                                         palette::series[0]};

/// The axes x, y, z as a camera sees them from their origin, to be drawn beside a picture.
class AxesTriad {
 public:
  /// @param axes  Camera::axes: rows are the picture's right, up, and towards the eye
  explicit AxesTriad(const Mat3& axes);

  [[nodiscard]] Vec2 size() const { return high_ - low_; }
  /// @param corner  upper left
  void draw(Canvas& canvas, const Vec2& corner) const;

  /// End of axis i relative to the origin, y downwards, as in a Canvas.
  [[nodiscard]] Vec2 end(int i) const { return ends_[static_cast<std::size_t>(i)]; }
  /// Middle of its letter. Letters do not overlap: of two axes that coincide, the farther one has its letter
  /// farther out.
  [[nodiscard]] Vec2 label(int i) const { return labels_[static_cast<std::size_t>(i)]; }

 private:
  void draw_axis(Canvas& canvas, const Vec2& origin, int i) const;

  std::array<Vec2, 3> ends_, labels_;
  std::array<double, 3> towards_eye_;
  Vec2 low_, high_;  // of all that is drawn, relative to the origin
};

}  // namespace limes
