#pragma once

namespace limes {

/// What is done where leaves of different levels of a forest meet.
enum class Closure {
  conforming,  ///< only quads, which needs SplitUnit::families, or only triangles; no vertex inside a side
  triangles,  ///< triangles in the coarser leaf; no vertex inside a side
  hanging     ///< nothing: vertices inside sides remain
};

}  // namespace limes
