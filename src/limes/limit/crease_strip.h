#pragma once

#include <optional>

#include "limes/limit/regular_patch.h"

namespace limes {

/// A ring that is regular but for one semi-sharp crease straight along a side, or two along opposite
/// sides: across the crease its limit is a univariate problem, and a few polynomials that are as
/// wide as the face replace the many squares along the crease (compare [niessner_2012]).
struct CreaseStrip {
  PatchGrid grid;   ///< control points as if nothing were semi-sharp
  int side;         ///< a crease runs along the side from corner `side` to the next
  float sharpness;  ///< of that side, > 0
  float opposite;   ///< of the opposite side, or 0
};

/// The strip that a ring is, if it is one. Precondition: it has no regular patch.
[[nodiscard]] std::optional<CreaseStrip> crease_strip(const Ring& ring, LimitPatch patch);

}  // namespace limes
