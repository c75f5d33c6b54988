#pragma once

#include <cmath>
#include <numbers>

#include "convergence/plane_meshes.h"

namespace limes::testing {

/// An annulus between radius 1 and 2 whose circles are cubic B-splines.
inline Mesh annulus(int n, int layers) {
  std::vector<Vec3> x;
  std::vector<int> quads;
  const double stretch = 3 / (2 + std::cos(2 * std::numbers::pi / n));
  for (int k = 0; k <= layers; ++k)
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      const double r = stretch * (1 + double(k) / layers);
      x.emplace_back(r * std::cos(a), r * std::sin(a), 0);
    }
  for (int k = 0; k < layers; ++k)
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      quads.insert(quads.end(), {k * n + i, (k + 1) * n + i, (k + 1) * n + j, k * n + j});
    }
  return make_mesh(std::move(x), std::move(quads));
}

}  // namespace limes::testing
