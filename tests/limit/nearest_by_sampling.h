#pragma once

#include <vector>

#include "limes/limit/limit_surface.h"

namespace limes::test {

/// The distance to a limit surface the slow way: a grid of samples on every face, and from the best
/// of them a search that compares values along u and v with ever smaller steps. It knows no
/// derivatives, patches or bounds, so what it finds may be too far away, but never too close.
class NearestBySampling {
 public:
  explicit NearestBySampling(const LimitSurface& surface, int samples_per_side = 9);
  [[nodiscard]] double distance(const Vec3& q) const;

 private:
  struct Sample {
    FaceId face;
    int corner;
    Vec2 uv;
    Vec3 x;
  };
  [[nodiscard]] double descend(const Sample& start, const Vec3& q) const;

  const LimitSurface& surface_;
  double step_;
  std::vector<Sample> samples_;
};

}  // namespace limes::test
