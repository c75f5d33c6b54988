#include "limes/subdiv/quad_runs.h"

#include "limes/subdiv/quad_grid.h"

namespace limes {

QuadRuns::QuadRuns(const QuadNumbering& numbering, OwnedSides owned) {
  const auto append = [&](QuadNumbering::Node n) {
    offsets_.push_back(static_cast<std::uint16_t>(4 * QuadGrid::place(n.i, n.j)));
  };
  for (int birth = 1; birth <= numbering.depth(); ++birth) {
    Step step;
    std::vector<std::int32_t> ranks;  // by edge
    for (const QuadNumbering::EdgeNode& e : numbering.edges(birth)) {
      const bool is_owned = e.side < 0 || ((owned >> e.side) & 1U) != 0;
      ranks.push_back(is_owned ? step.num_edges++ : 0);
      if (is_owned) append(e.node);
      if (e.side < 0) continue;
      const auto side = static_cast<std::size_t>(e.side);
      // It is the first side of the child at its start, and the last of the child at its end.
      const int end = e.corner - e.corner % 4 + (e.corner + 1) % 4;
      step.side_vertices[side][e.step] = {static_cast<std::uint16_t>(4 * e.corner + 1),
                                          static_cast<std::uint16_t>(4 * end + 3)};
      step.side_ranks[side][e.step] = static_cast<std::uint16_t>(ranks.back());
    }
    for (const std::uint16_t e : numbering.edge_at_corner(birth))
      step.edge_ranks.push_back(ranks[e]);
    for (const QuadNumbering::Node n : numbering.faces(birth))
      append(n);
    steps_.push_back(std::move(step));
  }
}

}  // namespace limes
