#include "limes/limit/tile_tree.h"

#include <algorithm>
#include <cmath>

#include "limes/limit/crease_strip.h"
#include "limes/subdiv/crease.h"

namespace limes {
namespace {

using RowMap = Eigen::Matrix4d;

// Four lines of control points r0 to r3 along a crease at t = 0 are kept as r1, r0 - r1, r2 - r1,
// r3 - r1: differences across the crease shrink from step to step, and keep their digits this way.

/// The lines of the half [0, 1/2] in t after one step of the scheme.
/// @param own, opposite  sharpness of the creases along r1 and r2
RowMap lower_half(float own, float opposite) {
  const double smooth_1 = 1.0 - std::min(1.0, static_cast<double>(own));
  const double smooth_2 = 1.0 - std::min(1.0, static_cast<double>(opposite));
  RowMap W;
  // r1' = r1 + smooth_1 (d0 + d2) / 8
  W.row(0) << 1, smooth_1 / 8, smooth_1 / 8, 0;
  const Eigen::RowVector4d moved(0, smooth_1 / 8, smooth_1 / 8, 0);
  W.row(1) = Eigen::RowVector4d(0, 0.5, 0, 0) - moved;
  W.row(2) = Eigen::RowVector4d(0, 0, 0.5, 0) - moved;
  // r2' = r2 + smooth_2 (r1 - 2 r2 + r3) / 8
  W.row(3) = Eigen::RowVector4d(0, 0, 1 - smooth_2 / 4, smooth_2 / 8) - moved;
  return W;
}

/// The lines of the half [1/2, 1]; r2 is smooth.
RowMap upper_half(float own) {
  const double smooth = 1.0 - std::min(1.0, static_cast<double>(own));
  RowMap W;
  W.row(0) << 1, 0, 0.5, 0;
  W.row(1) << 0, smooth / 8, smooth / 8 - 0.5, 0;
  W.row(2) << 0, 0, 0.25, 0.125;
  W.row(3) << 0, 0, 0, 0.5;
  return W;
}

/// Beyond an infinitely sharp crease: r0 = 2 r1 - r2.
RowMap phantom() {
  RowMap W = RowMap::Identity();
  W.row(1) << 0, 0, -1, 0;
  return W;
}

/// A part [t, t + 2^-k] of a square, in a frame with corner 0 at the square's corner `rotation`.
struct Slab {
  int rotation;
  double t = 0;
  int k = 0;
};

TileTree::Rectangle rectangle_of(const TileTree::Square& square, const Slab& slab) {
  const double width = std::ldexp(1.0, -square.depth);
  const double low = slab.rotation % 4 == 0 || slab.rotation % 4 == 3
                         ? slab.t
                         : 1.0 - slab.t - std::ldexp(1.0, -slab.k);
  TileTree::Rectangle r{square.u, square.v, square.depth, square.depth};
  if (slab.rotation % 2 == 0) {
    r.v += width * low;
    r.kv += slab.k;
  } else {
    r.u += width * low;
    r.ku += slab.k;
  }
  return r;
}

class TreeBuilder {
 public:
  explicit TreeBuilder(const RingKinds& kinds) : kinds_(kinds) {}

  TileTree build(int kind, int face_size) {
    if (face_size == 4) {
      add_root(kind, -1, -1);
    } else {
      tree_.squares.push_back({kind, -1, -1, 0, 0, 0.0, 0.0, 0});
      tree_.num_rows = num_controls(kind);
      slots_.push_back({});
      const RefinedKind& refined = kinds_.refined(kind);
      for (int c = 0; c < face_size; ++c)
        add_root(refined.children[static_cast<std::size_t>(c)].kind, 0, c);
    }
    const std::size_t first = face_size == 4 ? 0 : 1;
    // Squares are appended while they are visited: level by level.
    for (std::size_t i = first; i < tree_.squares.size(); ++i)
      fill(slots_[i], code_of(static_cast<int>(i)));
    number_deep_squares();
    return std::move(tree_);
  }

 private:
  /// Where the number of a node or tile is written: next[quadrant] of a node, or a root.
  struct Slot {
    int node = -1;
    int index = 0;
  };
  static constexpr std::int32_t first_deep = -(1 << 30);

  [[nodiscard]] int num_controls(int kind) const { return kinds_[kind].ring.num_controls; }

  void add_root(int kind, int parent, int child) {
    slots_.push_back({-1, static_cast<int>(tree_.roots.size())});
    tree_.roots.push_back(0);
    add_square({kind, parent, child, 0, 0, 0.0, 0.0, 0});
  }
  void add_square(TileTree::Square square) {
    square.first_row = tree_.num_rows;
    tree_.num_rows += num_controls(square.kind);
    tree_.squares.push_back(square);
    ++pending_;
  }
  void fill(const Slot& slot, std::int32_t code) {
    const auto i = static_cast<std::size_t>(slot.index);
    if (slot.node < 0)
      tree_.roots[i] = code;
    else
      tree_.nodes[static_cast<std::size_t>(slot.node)].next[i] = code;
  }

  std::int32_t code_of(int index) {
    --pending_;
    const TileTree::Square square = tree_.squares[static_cast<std::size_t>(index)];
    const RingKind& kind = kinds_[square.kind];
    if (kind.patch) {
      const Slab whole{square.rotation, 0.0, 0};
      return add_tile(
          {index, grid_of(square.kind, *kind.patch), 0, rectangle_of(square, whole), -1});
    }
    if (const auto strip = crease_strip(kind.ring, kinds_.scheme().patch))
      return add_strip(index, *strip);
    const auto count = static_cast<int>(tree_.tiles.size()) + pending_;
    if (square.depth >= TileTree::max_depth || count >= TileTree::max_tiles) {
      tree_.deep.push_back({index, 0});
      return first_deep + static_cast<std::int32_t>(tree_.deep.size()) - 1;
    }
    return split(index, square);
  }

  std::int32_t split(int index, const TileTree::Square& square) {
    const RefinedKind& refined = kinds_.refined(square.kind);
    const double half = std::ldexp(0.5, -square.depth);
    const auto node = static_cast<std::int32_t>(tree_.nodes.size());
    tree_.nodes.push_back({square.u + half, square.v + half, {}});
    for (int corner = 0; corner < 4; ++corner) {  // in the order of u and v
      const int child = (corner - square.rotation + 4) % 4;
      const bool right = corner == 1 || corner == 2;
      const bool top = corner >= 2;
      slots_.push_back({node, (right ? 1 : 0) + (top ? 2 : 0)});
      add_square({refined.children[static_cast<std::size_t>(child)].kind, index, child, corner,
                  square.depth + 1, square.u + (right ? half : 0.0), square.v + (top ? half : 0.0),
                  0});
    }
    return node;
  }

  std::int32_t add_tile(const TileTree::Tile& tile) {
    tree_.tiles.push_back(tile);
    return ~static_cast<std::int32_t>(tree_.tiles.size() - 1);
  }

  int grid_of(int kind, const PatchGrid& grid) {
    const auto found = std::find(grid_kinds_.begin(), grid_kinds_.end(), kind);
    if (found != grid_kinds_.end()) return static_cast<int>(found - grid_kinds_.begin());
    grid_kinds_.push_back(kind);
    tree_.grids.push_back(MatrixX(grid).sparseView());
    return static_cast<int>(tree_.grids.size()) - 1;
  }

  // Strips

  std::int32_t add_strip(int index, const CreaseStrip& strip) {
    const int grid = grid_of(tree_.squares[static_cast<std::size_t>(index)].kind, strip.grid);
    const TileTree::Tile tile{index, grid, strip.side, {}, -1};
    if (strip.opposite <= 0)
      return add_slabs(tile, {frame(tile), 0.0, 0}, strip.sharpness, RowMap::Identity());
    TileTree::Tile other = tile;
    other.turn = (strip.side + 2) % 4;
    const std::int32_t low = add_slabs(tile, {frame(tile), 0.0, 1}, decayed(strip.sharpness),
                                       lower_half(strip.sharpness, strip.opposite));
    const std::int32_t high = add_slabs(other, {frame(other), 0.0, 1}, decayed(strip.opposite),
                                        lower_half(strip.opposite, strip.sharpness));
    return add_split(tile, 1, low, high);
  }

  [[nodiscard]] int frame(const TileTree::Tile& tile) const {
    return (tree_.squares[static_cast<std::size_t>(tile.square)].rotation + tile.turn) % 4;
  }

  /// The part [0, 2^-k] with one crease of sharpness s along t = 0, whose lines are W times the
  /// grid's: what lies beyond 2^-(k + floor s) does not know that the crease will end, and is one
  /// polynomial; then one step blends.
  std::int32_t add_slabs(const TileTree::Tile& tile, Slab slab, float s, RowMap W) {
    if (s <= 0) return add_slab(tile, slab, W);
    if (s < 1) {
      const std::int32_t low =
          add_slab(tile, {slab.rotation, 0.0, slab.k + 1}, lower_half(s, 0) * W);
      const double half = std::ldexp(0.5, -slab.k);
      const std::int32_t high =
          add_slab(tile, {slab.rotation, half, slab.k + 1}, upper_half(s) * W);
      return add_split(tile, slab.k + 1, low, high);
    }
    const std::int32_t high = add_slab(tile, slab, phantom() * W);
    for (; s >= 1; s = decayed(s), ++slab.k)
      W = lower_half(s, 0) * W;
    const std::int32_t low = add_slabs(tile, slab, s, W);
    return add_split(tile, slab.k, low, high);
  }

  std::int32_t add_slab(TileTree::Tile tile, const Slab& slab, const RowMap& W) {
    tile.rectangle = rectangle_of(tree_.squares[static_cast<std::size_t>(tile.square)], slab);
    tile.rows = static_cast<int>(tree_.row_maps.size());
    tree_.row_maps.push_back(W);
    return add_tile(tile);
  }

  /// A node that separates t <= 2^-k of a square (near) from the rest.
  std::int32_t add_split(const TileTree::Tile& tile, int k, std::int32_t near, std::int32_t far) {
    const TileTree::Square& square = tree_.squares[static_cast<std::size_t>(tile.square)];
    const int rotation = frame(tile);
    const TileTree::Rectangle r = rectangle_of(square, {rotation, 0.0, k});
    const bool starts_low = rotation == 0 || rotation == 3;
    const std::int32_t low = starts_low ? near : far;
    const std::int32_t high = starts_low ? far : near;
    constexpr double never = 2.0;
    TileTree::Node node{never, never, {}};
    if (rotation % 2 == 0) {
      node.v = r.v + (starts_low ? std::ldexp(1.0, -r.kv) : 0.0);
      node.next = {low, low, high, high};
    } else {
      node.u = r.u + (starts_low ? std::ldexp(1.0, -r.ku) : 0.0);
      node.next = {low, high, low, high};
    }
    tree_.nodes.push_back(node);
    return static_cast<std::int32_t>(tree_.nodes.size()) - 1;
  }

  /// Deep squares are numbered from the last tile on, and given room behind the tiles.
  void number_deep_squares() {
    const auto num_tiles = static_cast<std::int32_t>(tree_.tiles.size());
    const auto renumber = [&](std::int32_t& code) {
      if (code < 0 && code < first_deep + (1 << 29)) code = ~(num_tiles + (code - first_deep));
    };
    for (std::int32_t& root : tree_.roots)
      renumber(root);
    for (TileTree::Node& node : tree_.nodes)
      for (std::int32_t& next : node.next)
        renumber(next);
    tree_.size = std::int64_t{TileTree::numbers_per_tile} * num_tiles;
    for (TileTree::Deep& deep : tree_.deep) {
      deep.first = tree_.size;
      const int kind = tree_.squares[static_cast<std::size_t>(deep.square)].kind;
      tree_.size += 3 + 3 * std::int64_t{num_controls(kind)};
    }
  }

  const RingKinds& kinds_;
  TileTree tree_;
  std::vector<Slot> slots_;  // of each square
  std::vector<int> grid_kinds_;
  int pending_ = 0;  // squares not visited yet
};

}  // namespace

TileTree build_tile_tree(const RingKinds& kinds, int kind, int face_size) {
  return TreeBuilder(kinds).build(kind, face_size);
}

}  // namespace limes
