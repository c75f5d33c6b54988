#include "limes/subdiv/triangle_runs.h"

#include "limes/subdiv/triangle_grid.h"

namespace limes {
namespace {

/// Where the middle of the edge that starts at a corner of a cell is among the corners of the finer
/// cells: the child at its start, the child at its end, the child in the middle (split.h).
std::array<std::uint16_t, 3> places_of_middle(int corner) {
  const int cell = corner / 3;
  const int i = corner % 3;
  const int end = (i + 1) % 3;
  const auto place = [&](int child, int c) {
    return static_cast<std::uint16_t>(3 * (4 * cell + child) + c);
  };
  return {place(i, 1), place(end, 2), place(3, i)};
}

}  // namespace

TriangleRuns::TriangleRuns(const TriangleNumbering& numbering, OwnedTriangleSides owned) {
  for (int birth = 1; birth <= numbering.depth(); ++birth) {
    Step step;
    for (auto& side : step.side_vertices)
      side.resize(std::size_t{1} << (birth - 1));
    std::vector<std::int32_t> ranks;  // by edge
    for (const TriangleNumbering::EdgeNode& e : numbering.edges(birth)) {
      const bool is_owned = e.side < 0 || ((owned >> e.side) & 1U) != 0;
      ranks.push_back(is_owned ? step.num_edges++ : 0);
      if (is_owned)
        offsets_.push_back(static_cast<std::uint16_t>(4 * TriangleGrid::place(e.i, e.j)));
      if (e.side >= 0)
        step.side_vertices[static_cast<std::size_t>(e.side)][e.step] = {
            places_of_middle(e.corner), static_cast<std::uint16_t>(ranks.back())};
    }
    for (const std::uint16_t e : numbering.edge_at_corner(birth))
      step.edge_ranks.push_back(ranks[e]);
    steps_.push_back(std::move(step));
  }
}

}  // namespace limes
