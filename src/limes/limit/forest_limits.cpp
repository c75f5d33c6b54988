#include "limes/limit/forest_limits.h"

#include <utility>

#include "limes/core/error.h"
#include "limes/limit/limit_surface.h"
#include "limes/mesh/pieces.h"

namespace limes {
namespace {

bool has_bow_ties(const Topology& topology) {
  const Adjacency adjacency(topology, Adjacency::Check::edges);
  int in_rings = 0;
  for (int v = 0; v < topology.num_vertices(); ++v)
    in_rings += adjacency.num_ring_faces(VertexId(v));
  return in_rings < topology.num_corners();
}

/// The same faces where every fan at a vertex has a vertex of its own; new ones come last. The rim of a
/// patch may touch itself, which no surface does.
Topology with_fans_apart(const Topology& topology, std::vector<Vec3>& points) {
  const IdArray<HalfedgeId, HalfedgeId> fans = corner_fans(topology, group_by_edge(topology));
  std::vector<VertexId> corners(topology.corners().begin(), topology.corners().end());
  std::vector<bool> taken(points.size(), false);  // by the vertex's first fan
  IdArray<HalfedgeId, VertexId> vertex(static_cast<std::size_t>(topology.num_corners()));  // by fan
  for (int i = 0; i < topology.num_corners(); ++i) {
    VertexId& v = vertex[fans[HalfedgeId(i)]];
    VertexId& corner = corners[static_cast<std::size_t>(i)];
    const auto old = static_cast<std::size_t>(corner.value);
    if (!v.valid() && taken[old]) {
      v = VertexId(points.size());
      points.push_back(points[old]);
    } else if (!v.valid()) {
      v = corner;
      taken[old] = true;
    }
    corner = v;
  }
  return {static_cast<int>(points.size()), topology.uniform_face_size(), std::move(corners)};
}

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
        if (!has_bow_ties(topology)) return limits_of(scheme, topology, features, points);
        std::vector<Vec3> more(points.begin(), points.end());
        const Topology apart = with_fans_apart(topology, more);
        return limits_of(scheme, apart, features, more);
      };
}

}  // namespace limes
