#pragma once

#include <cstdint>

#include "limes/core/ids.h"
#include "limes/subdiv/point4.h"
#include "limes/subdiv/regular_rules.h"

namespace limes {

/// The loops over the points of a TriangleGrid and the cells of its numbering, for one instruction
/// set. All give the same bits.
struct TriangleKernel {
  /// The grid one step finer, margin included, of a grid of n cells a side.
  /// @param axes  by place on the coarse grid: where the ring of a vertex starts (TriangleNumbering)
  void (*refine)(RegularTriangleMasks, int n, const std::uint8_t* axes, const Point4* coarse,
                 Point4* fine);
  /// Some points of a grid, one after another.
  /// @param offsets  of the points, counted in doubles
  void (*write)(const Point4* grid, const std::uint16_t* offsets, int count, Vec3* out);
  /// Corners of the cells of a grid one step finer, in the order of quadrisection (split.h).
  /// @param corners     three to a cell
  /// @param edge_ranks  the same of edges; their ids are those plus first_edge
  void (*split)(int num_cells, const VertexId* corners, const std::int32_t* edge_ranks,
                std::int32_t first_edge, VertexId* fine);

  /// For every machine.
  [[nodiscard]] static const TriangleKernel& two_doubles();
  /// The fastest for this one: four doubles to a vector where it has AVX2.
  [[nodiscard]] static const TriangleKernel& best();
};

/// A vertex of a grid from its neighbours, whose ring starts on an axis.
/// @param v  its place in the points of a TriangleGrid
[[nodiscard]] Point4 regular_vertex(const RegularTriangleMasks& masks, const Point4* v, int axis);

}  // namespace limes
