#include "limes/subdiv/forest_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include "limes/core/error.h"
#include "limes/subdiv/split_sides.h"

namespace limes {
namespace {

/// A leaf's corners and the middles of its split sides, from corner number `first` on.
struct Turned {
  std::array<VertexId, 4> v, e;
};

Turned turned(std::span<const VertexId> corners, const std::array<VertexId, 4>& middles,
              int first) {
  Turned t;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    t.v[i] = corners[(i + static_cast<std::size_t>(first)) % corners.size()];
    t.e[i] = middles[(i + static_cast<std::size_t>(first)) % corners.size()];
  }
  return t;
}

/// The pattern of split sides turned so that it is the smallest number, and by how many corners.
std::pair<SideMask, int> turned_pattern(SideMask mask, unsigned size) {
  const SideMask all = (1U << size) - 1;
  std::pair<SideMask, int> best{mask, 0};
  for (unsigned k = 1; k < size; ++k)
    best = std::min(best, {((mask >> k) | (mask << (size - k))) & all, static_cast<int>(k)});
  return best;
}

/// @param centre  of the leaf; only for two adjacent and for four split sides
void cut_into_quads(FaceId leaf, const QuadCorners& corners, const ChildNodes& nodes, SideMask mask,
                    LeafPieces& out) {
  const auto [pattern, first] = turned_pattern(mask, 4);
  const auto [v, e] = turned(corners, nodes.sides, first);
  const VertexId c = nodes.centre;
  switch (pattern) {
    case 0b0000:
      return out.add(leaf, {v[0], v[1], v[2], v[3]});
    case 0b0101:
      out.add(leaf, {v[0], e[0], e[2], v[3]});
      return out.add(leaf, {e[0], v[1], v[2], e[2]});
    case 0b0011:  // a Y at corner 1
      out.add(leaf, {v[1], e[1], c, e[0]});
      out.add(leaf, {e[1], v[2], v[3], c});
      return out.add(leaf, {c, v[3], v[0], e[0]});
    case 0b1111:
      for (std::size_t i = 0; i < 4; ++i)
        out.add(leaf, {v[i], e[i], c, e[(i + 3) % 4]});
      return;
    default:
      LIMES_ASSERT(false);
  }
}

void cut_with_triangles(FaceId leaf, const QuadCorners& corners,
                        const std::array<VertexId, 4>& middles, SideMask mask, LeafPieces& out) {
  const auto [pattern, first] = turned_pattern(mask, 4);
  const auto [v, e] = turned(corners, middles, first);
  switch (pattern) {
    case 0b0000:
      return out.add(leaf, {v[0], v[1], v[2], v[3]});
    case 0b0001:
      out.add(leaf, {v[0], e[0], v[3]});
      out.add(leaf, {e[0], v[1], v[2]});
      return out.add(leaf, {e[0], v[2], v[3]});
    case 0b0101:
      out.add(leaf, {v[0], e[0], e[2], v[3]});
      return out.add(leaf, {e[0], v[1], v[2], e[2]});
    case 0b0011:
      out.add(leaf, {e[0], v[1], e[1]});
      out.add(leaf, {v[0], e[0], v[3]});
      out.add(leaf, {e[0], e[1], v[3]});
      return out.add(leaf, {e[1], v[2], v[3]});
    case 0b0111:
      out.add(leaf, {e[0], v[1], e[1]});
      out.add(leaf, {e[1], v[2], e[2]});
      out.add(leaf, {e[0], e[1], e[2]});
      return out.add(leaf, {v[0], e[0], e[2], v[3]});
    case 0b1111:
      for (std::size_t i = 0; i < 4; ++i)
        out.add(leaf, {v[i], e[i], e[(i + 3) % 4]});
      return out.add(leaf, {e[0], e[1], e[2], e[3]});
    default:
      LIMES_ASSERT(false);
  }
}

/// Red-green refinement [bank_sherman_weiser_1983]: green triangles, which may be thin, are not split
/// again, since they are no leaves.
void cut_into_triangles(const ForestNodes& nodes, FaceId leaf, std::span<const VertexId> corners,
                        const std::array<VertexId, 4>& middles, SideMask mask, LeafPieces& out) {
  const auto [pattern, first] = turned_pattern(mask, 3);
  const auto [v, e] = turned(corners, middles, first);
  const auto length = [&](VertexId a, VertexId b) {
    return (nodes.position(a) - nodes.position(b)).norm();
  };
  switch (pattern) {
    case 0b000:
      return out.add(leaf, {v[0], v[1], v[2]});
    case 0b001:
      out.add(leaf, {v[0], e[0], v[2]});
      return out.add(leaf, {e[0], v[1], v[2]});
    case 0b011: {
      out.add(leaf, {e[0], v[1], e[1]});
      // What rounding makes of equal lengths does not matter.
      const bool from_middle = length(e[0], v[2]) <= (1 + 1e-9) * length(v[0], e[1]);
      out.add(leaf, {v[0], e[0], from_middle ? v[2] : e[1]});
      return out.add(leaf, {from_middle ? e[0] : v[0], e[1], v[2]});
    }
    case 0b111:
      for (std::size_t i = 0; i < 3; ++i)
        out.add(leaf, {v[i], e[i], e[(i + 2) % 3]});
      return out.add(leaf, {e[0], e[1], e[2]});
    default:
      LIMES_ASSERT(false);
  }
}

void close_with_quads(Forest& forest, const std::vector<FaceId>& leaves,
                      std::vector<SideMask>& masks, LeafPieces& out) {
  add_sides_for_quads(forest, leaves, masks);
  std::vector<FaceId> cut;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    if (masks[i] != 0) cut.push_back(leaves[i]);
  const std::vector<ChildNodes> nodes = forest.child_nodes(cut);
  std::size_t k = 0;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    cut_into_quads(leaves[i], forest.quad(leaves[i]), masks[i] != 0 ? nodes[k++] : ChildNodes(),
                   masks[i], out);
}

std::array<VertexId, 4> middles_of(const Forest& forest, FaceId leaf, SideMask mask) {
  const auto v = forest.corners(leaf);
  std::array<VertexId, 4> middles;
  for (unsigned i = 0; i < v.size(); ++i)
    if ((mask & (1U << i)) != 0) middles[i] = forest.nodes().middle(v[i], v[(i + 1) % v.size()]);
  return middles;
}

/// Cuts every leaf where its neighbours are split, or for vertices that hang leaves it as it is.
void cut_each(const Forest& forest, const std::vector<FaceId>& leaves,
              const std::vector<SideMask>& masks, Closure closure, LeafPieces& out) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const SideMask mask = closure == Closure::hanging ? 0U : masks[i];
    const std::array<VertexId, 4> middles = middles_of(forest, leaves[i], mask);
    if (forest.face_size() == 3)
      cut_into_triangles(forest.nodes(), leaves[i], forest.corners(leaves[i]), middles, mask, out);
    else
      cut_with_triangles(leaves[i], forest.quad(leaves[i]), middles, mask, out);
  }
}

std::vector<HangingVertex> hanging_vertices(const Forest& forest, const std::vector<FaceId>& leaves,
                                            const std::vector<SideMask>& masks,
                                            const std::vector<VertexId>& nodes) {
  IdArray<VertexId, VertexId> number(static_cast<std::size_t>(forest.num_vertices()));
  for (std::size_t v = 0; v < nodes.size(); ++v)
    number[nodes[v]] = VertexId(v);
  std::vector<HangingVertex> hanging;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const auto v = forest.corners(leaves[i]);
    const std::array<VertexId, 4> middles = middles_of(forest, leaves[i], masks[i]);
    for (std::size_t k = 0; k < v.size(); ++k)
      if (middles[k].valid())
        hanging.push_back({number[middles[k]], {number[v[k]], number[v[(k + 1) % v.size()]]}});
  }
  std::sort(hanging.begin(), hanging.end(),
            [](const HangingVertex& a, const HangingVertex& b) { return a.vertex < b.vertex; });
  return hanging;
}

}  // namespace

ForestMesh forest_mesh(Forest& forest, Closure closure) {
  const std::vector<FaceId> leaves = forest.leaves();
  std::vector<SideMask> masks = sides_of_split_neighbours(forest, leaves);
  LeafPieces pieces;
  const bool by_quads = closure == Closure::conforming && forest.face_size() == 4;
  if (by_quads)
    close_with_quads(forest, leaves, masks, pieces);
  else
    cut_each(forest, leaves, masks, closure, pieces);
  ForestMesh made = leaf_mesh(forest, pieces);
  if (closure == Closure::hanging)
    made.hanging = hanging_vertices(forest, leaves, masks, made.nodes);
  return made;
}

}  // namespace limes
