#include "size_plan.h"

#include <fmt/format.h>

#include <limits>
#include <string>

#include "limes/core/error.h"
#include "limes/mesh/adjacency.h"
#include "memory.h"

namespace limes::app {

MeshSize size_of(const Topology& topology) {
  const auto num_edges = static_cast<std::int64_t>(group_by_edge(topology).offsets.size()) - 1;
  return {topology.num_vertices(), num_edges, topology.num_faces(), topology.num_corners()};
}

namespace {

/// Every triangle halved; other faces are cut into triangles before.
MeshSize bisected_size(const MeshSize& s) {
  const std::int64_t cuts = s.corners - 3 * s.faces;
  const std::int64_t edges = s.edges + cuts, faces = s.faces + cuts;
  const std::int64_t boundary = 2 * edges - 3 * faces;
  const std::int64_t split = (faces + boundary + 1) / 2;
  return {s.vertices + split, edges + split + faces, 2 * faces, 6 * faces};
}

}  // namespace

MeshSize refined_size(const MeshSize& s, const Scheme& scheme, int level) {
  // Exact on closed surfaces, not too small on others.
  switch (scheme.split) {
    case Split::triangles:
      return {s.vertices + s.edges, 2 * s.edges + 3 * s.faces, 4 * s.faces, 12 * s.faces};
    case Split::dual:
      return {s.corners, 2 * s.corners, s.faces + s.edges + s.vertices, 4 * s.corners};
    case Split::mid_edge:
      return {s.edges, s.corners, s.faces + s.vertices, 2 * s.corners};
    case Split::sqrt3:
      return {s.vertices + s.faces + s.edges, s.edges + 3 * s.corners, s.corners, 3 * s.corners};
    case Split::four_eight:
      if (level > 0) return bisected_size(s);
      return {s.vertices + s.faces, s.edges + s.corners, s.corners, 3 * s.corners};
    case Split::longest_edges:
      return bisected_size(s);
    case Split::quads:
      break;
  }
  return {s.vertices + s.edges + s.faces, 2 * s.edges + s.corners, s.corners, 4 * s.corners};
}

namespace {

// Bytes at the peak per corner and vertex of the finest mesh, enough for what `limes refine --json`
// reports: per face 47 for the cube with 1.6 million faces, 76 by the general rules (rook, linear,
// 0.8 million faces), 47 for loop, 238 into VTU, 302 with limit points (cube); 111 for quasi-four-eight
// and 100 for four-eight (1.5 million faces), which hold two levels and their edges.
constexpr double bytes_per_corner = 12;
constexpr double bytes_per_vertex = 40;
constexpr double vtu_bytes_per_corner = 44;
constexpr double limit_bytes_per_corner = 56;
constexpr double bisection_bytes_per_corner = 20;
constexpr double bytes_of_program = 8e6;

double bytes_needed(const MeshSize& size, const Scheme& scheme, const RefinementExtras& extras) {
  double more = extras.limit_points ? limit_bytes_per_corner
                : extras.vtu        ? vtu_bytes_per_corner
                                    : 0;
  if (scheme.split == Split::four_eight || scheme.split == Split::longest_edges)
    more += bisection_bytes_per_corner;
  return bytes_of_program + static_cast<double>(size.corners) * (bytes_per_corner + more) +
         static_cast<double>(size.vertices) * bytes_per_vertex;
}

}  // namespace

std::string obstacle(std::int64_t corners, std::int64_t vertices, double bytes,
                     std::int64_t memory_limit) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (corners > most || vertices > most)
    return fmt::format("at most {} faces can be numbered", most / 4);
  if (bytes <= static_cast<double>(memory_limit)) return {};
  return fmt::format("that takes about {} of memory, {} may be used", format_size(bytes),
                     format_size(static_cast<double>(memory_limit)));
}

void require_feasible(const Topology& topology, const Scheme& scheme, int levels,
                      const RefinementExtras& extras, std::int64_t memory_limit,
                      std::string_view file) {
  MeshSize size = size_of(topology);
  for (int level = 1; level <= levels; ++level) {
    for (int step = 0; step < extras.steps_per_level; ++step)
      size = refined_size(size, scheme, (level - 1) * extras.steps_per_level + step);
    const std::string reason =
        obstacle(size.corners, size.vertices, bytes_needed(size, scheme, extras), memory_limit);
    if (reason.empty()) continue;
    throw InputError("{}: level {} would have {} faces: {}; --levels {} is possible", file, level,
                     size.faces, reason, level - 1);
  }
}

}  // namespace limes::app
