#include "limes/limit/deep_tile.h"

#include <cmath>
#include <utility>

namespace limes {
namespace {

/// A point in the frame that begins at corner c, and back.
Vec2 turned_to(const Vec2& p, int c) {
  switch (c) {
    case 0:
      return p;
    case 1:
      return {p.y(), 1.0 - p.x()};
    case 2:
      return {1.0 - p.x(), 1.0 - p.y()};
    default:
      return {1.0 - p.y(), p.x()};
  }
}
Vec2 turned_from(const Vec2& p, int c) {
  return turned_to(p, (4 - c) % 4);
}

/// Quadrant of a square that holds a point; only corner 0 itself stays in quadrant 0 for ever.
int quadrant_of(const Vec2& p) {
  if (p.x() > 0.5) return p.y() > 0.5 ? 2 : 1;
  return p.y() > 0.5 ? 3 : 0;
}

LocalControls stored_controls(int count, const double* numbers) {
  const auto get = [&] {
    const Vec3 x(numbers[0], numbers[1], numbers[2]);
    numbers += 3;
    return x;
  };
  LocalControls out;
  out.base = get();
  out.points.resize(static_cast<std::size_t>(count));
  for (Vec3& x : out.points)
    x = get();
  return out;
}

void constant_tile(const RefinedKind& kind, const LocalControls& controls, TileCoefficients& out) {
  Vec3 limit = Vec3::Zero();
  for (std::size_t k = 0; k < controls.points.size(); ++k)
    limit += kind.limit[static_cast<Eigen::Index>(k)] * controls.points[k];
  out.c.fill(0.0);
  for (std::size_t k = 0; k < 3; ++k)
    out.c[k] = (controls.base + limit)[static_cast<Eigen::Index>(k)];
}

}  // namespace

DeepPoint deep_tile(const RingKinds& kinds, const TileTree& tree, int deep, const double* numbers,
                    const Vec2& uv, TileCoefficients& tile, TilePoint& point) {
  const TileTree::Deep& stored = tree.deep[static_cast<std::size_t>(deep)];
  const TileTree::Square& square = tree.squares[static_cast<std::size_t>(stored.square)];
  const double scale = std::ldexp(1.0, square.depth);
  Vec2 local = turned_to(scale * (uv - Vec2(square.u, square.v)), square.rotation);
  int kind = square.kind;
  int rotation = square.rotation;
  int depth = square.depth;
  LocalControls controls = stored_controls(kinds[kind].ring.num_controls, numbers + stored.first);
  LocalControls next;
  for (; !kinds[kind].patch; ++depth) {
    const RefinedKind& refined = kinds.refined(kind);
    if (refined.self_similar && (local.isZero(0.0) || depth > LimitBasis::max_depth)) {
      constant_tile(refined, controls, tile);
      point = {tile.c.data(), 0.0, 0.0};
      return {LimitBasis::Point::extraordinary, 0};
    }
    const int c = quadrant_of(local);
    refine_controls(refined, c, controls, next);
    std::swap(controls, next);
    local = 2.0 * turned_to(local, c);
    rotation = (rotation + c) % 4;
    kind = refined.children[static_cast<std::size_t>(c)].kind;
  }
  const SparseMatrix grid = MatrixX(*kinds[kind].patch).sparseView();
  tile_coefficients(grid, 0, nullptr, rotation, {}, controls, tile.c.data());
  const Vec2 at = turned_from(local, rotation);
  point = {tile.c.data(), at.x(), at.y()};
  return {LimitBasis::Point::ordinary, depth};
}

}  // namespace limes
