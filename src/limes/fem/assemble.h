#pragma once

#include <functional>

#include "limes/space/subdivision_space.h"

namespace limes {

/// Writes the matrix of one element: (c k, c k) for c components and k functions, the components of
/// one function together (function a, component i at c a + i). Called from several threads.
using ElementMatrix = std::function<void(int element, MatrixX& K)>;

/// Sum of symmetric element matrices over all elements, (c num_dofs, c num_dofs); component i of
/// dof a is unknown c a + i. The same bits for any number of threads.
[[nodiscard]] SparseMatrix assemble(const SubdivisionSpace& space, int components,
                                    const ElementMatrix& element_matrix);

/// Writes the vector of one element, (c k).
using ElementVector = std::function<void(int element, VectorX& f)>;

[[nodiscard]] VectorX assemble_vector(const SubdivisionSpace& space, int components,
                                      const ElementVector& element_vector);

}  // namespace limes
