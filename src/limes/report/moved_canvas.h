#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "limes/report/canvas.h"

namespace limes {

/// Draws on another canvas, everything moved.
class MovedCanvas final : public Canvas {
 public:
  MovedCanvas(Canvas& target, Vec2 by) : target_(target), by_(std::move(by)) {}
  void polyline(std::span<const Vec2> points, const Stroke& stroke) override {
    target_.polyline(moved(points), stroke);
  }
  void polygon(std::span<const Vec2> points, const Paint& paint) override {
    target_.polygon(moved(points), paint);
  }
  void circle(const Vec2& centre, double radius, const Paint& paint) override {
    target_.circle(centre + by_, radius, paint);
  }
  void text(const Vec2& at, std::string_view label, const TextStyle& style) override {
    target_.text(at + by_, label, style);
  }
  void image(const Vec2& corner, const Vec2& size, const Image& image) override {
    target_.image(corner + by_, size, image);
  }

 private:
  [[nodiscard]] std::vector<Vec2> moved(std::span<const Vec2> points) const {
    std::vector<Vec2> result(points.begin(), points.end());
    for (Vec2& p : result)
      p += by_;
    return result;
  }

  Canvas& target_;
  Vec2 by_;
};

}  // namespace limes
