#pragma once

#include "limes/mesh/mesh.h"

namespace limes {

/// One step of the scheme `kobbelt` with rule (3) of [kobbelt_1996] taken to the letter: its four
/// points are edge points of the new level, also where they come from beyond the faces around the
/// face, and the two directions, which then differ, are averaged. To compare with; see
/// docs/theory/kobbelt.md for why the scheme itself takes the outer two from around the face.
/// @param tension  16 omega
/// @throws InputError if the net is not closed, smooth and of quads
[[nodiscard]] Mesh refine_literally(const Mesh& closed, double tension);

}  // namespace limes
