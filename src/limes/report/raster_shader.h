#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "limes/report/raster.h"

namespace limes::raster {

/// Light on a surface seen in the camera's frame: a key light from the upper left, weaker ones
/// from the right and the eye, the rest from everywhere, a faint highlight. It scales squared colours (nearly linear
/// light), so shadows stay soft.
inline Colour lit(const Colour& colour, const Eigen::Vector3f& normal) {
  constexpr float key[3] = {-0.466F, 0.577F, 0.671F};  // unit vectors
  constexpr float fill[3] = {0.883F, 0.052F, 0.467F};
  constexpr float half[3] = {-0.255F, 0.316F, 0.914F};  // between the key light and the eye
  const auto dot = [&](const float(&d)[3]) {
    return d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2];
  };
  const float wrapped = std::max(0.0F, 0.25F + 0.75F * dot(key));
  const float light = 0.22F + 0.62F * wrapped * wrapped + 0.18F * std::max(0.0F, dot(fill)) +
                      0.18F * std::max(0.0F, normal[2]);
  float shine = std::max(0.0F, dot(half));
  for (int i = 0; i < 5; ++i)
    shine *= shine;  // the 32nd power
  const auto apply = [&](float c) {
    return std::min(1.0F, std::sqrt(c * c * light + 0.08F * shine));
  };
  return {apply(colour.r), apply(colour.g), apply(colour.b)};
}

/// A colour that stands for a value: all components scaled alike, so that the hue stays and the value can be
/// read off the bar, by 0.94 where the surface is seen edge-on.
inline Colour faintly_shaded(const Colour& colour, const Eigen::Vector3f& normal) {
  const float part = 0.94F + 0.06F * std::clamp(normal[2], 0.0F, 1.0F);
  return {part * colour.r, part * colour.g, part * colour.b};
}

/// Colours the samples of one triangle from its corners' attributes.
class Shader {
 public:
  using Weights = std::array<float, 3>;

  /// @param iso_half_width  in samples
  Shader(const PreparedSurface& prepared, const Triangle& triangle, bool perspective,
         double iso_half_width)
      : surface_(*prepared.surface),
        iso_lines_(prepared.iso_lines),
        v_{&prepared.vertices[static_cast<std::size_t>(triangle.a)],
           &prepared.vertices[static_cast<std::size_t>(triangle.b)],
           &prepared.vertices[static_cast<std::size_t>(triangle.c)]},
        perspective_(perspective),
        colour_(prepared.surface->colour) {
    const double cross = cross_product();
    facing_ = cross < 0 ? 1.0F : -1.0F;  // y points down: counter-clockwise is negative
    const auto source = static_cast<std::size_t>(triangle.source);
    if (!surface_.triangle_colours.empty()) colour_ = surface_.triangle_colours[source];
    if (!prepared.facets.empty()) facet_ = facing_ * prepared.facets[source];
    if (!iso_lines_.empty()) iso_reach_ = static_cast<float>(iso_half_width * gradient(cross));
  }

  /// @param l  weights of the corners a, b, c on the screen, sum 1
  [[nodiscard]] Colour operator()(Weights l) const {
    if (perspective_) {
      for (std::size_t i = 0; i < 3; ++i)
        l[i] *= v_[i]->inverse_w;
      const float sum = l[0] + l[1] + l[2];
      for (float& x : l)
        x /= sum;
    }
    const Colour base = base_colour(l);
    switch (surface_.shading) {
      case Shading::lit:
        return lit(base, normal(l));
      case Shading::faint:
        return faintly_shaded(base, normal(l));
      case Shading::flat:
        break;
    }
    return base;
  }

 private:
  /// Twice the area in units of the grid, negative if counter-clockwise as seen.
  [[nodiscard]] double cross_product() const {
    const double x1 = v_[1]->x - v_[0]->x, y1 = v_[1]->y - v_[0]->y;
    const double x2 = v_[2]->x - v_[0]->x, y2 = v_[2]->y - v_[0]->y;
    return x1 * y2 - x2 * y1;
  }

  /// Change of the value per sample.
  [[nodiscard]] double gradient(double cross) const {
    const double d1 = v_[1]->value - v_[0]->value;
    const double d2 = v_[2]->value - v_[0]->value;
    const double gx = d1 * (v_[2]->y - v_[0]->y) - d2 * (v_[1]->y - v_[0]->y);
    const double gy = d2 * (v_[1]->x - v_[0]->x) - d1 * (v_[2]->x - v_[0]->x);
    return std::hypot(gx, gy) / std::abs(cross) * subpixels;
  }

  [[nodiscard]] Colour base_colour(const Weights& l) const {
    if (!surface_.values.empty())
      return value_colour(l[0] * v_[0]->value + l[1] * v_[1]->value + l[2] * v_[2]->value);
    if (surface_.point_colours.empty()) return colour_;
    const auto sum = [&](float Colour::*c) {
      return l[0] * (v_[0]->colour.*c) + l[1] * (v_[1]->colour.*c) + l[2] * (v_[2]->colour.*c);
    };
    return {sum(&Colour::r), sum(&Colour::g), sum(&Colour::b)};
  }

  [[nodiscard]] Colour value_colour(float t) const {
    const Colour colour = surface_.scale.at_normalised(t);
    for (const float iso : iso_lines_) {
      if (std::abs(t - iso) <= iso_reach_) return mix(colour, palette::ink, 0.7F);
    }
    return colour;
  }

  [[nodiscard]] Eigen::Vector3f normal(const Weights& l) const {
    if (surface_.normals.empty()) return facet_;
    Eigen::Vector3f n = Eigen::Vector3f::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      n += l[i] * Eigen::Map<const Eigen::Vector3f>(v_[i]->normal);
    const float length = n.norm();
    return length > 0 ? Eigen::Vector3f(n * (facing_ / length)) : facet_;
  }

  const Surface& surface_;
  const std::vector<float>& iso_lines_;
  std::array<const Vertex*, 3> v_;
  bool perspective_;
  float facing_ = 1;
  float iso_reach_ = 0;
  Colour colour_;
  Eigen::Vector3f facet_ = Eigen::Vector3f(0, 0, 1);
};

}  // namespace limes::raster
