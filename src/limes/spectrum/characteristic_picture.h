#pragma once

#include <span>

#include "limes/report/canvas.h"
#include "limes/spectrum/spectrum.h"

namespace limes {

/// The characteristic maps of several valences side by side, each with its rings in two tints, the
/// images of equal faces in two grids of lines and its eigenvalues below. A valence without a map
/// gets a panel that says why.
[[nodiscard]] Drawing characteristic_picture(const Scheme& scheme,
                                             std::span<const Analysis> results);

}  // namespace limes
