#pragma once

#include <vector>

#include "limes/core/types.h"

namespace limes {

/// The control polygon of a curve.
struct Polyline {
  std::vector<Vec3> points;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
};

}  // namespace limes
