#pragma once

#include <span>
#include <vector>

#include "limes/fem/element_points.h"
#include "limes/fem/material.h"

namespace limes {

// Plane elasticity on a subdivision space: two components per dof, unknown 2 a + i. All matrices are
// per unit of thickness times the thickness of the element.

/// Elasticity matrix times thickness of every element, (3, 3) each.
using ElementStiffness = std::vector<Mat3>;

/// K_ab = integral of B_a^T C B_b.
[[nodiscard]] SparseMatrix elasticity_matrix(const SubdivisionSpace& space,
                                             const ElementStiffness& C);

/// f_a = integral of B_a^T C e for the three unit strains e: (2 num_dofs, 3), and the stiffness of
/// the rigid medium, integral of C: what an unrelaxed cell answers to a macroscopic strain.
struct UnitStrainLoad {
  MatrixX f;
  Mat3 integral_of_C;
  double area;
};
[[nodiscard]] UnitStrainLoad unit_strain_load(const SubdivisionSpace& space,
                                              const ElementStiffness& C);

/// Strain in Voigt order xx, yy, xy (engineering shear) at each point of a table, (q, 3).
/// @param u  coefficients of an element's functions, (k, 2)
[[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3> strains(
    const ElementPoints& points, const Eigen::Matrix<double, Eigen::Dynamic, 2>& u);

/// An element's coefficients of a vector field, (k, 2).
[[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 2> element_field(const SubdivisionSpace& space,
                                                                     int element, const VectorX& u);

}  // namespace limes
