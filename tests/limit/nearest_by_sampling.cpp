#include "limit/nearest_by_sampling.h"

#include <algorithm>

namespace limes::test {

NearestBySampling::NearestBySampling(const LimitSurface& surface, int samples_per_side)
    : surface_(surface), step_(1.0 / (samples_per_side - 1)) {
  const LimitBasis& basis = surface.basis();
  for (int f = 0; f < basis.topology().num_faces(); ++f)
    for (int corner = 0; corner < basis.num_quadrants(FaceId(f)); ++corner)
      for (int i = 0; i < samples_per_side; ++i)
        for (int j = 0; j < samples_per_side; ++j) {
          const Vec2 uv(i * step_, j * step_);
          samples_.push_back({FaceId(f), corner, uv, surface.position(FaceId(f), corner, uv)});
        }
}

double NearestBySampling::distance(const Vec3& q) const {
  constexpr std::size_t starts = 6;
  std::vector<Sample> best = samples_;
  const std::size_t count = std::min(starts, best.size());
  std::partial_sort(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(count), best.end(),
                    [&](const Sample& a, const Sample& b) {
                      return (a.x - q).squaredNorm() < (b.x - q).squaredNorm();
                    });
  double smallest = (best[0].x - q).stableNorm();
  for (std::size_t k = 0; k < count; ++k)
    smallest = std::min(smallest, descend(best[k], q));
  return smallest;
}

double NearestBySampling::descend(const Sample& start, const Vec3& q) const {
  Vec2 at = start.uv;
  double smallest = (start.x - q).stableNorm();
  for (double step = step_; step > 1e-7; step *= 0.5) {
    for (bool moved = true; moved;) {
      moved = false;
      for (const Vec2& d :
           {Vec2(step, 0), Vec2(-step, 0), Vec2(0, step), Vec2(0, -step), Vec2(step, step),
            Vec2(-step, -step), Vec2(step, -step), Vec2(-step, step)}) {
        const Vec2 next = (at + d).cwiseMax(Vec2::Zero()).cwiseMin(Vec2::Ones());
        const double distance =
            (surface_.position(start.face, start.corner, next) - q).stableNorm();
        if (!(distance < smallest)) continue;
        smallest = distance;
        at = next;
        moved = true;
      }
    }
  }
  return smallest;
}

}  // namespace limes::test
