#include "limes/study/shell_directors.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace limes {
namespace {

/// Corners around a vertex, counter-clockwise.
std::vector<HalfedgeId> ring(const Adjacency& adjacency, VertexId v) {
  std::vector<HalfedgeId> out;
  const HalfedgeId start = adjacency.ring_start(v);
  for (HalfedgeId h = start; h.valid();) {
    out.push_back(h);
    h = adjacency.ring_next(h);
    if (h == start) break;
  }
  return out;
}

/// The corners of a vertex between its kinks: two neighbours are in one group unless their normals
/// differ by more than the kink angle.
std::vector<std::vector<HalfedgeId>> smooth_groups(const std::vector<HalfedgeId>& corners,
                                                   bool closed,
                                                   const IdArray<HalfedgeId, Vec3>& corner_normal,
                                                   double cosine) {
  std::vector<std::vector<HalfedgeId>> groups;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool kink =
        i == 0 || corner_normal[corners[i - 1]].dot(corner_normal[corners[i]]) < cosine;
    if (kink) groups.emplace_back();
    groups.back().push_back(corners[i]);
  }
  // Around an inner vertex the last group goes on in the first.
  if (closed && groups.size() > 1 &&
      corner_normal[corners.back()].dot(corner_normal[corners.front()]) >= cosine) {
    groups.back().insert(groups.back().end(), groups.front().begin(), groups.front().end());
    groups.erase(groups.begin());
  }
  return groups;
}

}  // namespace

Directors mean_directors(const Adjacency& adjacency, const IdArray<HalfedgeId, Vec3>& corner_normal,
                         double kink_angle) {
  const Topology& t = adjacency.topology();
  const double cosine = std::cos(kink_angle * std::numbers::pi / 180);
  Directors out{IdArray<HalfedgeId, Vec3>(static_cast<std::size_t>(t.num_corners())),
                IdArray<VertexId, char>(static_cast<std::size_t>(t.num_vertices()), 1)};
  for (int v = 0; v < t.num_vertices(); ++v) {
    const bool closed = !adjacency.is_boundary(VertexId(v));
    const auto groups = smooth_groups(ring(adjacency, VertexId(v)), closed, corner_normal, cosine);
    out.smooth[VertexId(v)] = groups.size() <= 1;
    for (const auto& group : groups) {
      Vec3 sum = Vec3::Zero();
      for (const HalfedgeId h : group)
        sum += corner_normal[h];
      for (const HalfedgeId h : group)
        out.at_corner[h] = sum.normalized();
    }
  }
  return out;
}

}  // namespace limes
