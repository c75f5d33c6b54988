#include "limes/study/shell_directors.h"

#include <algorithm>
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

}  // namespace

Directors mean_directors(const Adjacency& adjacency, const IdArray<HalfedgeId, Vec3>& corner_normal,
                         double kink_angle) {
  const Topology& t = adjacency.topology();
  const double cosine = std::cos(kink_angle * std::numbers::pi / 180);
  Directors out{IdArray<HalfedgeId, Vec3>(static_cast<std::size_t>(t.num_corners())),
                IdArray<VertexId, char>(static_cast<std::size_t>(t.num_vertices()), 1)};
  for (int v = 0; v < t.num_vertices(); ++v) {
    const std::vector<HalfedgeId> corners = ring(adjacency, VertexId(v));
    const std::size_t n = corners.size();
    const bool closed = !adjacency.is_boundary(VertexId(v));
    // kink[i]: between corner i and the next; the last is an edge only where the ring closes
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < n; ++i)
      if ((i + 1 < n || closed) &&
          corner_normal[corners[i]].dot(corner_normal[corners[(i + 1) % n]]) < cosine)
        starts.push_back((i + 1) % n);
    const std::size_t groups = closed ? starts.size() : starts.size() + 1;
    out.smooth[VertexId(v)] = groups <= 1;
    const std::size_t first = closed && !starts.empty() ? starts.front() : 0;
    std::vector<HalfedgeId> group;
    const auto finish = [&] {
      Vec3 sum = Vec3::Zero();
      for (const HalfedgeId h : group)
        sum += corner_normal[h];
      for (const HalfedgeId h : group)
        out.at_corner[h] = sum.normalized();
      group.clear();
    };
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (first + k) % n;
      const bool begins = std::find(starts.begin(), starts.end(), i) != starts.end();
      if (k > 0 && begins && groups > 1) finish();
      group.push_back(corners[i]);
    }
    if (!group.empty()) finish();
  }
  return out;
}

}  // namespace limes
