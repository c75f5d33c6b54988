#include "limes/limit/forest_limits.h"

#include <utility>

#include "limes/core/error.h"
#include "limes/limit/limit_surface.h"
#include "limes/mesh/pieces.h"

namespace limes {
namespace {

IdArray<VertexId, Vec3> limits_of(const Scheme& scheme, const Topology& topology,
                                  const Features& features, std::span<const Vec3> points) {
  const LimitBasis basis(topology, features, scheme);
  return limit_positions(LimitSurface(basis, points), points);
}

}  // namespace

LimitsOf forest_limits(const Scheme& scheme) {
  LIMES_ASSERT(has_exact_limit(scheme));
  return
      [&scheme](const Topology& topology, const Features& features, std::span<const Vec3> points) {
        if (!has_bow_ties(Adjacency(topology, Adjacency::Check::edges)))
          return limits_of(scheme, topology, features, points);
        // The rim of a patch may touch itself, which no surface does.
        FansApart apart = fans_apart(topology);
        std::vector<Vec3> more(points.begin(), points.end());
        for (const VertexId v : apart.original)
          more.push_back(points[static_cast<std::size_t>(v.value)]);
        const Topology surface(static_cast<int>(more.size()), topology.uniform_face_size(),
                               std::move(apart.corners));
        return limits_of(scheme, surface, features, more);
      };
}

}  // namespace limes
