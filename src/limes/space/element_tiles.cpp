#include "limes/space/element_tiles.h"

#include <algorithm>

namespace limes {
namespace {

/// A sub-square in its own frame: corner 0 at the origin, u along a, v along b.
struct Frame {
  Vec2 origin, a, b;
};

/// The quadrant at corner c, whose own corner 0 is that corner.
Frame child_frame(const Frame& f, int c) {
  switch (c) {
    case 0:
      return {f.origin, 0.5 * f.a, 0.5 * f.b};
    case 1:
      return {f.origin + f.a, 0.5 * f.b, -0.5 * f.a};
    case 2:
      return {f.origin + f.a + f.b, -0.5 * f.a, -0.5 * f.b};
    default:
      return {f.origin + f.b, -0.5 * f.b, 0.5 * f.a};
  }
}

ParameterTile tile_of(const Frame& f) {
  const Vec2 opposite = f.origin + f.a + f.b;
  return {f.origin.cwiseMin(opposite), std::abs(f.a.x() + f.a.y())};
}

/// A kind of ring on the way down.
struct KindAt {
  const RingKinds* kinds;
  int kind;
};

class TileWalk {
 public:
  std::vector<ParameterTile> tiles;

  /// @param depth  rings still allowed around corners that never become polynomial
  void add(const std::vector<KindAt>& functions, const Frame& frame, int depth) {
    const bool polynomial = std::all_of(functions.begin(), functions.end(), [](const KindAt& f) {
      return (*f.kinds)[f.kind].patch.has_value();
    });
    const bool endless = std::any_of(functions.begin(), functions.end(), [](const KindAt& f) {
      return !(*f.kinds)[f.kind].patch && f.kinds->refined(f.kind).self_similar;
    });
    if (polynomial || (endless && depth == 0)) {
      tiles.push_back(tile_of(frame));
      return;
    }
    for (int c = 0; c < 4; ++c)
      add(children(functions, c), child_frame(frame, c), endless ? depth - 1 : depth);
  }

  static std::vector<KindAt> children(std::vector<KindAt> functions, int c) {
    for (KindAt& f : functions)
      if (!(*f.kinds)[f.kind].patch)
        f.kind = f.kinds->refined(f.kind).children[static_cast<std::size_t>(c)].kind;
    return functions;
  }
};

}  // namespace

std::vector<ParameterTile> element_tiles(const ElementShape& shape, int depth) {
  std::vector<KindAt> functions;
  for (const LimitBasis* basis : {shape.geometry, shape.field})
    functions.push_back({&basis->kinds(), basis->kind(shape.face)});
  if (shape.geometry->topology().face_size(shape.face) != 4)
    functions = TileWalk::children(std::move(functions), shape.corner);
  TileWalk walk;
  walk.add(functions, {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, depth);
  return std::move(walk.tiles);
}

}  // namespace limes
