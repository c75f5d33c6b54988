#pragma once

#include "limes/fem/element_points.h"

namespace limes {

/// K_ab = integral of grad N_a . grad N_b + c N_a N_b over a plane domain: the H1 product for c = 1,
/// Poisson's operator for c = 0.
[[nodiscard]] SparseMatrix laplace_matrix(const SubdivisionSpace& space, double c);

}  // namespace limes
