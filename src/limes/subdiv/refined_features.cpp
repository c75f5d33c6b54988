#include "limes/subdiv/refined_features.h"

#include <algorithm>
#include <vector>

#include "limes/core/error.h"
#include "limes/subdiv/crease.h"

namespace limes {
namespace {

/// The child halfedges along a halfedge of a mesh of quads or triangles, see split.h: the child at its
/// start has it as its first side, the child at its end as its last.
void add_halves(std::int64_t h, Split split, std::vector<std::int64_t>& out) {
  const int size = split == Split::quads ? 4 : 3;
  const std::int64_t first = h - h % size;
  const std::int64_t next = first + (h + 1) % size;
  const auto child = [&](std::int64_t corner) {
    return split == Split::quads ? 4 * corner : 4 * first + 3 * (corner - first);
  };
  out.push_back(child(h));
  out.push_back(child(next) + size - 1);
}

/// The halfedges along a control halfedge after some steps, from its start to its end.
std::vector<std::int64_t> refined_halfedge(HalfedgeId h, Split split, int depth) {
  std::vector<std::int64_t> parts{h.value};
  for (int step = 0; step < depth; ++step) {
    std::vector<std::int64_t> halves;
    for (const std::int64_t p : parts)
      add_halves(p, split, halves);
    parts = std::move(halves);
  }
  return parts;
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
  for (const SharpEdge& e : features.edges) {
    const float s = decayed_by(depth, e.sharpness);
    const HalfedgeId twin = control.twin(e.halfedge);
    if (!is_sharp(s) || !twin.valid()) continue;
    const auto parts = refined_halfedge(e.halfedge, split, depth);
    const auto others = refined_halfedge(twin, split, depth);
    for (std::size_t i = 0; i < parts.size(); ++i)
      fine.edges.push_back({HalfedgeId(std::min(parts[i], others[parts.size() - 1 - i])), s});
  }
  std::sort(fine.edges.begin(), fine.edges.end(),
            [](const SharpEdge& a, const SharpEdge& b) { return a.halfedge < b.halfedge; });
  return fine;
}

}  // namespace limes
