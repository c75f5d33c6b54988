#pragma once

#include "limes/study/plane_model.h"

namespace limes {

/// Sum of all loads of a problem, (2 num_dofs).
///
/// force: at the limit point of every selected vertex. force_per_length: along the selected boundary
/// sides. force_per_area: on the selected faces, per area of the middle surface. force_per_volume:
/// on the faces, times their thickness. pressure: on the selected boundary sides, times the
/// thickness, against the outward normal.
/// @throws InputError for an empty selection, naming the line
[[nodiscard]] VectorX assemble_loads(const PlaneModel& model);

}  // namespace limes
