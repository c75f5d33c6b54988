#include "limes/subdiv/forest_seams.h"

#include <utility>

#include "limes/core/error.h"

namespace limes {
namespace {

/// A side of a face, run along from its corner `side` or the other way.
struct Side {
  FaceId face;
  int side;
  bool forward;

  /// The first or second half; child i begins at corner i, so that its first side is the first half of
  /// side i, and its last side the second half of side i - 1.
  [[nodiscard]] Side half(const Forest& forest, int i) const {
    const int n = forest.face_size();
    return (i == 0) == forward ? Side{forest.child(face, side), 0, forward}
                               : Side{forest.child(face, (side + 1) % n), n - 1, forward};
  }
  [[nodiscard]] std::array<VertexId, 2> ends(const Forest& forest) const {
    const auto v = forest.corners(face);
    const VertexId a = v[static_cast<std::size_t>(side)];
    const VertexId b = v[static_cast<std::size_t>(side + 1) % v.size()];
    return forward ? std::array{a, b} : std::array{b, a};
  }
};

Side side_of_control(const Forest& forest, const std::array<VertexId, 2>& ends) {
  const Adjacency& adjacency = forest.control_adjacency();
  const HalfedgeId h = find_edge(adjacency, ends[0], ends[1]);
  LIMES_ASSERT(h.valid());
  return {adjacency.face(h), adjacency.corner_index(h), adjacency.from(h) == ends[0]};
}

/// Calls visit(side, side) for each pair of tied sides of which one is a leaf's at least.
template <class Visit>
void for_each_pair(const Forest& forest, std::span<const TiedEdge> seams, const Visit& visit) {
  std::vector<std::pair<Side, Side>> open;
  for (const TiedEdge& e : seams) {
    open.emplace_back(side_of_control(forest, e.ends), side_of_control(forest, e.tied));
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (!forest.is_split(a.face) || !forest.is_split(b.face)) {
        visit(a, b);
        continue;
      }
      for (const int i : {1, 0})
        open.emplace_back(a.half(forest, i), b.half(forest, i));
    }
  }
}

}  // namespace

void match_seams(Forest& forest, std::span<const TiedEdge> seams) {
  for (std::vector<FaceId> lagging;; lagging.clear()) {
    for_each_pair(forest, seams, [&](const Side& a, const Side& b) {
      if (forest.is_split(a.face) == forest.is_split(b.face)) return;
      lagging.push_back(forest.is_split(a.face) ? b.face : a.face);
    });
    if (lagging.empty()) return;
    forest.refine(lagging);
  }
}

std::vector<TiedEdge> tied_edges(const Forest& forest, const ForestMesh& mesh,
                                 std::span<const TiedEdge> seams) {
  IdArray<VertexId, VertexId> vertex(static_cast<std::size_t>(forest.nodes().size()));
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v)
    vertex[mesh.nodes[v]] = VertexId(v);
  const auto ends = [&](const Side& s) {
    const auto [a, b] = s.ends(forest);
    return std::array{vertex[a], vertex[b]};
  };
  std::vector<TiedEdge> out;
  for_each_pair(forest, seams, [&](const Side& a, const Side& b) {
    LIMES_ASSERT(!forest.is_split(a.face) && !forest.is_split(b.face));
    out.push_back({ends(a), ends(b)});
  });
  return out;
}

}  // namespace limes
