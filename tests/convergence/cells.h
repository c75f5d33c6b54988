#pragma once

#include "convergence/plane_meshes.h"

namespace limes::testing {

/// The unit cell [-1/2, 1/2]^2 in polar blocks around the circle r = 1/4: n vertices around (a
/// multiple of 8), `layers` of faces from the circle to the square. Rings next to the circle are
/// concentric and equally spaced, their control radii make them cubic B-splines that interpolate
/// circles, so the limit of the first ring is the circle whether or not there are faces inside.
/// Inside either nothing, or a disc in the group "disc": rings and a square core with four vertices of
/// valence 3.
class CircleCell {
 public:
  CircleCell(int n, int layers, bool disc) : n_(n), layers_(layers) {
    for (int k = 0; k <= layers; ++k)
      add_ring(double(k) / layers);
    for (int k = 0; k < layers; ++k)
      add_faces(ring(k), ring(k + 1));
    if (disc) add_disc();
  }

  [[nodiscard]] Mesh mesh() const {
    Mesh mesh = make_mesh(points_, quads_);
    for (int i = n_ / 8; i < n_; i += n_ / 4)
      mesh.tags.corners.push_back({VertexId(ring(layers_)[i]), infinite_sharpness});
    if (!disc_.empty()) mesh.groups.push_back({"disc", disc_});
    return mesh;
  }

 private:
  static constexpr double radius = 0.25, step_out = 0.2, step_in = 0.1, core = 0.1;
  using Ring = std::vector<int>;

  [[nodiscard]] Vec3 direction(int i) const {
    const double a = 2 * std::numbers::pi * i / n_;
    return {std::cos(a), std::sin(a), 0};
  }
  /// Control radius over radius of a B-spline circle.
  [[nodiscard]] double stretch() const { return 3 / (2 + std::cos(2 * std::numbers::pi / n_)); }
  [[nodiscard]] Ring ring(int k) const {
    Ring out;
    for (int i = 0; i < n_; ++i)
      out.push_back(k * n_ + i);
    return out;
  }
  /// Ring at t in [0, 1] between circle and square.
  void add_ring(double t) {
    const double control = t < 1 ? 1 + (stretch() - 1) * (1 - t) : 1;
    for (int i = 0; i < n_; ++i) {
      const Vec3 d = direction(i);
      const double to_square = .5 / d.cwiseAbs().maxCoeff() - radius;
      const double r = radius + step_out * t + (to_square - step_out) * t * t * t * t;
      points_.push_back(control * r * d);
    }
  }
  void add_faces(const Ring& inner, const Ring& outer) {
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const std::size_t j = (i + 1) % inner.size();
      quads_.insert(quads_.end(), {inner[i], outer[i], outer[j], inner[j]});
    }
  }
  void add_disc() {
    const int first_face = int(quads_.size()) / 4;
    const int inward = layers_ / 2;
    Ring previous = ring(0);
    for (int k = 1; k <= inward; ++k) {
      const double t = double(k) / inward;
      Ring now;
      for (int i = 0; i < n_; ++i) {
        now.push_back(int(points_.size()));
        const Vec3 d = stretch() * direction(i);
        points_.push_back((radius - step_in * t) * d +
                          t * t * t * t * (core_point(i) - (radius - step_in) * d));
      }
      add_faces(now, previous);
      previous = now;
    }
    add_core(previous);
    for (int f = first_face; f < int(quads_.size()) / 4; ++f)
      disc_.emplace_back(f);
  }
  /// Vertex i of the core's border, counted like the rings.
  [[nodiscard]] Vec3 core_point(int i) const {
    const int q = n_ / 4;
    const double t = core * (2.0 * ((i + q / 2) % q) / q - 1.0);
    switch (((i + q / 2) / q) % 4) {
      case 0:
        return {core, t, 0};
      case 1:
        return {-t, core, 0};
      case 2:
        return {-core, -t, 0};
      default:
        return {t, -core, 0};
    }
  }
  /// A square of (n/4)^2 faces whose border is a ring.
  void add_core(const Ring& border) {
    const int q = n_ / 4;
    const auto on_border = [&](int a, int b) {
      const int h = q / 2;
      if (a == q) return (b - h + n_) % n_;
      if (b == q) return h + (q - a);
      if (a == 0) return h + q + (q - b);
      return b == 0 ? (h + 2 * q + a) % n_ : -1;
    };
    std::vector<int> id;
    for (int b = 0; b <= q; ++b)
      for (int a = 0; a <= q; ++a) {
        const int i = on_border(a, b);
        id.push_back(i >= 0 ? border[i] : int(points_.size()));
        if (i < 0) points_.emplace_back(core * (2.0 * a / q - 1), core * (2.0 * b / q - 1), 0);
      }
    for (int b = 0; b < q; ++b)
      for (int a = 0; a < q; ++a) {
        const int v = b * (q + 1) + a;
        quads_.insert(quads_.end(), {id[v], id[v + 1], id[v + q + 2], id[v + q + 1]});
      }
  }

  int n_, layers_;
  std::vector<Vec3> points_;
  std::vector<int> quads_;
  std::vector<FaceId> disc_;
};

}  // namespace limes::testing
