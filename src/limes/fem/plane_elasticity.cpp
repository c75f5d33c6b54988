#include "limes/fem/plane_elasticity.h"

#include "limes/fem/assemble.h"

namespace limes {
namespace {

using Strided = Eigen::Map<MatrixX, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;

/// Block (i, j) of an element matrix: all functions, one component each.
Strided block(MatrixX& K, int i, int j) {
  const Eigen::Index k = K.rows() / 2;
  return {K.data() + i + j * K.rows(), k, k,
          Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>(2 * K.rows(), 2)};
}

/// K_ab = B_a^T C B_b with B_a = [N_a,x 0; 0 N_a,y; N_a,y N_a,x], summed over the points.
void element_stiffness(const ElementPoints& p, const VectorX& weight, const Mat3& C, MatrixX& K) {
  const VectorX dA = p.J.cwiseAbs().cwiseProduct(weight);
  const MatrixX wx = dA.asDiagonal() * p.Nx;
  const MatrixX wy = dA.asDiagonal() * p.Ny;
  const MatrixX xx = p.Nx.transpose() * wx;
  const MatrixX xy = p.Nx.transpose() * wy;
  const MatrixX yy = p.Ny.transpose() * wy;
  const MatrixX sum = xy + xy.transpose();
  K.resize(2 * xx.rows(), 2 * xx.rows());
  block(K, 0, 0) = C(0, 0) * xx + C(2, 2) * yy + C(0, 2) * sum;
  block(K, 1, 1) = C(1, 1) * yy + C(2, 2) * xx + C(1, 2) * sum;
  const MatrixX mixed = C(0, 1) * xy + C(2, 2) * xy.transpose() + C(0, 2) * xx + C(1, 2) * yy;
  block(K, 0, 1) = mixed;
  block(K, 1, 0) = mixed.transpose();
}

ElementPoints points_of(const SubdivisionSpace& space, int e) {
  ElementPoints points;
  to_physical(space.table(space.elements()[static_cast<std::size_t>(e)].shape),
              space.control_points(e), points);
  return points;
}

const VectorX& weights_of(const SubdivisionSpace& space, int e) {
  return space.table(space.elements()[static_cast<std::size_t>(e)].shape).weight;
}

}  // namespace

SparseMatrix elasticity_matrix(const SubdivisionSpace& space, const ElementStiffness& C) {
  return assemble(space, 2, [&](int e, MatrixX& K) {
    element_stiffness(points_of(space, e), weights_of(space, e), C[static_cast<std::size_t>(e)], K);
  });
}

UnitStrainLoad unit_strain_load(const SubdivisionSpace& space, const ElementStiffness& C) {
  UnitStrainLoad out{MatrixX(2 * static_cast<Eigen::Index>(space.num_dofs()), 3), Mat3::Zero(), 0};
  for (int k = 0; k < 3; ++k)
    out.f.col(k) = assemble_vector(space, 2, [&](int e, VectorX& f) {
      const ElementPoints p = points_of(space, e);
      const VectorX dA = p.J.cwiseAbs().cwiseProduct(weights_of(space, e));
      const Vec3 stress = C[static_cast<std::size_t>(e)].col(k);
      const VectorX gx = p.Nx.transpose() * dA;
      const VectorX gy = p.Ny.transpose() * dA;
      f.resize(2 * gx.size());
      Eigen::Map<VectorX, 0, Eigen::InnerStride<2>>(f.data(), gx.size()) =
          stress(0) * gx + stress(2) * gy;
      Eigen::Map<VectorX, 0, Eigen::InnerStride<2>>(f.data() + 1, gx.size()) =
          stress(1) * gy + stress(2) * gx;
    });
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    const double area = points_of(space, e).J.cwiseAbs().dot(weights_of(space, e));
    out.integral_of_C += area * C[static_cast<std::size_t>(e)];
    out.area += area;
  }
  return out;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> strains(
    const ElementPoints& points, const Eigen::Matrix<double, Eigen::Dynamic, 2>& u) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> out(points.Nx.rows(), 3);
  out.col(0) = points.Nx * u.col(0);
  out.col(1) = points.Ny * u.col(1);
  out.col(2) = points.Ny * u.col(0) + points.Nx * u.col(1);
  return out;
}

Eigen::Matrix<double, Eigen::Dynamic, 2> element_field(const SubdivisionSpace& space, int element,
                                                       const VectorX& u) {
  const auto dofs = space.dofs(element);
  Eigen::Matrix<double, Eigen::Dynamic, 2> out(static_cast<Eigen::Index>(dofs.size()), 2);
  for (std::size_t a = 0; a < dofs.size(); ++a)
    out.row(static_cast<Eigen::Index>(a)) = u.segment<2>(2 * dofs[a]).transpose();
  return out;
}

}  // namespace limes
