#include "limes/subdiv/quad_runs.h"

#include <algorithm>

namespace limes {
namespace {

/// Indices into the last grid but one, as QuadGrid lays it out.
struct GridIndex {
  int cells;

  [[nodiscard]] std::uint16_t vertex(QuadNumbering::Node n) const {
    return static_cast<std::uint16_t>((n.j / 2 + 1) * (cells + 3) + n.i / 2 + 1);
  }
  /// Face point of the cell that begins `di` and `dj` cells after the vertex at n / 2.
  [[nodiscard]] std::uint16_t face(QuadNumbering::Node n, int di, int dj) const {
    return static_cast<std::uint16_t>((n.j / 2 + dj + 1) * (cells + 2) + n.i / 2 + di + 1);
  }
};

}  // namespace

QuadRuns::QuadRuns(const QuadNumbering& numbering, OwnedSides owned) {
  const GridIndex grid{numbering.side() / 2};
  const auto place = [&](QuadNumbering::Node n) {
    places.push_back(static_cast<std::uint16_t>((numbering.side() + 1) * n.j + n.i));
  };
  for (int birth = 1; birth <= numbering.depth(); ++birth) {
    const bool last = birth == numbering.depth();
    std::uint16_t rank = 0;
    for (const QuadNumbering::EdgeNode& e : numbering.edge_run(birth, owned)) {
      place(e.node);
      if (e.side >= 0)
        side_rank_[static_cast<std::size_t>(e.side)]
                  [static_cast<std::size_t>((1 << (birth - 1)) - 1 + e.step)] = rank;
      ++rank;
      const bool upwards = e.from.i == e.to.i;
      const QuadNumbering::Node low{std::min(e.from.i, e.to.i), std::min(e.from.j, e.to.j)};
      if (last)
        new_edges.push_back({grid.vertex(e.from), grid.vertex(e.to), grid.face(low, 0, 0),
                             upwards ? grid.face(low, -1, 0) : grid.face(low, 0, -1)});
      else
        old_vertices.push_back({grid.vertex(e.node), grid.face(e.node, -1, -1)});
    }
    for (const QuadNumbering::Node n : numbering.face_run(birth)) {
      place(n);
      if (last)
        new_faces.push_back(grid.face(n, 0, 0));
      else
        old_vertices.push_back({grid.vertex(n), grid.face(n, -1, -1)});
    }
  }
}

}  // namespace limes
