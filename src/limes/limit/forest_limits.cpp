#include "limes/limit/forest_limits.h"

#include "limes/core/error.h"
#include "limes/limit/limit_surface.h"

namespace limes {

LimitsOf forest_limits(const Scheme& scheme) {
  LIMES_ASSERT(has_exact_limit(scheme));
  return
      [&scheme](const Topology& topology, const Features& features, std::span<const Vec3> points) {
        const LimitBasis basis(topology, features, scheme);
        return limit_positions(LimitSurface(basis, points), points);
      };
}

}  // namespace limes
