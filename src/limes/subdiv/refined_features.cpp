#include "limes/subdiv/refined_features.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "limes/core/error.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/crease.h"

namespace limes {
namespace {

/// The two child halfedges along a halfedge of a mesh of quads or triangles, see split.h: the child at
/// its start has it as its first side, the child at its end as its last.
std::array<std::int64_t, 2> halves(std::int64_t h, Split split) {
  const int size = split == Split::quads ? 4 : 3;
  const std::int64_t first = h - h % size;
  const std::int64_t next = first + (h + 1) % size;
  const auto child = [&](std::int64_t corner) {
    return split == Split::quads ? 4 * corner : 4 * first + 3 * (corner - first);
  };
  return {child(h), child(next) + size - 1};
}

/// The halfedges along a control halfedge after some steps, from its start to its end.
/// @param parts  one for each, 2^steps
void refine_halfedge(HalfedgeId h, Split split, std::span<std::int64_t> parts) {
  parts[0] = h.value;
  for (std::size_t count = 1; count < parts.size(); count *= 2)
    for (std::size_t i = count; i-- > 0;) {
      const auto [start, end] = halves(parts[i], split);
      parts[2 * i] = start;
      parts[2 * i + 1] = end;
    }
}

float decayed_by(int steps, float sharpness) {
  for (int i = 0; i < steps; ++i)
    sharpness = decayed(sharpness);
  return sharpness;
}

}  // namespace

Features refined_features(const Adjacency& control, const Features& features, Split split,
                          int depth) {
  LIMES_ASSERT(is_quadrisection(split));
  Features fine = features.without_tags(depth);
  for (const SharpVertex& v : features.vertices)
    if (const float s = decayed_by(depth, v.sharpness); is_sharp(s))
      fine.vertices.push_back({v.vertex, s});
  std::vector<SharpEdge> sharp;  // control edges that are still, with what is left
  for (const SharpEdge& e : features.edges)
    if (const float s = decayed_by(depth, e.sharpness);
        is_sharp(s) && control.twin(e.halfedge).valid())
      sharp.push_back({e.halfedge, s});
  const std::size_t num_parts = std::size_t{1} << depth;
  fine.edges.resize(sharp.size() * num_parts);
  for_each_block(
      static_cast<std::int64_t>(sharp.size()), 16, [&](std::int64_t begin, std::int64_t end) {
        std::vector<std::int64_t> parts(num_parts), others(num_parts);
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
          refine_halfedge(sharp[i].halfedge, split, parts);
          refine_halfedge(control.twin(sharp[i].halfedge), split, others);
          for (std::size_t k = 0; k < num_parts; ++k)
            fine.edges[i * num_parts + k] = {
                HalfedgeId(std::min(parts[k], others[num_parts - 1 - k])), sharp[i].sharpness};
        }
      });
  std::sort(fine.edges.begin(), fine.edges.end(),
            [](const SharpEdge& a, const SharpEdge& b) { return a.halfedge < b.halfedge; });
  return fine;
}

}  // namespace limes
