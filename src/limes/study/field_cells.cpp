#include "limes/study/field_cells.h"

#include "limes/core/interrupt.h"

namespace limes {
namespace {

std::vector<Vec2> grid_of(const ParameterTile& tile, int n) {
  std::vector<Vec2> points;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      points.emplace_back(tile.origin + tile.size / n * Vec2(i, j));
  return points;
}

}  // namespace

void for_each_field_cell(const PlaneModel& model, const PlaneSolution& solution, int n, int depth,
                         const std::function<void(const FieldCell&)>& use) {
  const SubdivisionSpace& space = *model.space;
  struct TileTable {
    ParameterTile tile;
    ElementTable table;
  };
  std::vector<std::vector<TileTable>> tables;  // per shape, per tile
  for (int s = 0; s < space.num_shapes(); ++s) {
    tables.emplace_back();
    for (const ParameterTile& tile : space.tiles(s, depth))
      tables.back().push_back({tile, space.sample(s, grid_of(tile, n))});
  }
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    if (e % 1024 == 0) check_interrupt();
    const int shape = space.elements()[static_cast<std::size_t>(e)].shape;
    for (const auto& [tile, table] : tables[static_cast<std::size_t>(shape)])
      use({e, tile, states(model, solution, e, table)});
  }
}

}  // namespace limes
