#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "limes/limit/ring_kind.h"

namespace limes {

/// How the faces of one ring kind fall into tiles, rectangles of their parameters in which the limit
/// is one bicubic polynomial, and how the polynomials follow from the control points.
///
///     +-------+-------+      Around an extraordinary vertex (here corner 0) squares halve;
///     |       |       |      `max_depth` of them are kept, the square x that is left is "deep":
///     |   3   |   2   |      its points are refined further when one falls into it.
///     |       |       |
///     +---+---+-------+      Beside a semi-sharp crease (see CreaseStrip) tiles are as wide as the
///     | 6 | 5 |       |      face, and up to three are high.
///     +-+-+---+   1   |
///     |x|4|   |       |      The numbers are those of the tiles.
///     +-+-+---+-------+
///
struct TileTree {
  /// [u, u + 2^-ku] x [v, v + 2^-kv]
  struct Rectangle {
    double u = 0, v = 0;
    int ku = 0, kv = 0;
  };

  /// Where to go next: next[i], i = (u > node.u) + 2 (v > node.v). A number >= 0 is a node, ~t is
  /// tile t, and beyond the tiles ~(num_tiles + d) is deep square d.
  struct Node {
    double u, v;
    std::array<std::int32_t, 4> next;
  };
  std::vector<std::int32_t> roots;  ///< one per quadrant
  std::vector<Node> nodes;

  /// Squares in the order in which control points are refined, the parent before its children. The
  /// first is the face; for a face that is no quad its children are the quadrants.
  struct Square {
    int kind;
    int parent, child;  ///< child `child` of square `parent`, or -1
    int rotation;       ///< corner 0 of its kind is corner `rotation` in the order of u and v
    int depth;          ///< its size is 2^-depth
    double u, v;        ///< corner with the lowest parameters
    int first_row;      ///< of its controls among those of all squares
  };
  std::vector<Square> squares;
  int num_rows = 0;

  struct Tile {
    int square;
    int grid;             ///< in grids: 16 B-spline points from the controls of the square's kind
    int turn;             ///< corner of the grid where the tile's frame begins
    Rectangle rectangle;  ///< in u and v
    int rows;             ///< in row_maps, or -1: the grid as it is
  };
  std::vector<Tile> tiles;
  std::vector<SparseMatrix> grids;
  /// Lines of points along a crease, from those of a grid; see tile_tree.cpp.
  std::vector<Eigen::Matrix4d> row_maps;

  struct Deep {
    int square;
    std::int64_t first;  ///< of its numbers behind the tiles: base point, then controls
  };
  std::vector<Deep> deep;

  static constexpr int max_depth = 8;
  static constexpr int max_tiles = 256;  ///< squares are not split beyond
  static constexpr int numbers_per_tile = 64;

  /// Size of what a face stores, in numbers: tiles, then deep squares.
  std::int64_t size = 0;
};

/// @param kind       of the face
/// @param face_size  its number of corners
[[nodiscard]] TileTree build_tile_tree(const RingKinds& kinds, int kind, int face_size);

}  // namespace limes
