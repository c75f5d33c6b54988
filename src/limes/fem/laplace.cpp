#include "limes/fem/laplace.h"

#include "limes/fem/assemble.h"

namespace limes {

SparseMatrix laplace_matrix(const SubdivisionSpace& space, double c) {
  return assemble(space, 1, [&](int e, MatrixX& K) {
    const ElementTable& table = space.table(space.elements()[static_cast<std::size_t>(e)].shape);
    ElementPoints p;
    to_physical(table, space.control_points(e), p);
    const VectorX dA = p.J.cwiseAbs().cwiseProduct(table.weight);
    K = p.Nx.transpose() * dA.asDiagonal() * p.Nx + p.Ny.transpose() * dA.asDiagonal() * p.Ny +
        c * (table.N.transpose() * dA.asDiagonal() * table.N);
  });
}

}  // namespace limes
