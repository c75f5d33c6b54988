#include "limes/subdiv/split_sides.h"

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <unordered_set>

#include "limes/core/error.h"

namespace limes {
namespace {

bool has_side(std::span<const VertexId> corners, VertexId from, VertexId to) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] == from && corners[(i + 1) % corners.size()] == to) return true;
  return false;
}

/// Sides of control faces toggled along paths, so that each leaf among them has an even number.
class RootPairing {
 public:
  RootPairing(const Forest& forest, std::span<const FaceId> leaves, std::vector<SideMask>& masks)
      : adjacency_(&forest.control_adjacency()), forest_(&forest), masks_(&masks) {
    for (std::size_t i = 0; i < leaves.size(); ++i)
      if (!forest.parent(leaves[i]).valid()) index_[leaves[i].value] = i;
  }

  void pair_all(std::span<const FaceId> leaves) {
    for (const FaceId f : leaves)
      if (!forest_->parent(f).valid() && is_odd(f)) pair(f);
  }

 private:
  /// How a search came to a face: through `by`, a halfedge of the face before.
  struct Step {
    FaceId face;
    HalfedgeId by;
    int before;
  };

  [[nodiscard]] SideMask& mask(FaceId f) { return (*masks_)[index_.at(f.value)]; }
  [[nodiscard]] bool is_odd(FaceId f) { return std::popcount(mask(f)) % 2 == 1; }

  /// Breadth first to the nearest other odd face or the boundary. There is one: the sides of a region
  /// of quads without boundary are even in number.
  void pair(FaceId start) {
    std::vector<Step> steps{{start, HalfedgeId(), -1}};
    std::unordered_set<std::int32_t> seen{start.value};
    for (std::size_t k = 0; k < steps.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        const HalfedgeId h = adjacency_->topology().halfedge(steps[k].face, i);
        const HalfedgeId twin = adjacency_->twin(h);
        if (!twin.valid()) {
          toggle(h);
          return toggle_path(steps, static_cast<int>(k));
        }
        const FaceId next = adjacency_->face(twin);
        if (forest_->is_split(next) || !seen.insert(next.value).second) continue;
        steps.push_back({next, h, static_cast<int>(k)});
        if (is_odd(next)) return toggle_path(steps, static_cast<int>(steps.size()) - 1);
      }
    LIMES_ASSERT(false);
  }

  void toggle_path(const std::vector<Step>& steps, int last) {
    for (int k = last; k > 0; k = steps[static_cast<std::size_t>(k)].before) {
      const HalfedgeId h = steps[static_cast<std::size_t>(k)].by;
      toggle(h);
      toggle(adjacency_->twin(h));
    }
  }

  void toggle(HalfedgeId h) {
    mask(adjacency_->face(h)) ^= 1U << static_cast<unsigned>(adjacency_->corner_index(h));
  }

  const Adjacency* adjacency_;
  const Forest* forest_;
  std::vector<SideMask>* masks_;
  std::unordered_map<std::int32_t, std::size_t> index_;  // of the leaves among the control faces
};

}  // namespace

std::vector<SideMask> sides_of_split_neighbours(const Forest& forest,
                                                std::span<const FaceId> leaves) {
  std::vector<SideMask> masks;
  masks.reserve(leaves.size());
  for (const FaceId f : leaves) {
    const auto corners = forest.corners(f);
    const int level = forest.ancestry(f).level;
    SideMask mask = 0;
    for (unsigned i = 0; i < corners.size(); ++i) {
      const VertexId a = corners[i], b = corners[(i + 1) % corners.size()];
      if (!forest.nodes().middle(a, b).valid()) continue;
      for (const FaceId n : forest.faces_at(level, a))
        if (forest.is_split(n) && has_side(forest.corners(n), b, a)) mask |= 1U << i;
    }
    masks.push_back(mask);
  }
  return masks;
}

void add_sides_for_quads(const Forest& forest, std::span<const FaceId> leaves,
                         std::vector<SideMask>& masks) {
  LIMES_ASSERT(forest.unit() == SplitUnit::families);
  // Child i of a face P lies at its corner i: its side 0 is half of P's side i, its side 3 of P's
  // side i - 1, sides 1 and 2 lead to P's centre from the middles of these.
  for (std::size_t i = 0; i < leaves.size(); ++i)
    if (forest.parent(leaves[i]).valid()) {
      SideMask& mask = masks[i];
      if ((mask & 1U) != 0) mask |= 2U;
      if ((mask & 8U) != 0) mask |= 4U;
    }
  RootPairing(forest, leaves, masks).pair_all(leaves);
}

}  // namespace limes
