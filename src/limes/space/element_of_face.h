#pragma once

#include <vector>

#include "limes/space/subdivision_space.h"

namespace limes {

/// Of each face of the space's mesh the number of its first element, the only one where functions are
/// bilinear; -1 for faces without, such as holes.
[[nodiscard]] std::vector<int> element_of_face(const SubdivisionSpace& space);

}  // namespace limes
