#pragma once

#include <array>
#include <span>
#include <vector>

#include "limes/limit/tile_tree.h"

namespace limes {

/// Control points of a ring, (k, 3), without a base point that is added last: no digits are lost far
/// from the origin, or close to an extraordinary vertex.
struct LocalControls {
  Vec3 base;
  std::vector<Vec3> points;
};

/// One polynomial: x(u, v) = sum of c[4 i + j] (u - u0)^i (v - v0)^j. Each coefficient has four
/// numbers: x, y, z and one that is 0, except for u0 and v0 behind the first two coefficients.
struct alignas(64) TileCoefficients {
  std::array<double, TileTree::numbers_per_tile> c;
};

/// Controls of child `child` from those of its parent, relative to their first point.
void refine_controls(const RefinedKind& parent, int child, const LocalControls& controls,
                     LocalControls& out);

/// The polynomial of a tile.
/// @param grid       4 x 4 B-spline points from the controls (16, k)
/// @param rows       map of their lines as in TileTree::row_maps, or null
/// @param rotation   corner in the order of u and v at which the grid's frame begins, counting turn
/// @param turn       corner of the grid at which the frame begins
void tile_coefficients(const SparseMatrix& grid, int turn, const Eigen::Matrix4d* rows,
                       int rotation, const TileTree::Rectangle& rectangle,
                       const LocalControls& controls, double* out);

/// Fills what a face stores (TileTree::size numbers, aligned to 64 bytes). The same bits whenever it
/// is called. Scratch memory is kept between calls.
class TileFiller {
 public:
  void fill(const RingKinds& kinds, const TileTree& tree, std::span<const VertexId> controls,
            std::span<const Vec3> points, double* out);

 private:
  std::vector<LocalControls> squares_;
};

}  // namespace limes
