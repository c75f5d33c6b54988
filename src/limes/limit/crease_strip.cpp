#include "limes/limit/crease_strip.h"

#include <algorithm>
#include <array>
#include <vector>

#include "limes/subdiv/crease.h"

namespace limes {
namespace {

bool is_semi_sharp(float sharpness) {
  return is_sharp(sharpness) && !is_infinite(sharpness);
}

bool all_quads(const Topology& topology) {
  for (int f = 0; f < topology.num_faces(); ++f)
    if (topology.face_size(FaceId(f)) != 4) return false;
  return true;
}

class StripFinder {
 public:
  explicit StripFinder(const Ring& ring)
      : ring_(ring),
        adjacency_(ring.topology, Adjacency::Check::edges),
        sharpness_(adjacency_, ring.features) {}

  /// Sharpness of each side; nothing if a semi-sharp edge lies elsewhere or changes on its way.
  std::optional<std::array<float, 4>> sides() {
    std::array<float, 4> result{};
    int edges_on_sides = 0;
    for (int c = 0; c < 4; ++c) {
      const HalfedgeId side = ring_.topology.halfedge(FaceId(0), c);
      const float s = sharpness_.edge(adjacency_.edge(side));
      if (!is_semi_sharp(s)) continue;
      if (!goes_straight_on(side, s) || !goes_straight_on(adjacency_.twin(side), s)) return {};
      result[static_cast<std::size_t>(c)] = s;
      edges_on_sides += 3;
    }
    const auto& edges = ring_.features.edges;
    const auto semi_sharp = std::count_if(
        edges.begin(), edges.end(), [](const SharpEdge& e) { return is_semi_sharp(e.sharpness); });
    if (semi_sharp != edges_on_sides) return {};
    return result;
  }

 private:
  /// At the start of h: an interior vertex of valence 4 with two sharp edges, h and the opposite.
  [[nodiscard]] bool goes_straight_on(HalfedgeId h, float s) const {
    const VertexId v = adjacency_.from(h);
    if (adjacency_.is_boundary(v) || adjacency_.num_ring_faces(v) != 4) return false;
    HalfedgeId at = h;
    for (const float wanted : {s, 0.0F, s, 0.0F}) {
      if (sharpness_.edge(adjacency_.edge(at)) != wanted) return false;
      at = adjacency_.ring_next(at);
    }
    return true;
  }

  const Ring& ring_;
  Adjacency adjacency_;
  Sharpness sharpness_;
};

}  // namespace

std::optional<CreaseStrip> crease_strip(const Ring& ring, LimitPatch patch) {
  const Features& features = ring.features;
  if (patch != LimitPatch::bicubic || features.crease_method != CreaseMethod::uniform ||
      features.edges.empty() || !all_quads(ring.topology) ||
      ring.topology.face_size(FaceId(0)) != 4)
    return {};
  const auto sides = StripFinder(ring).sides();
  if (!sides) return {};
  for (int c = 0; c < 2; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const float a = (*sides)[i];
    const float b = (*sides)[i + 2];
    if ((a <= 0 && b <= 0) || (*sides)[1 - i] > 0 || (*sides)[3 - i] > 0) continue;
    Ring smooth = ring;
    std::erase_if(smooth.features.edges,
                  [](const SharpEdge& e) { return is_semi_sharp(e.sharpness); });
    auto grid = regular_patch(smooth, patch);
    if (!grid) return {};
    if (a > 0) return CreaseStrip{std::move(*grid), c, a, b};
    return CreaseStrip{std::move(*grid), c + 2, b, a};
  }
  return {};
}

}  // namespace limes
