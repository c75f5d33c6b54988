#include "limes/fem/element_points.h"

namespace limes {

void to_physical(const ElementTable& table, const Eigen::Matrix<double, Eigen::Dynamic, 3>& P,
                 ElementPoints& out) {
  // Differences to the first control point: no digits are lost far from the origin.
  const Eigen::RowVector3d origin = P.row(0);
  const Eigen::Matrix<double, Eigen::Dynamic, 3> local = P.rowwise() - origin;
  out.x = (table.G * local).rowwise() + origin;
  const Eigen::Matrix<double, Eigen::Dynamic, 2> xu = table.Gu * local.leftCols<2>();
  const Eigen::Matrix<double, Eigen::Dynamic, 2> xv = table.Gv * local.leftCols<2>();
  out.J = xu.col(0).cwiseProduct(xv.col(1)) - xu.col(1).cwiseProduct(xv.col(0));
  const VectorX inverse = out.J.cwiseInverse();
  const auto combine = [&](const VectorX& a, const VectorX& b) -> MatrixX {
    return a.cwiseProduct(inverse).asDiagonal() * table.Nu +
           b.cwiseProduct(inverse).asDiagonal() * table.Nv;
  };
  out.Nx = combine(xv.col(1), -xu.col(1));
  out.Ny = combine(-xv.col(0), xu.col(0));
}

std::optional<Fold> find_fold(const SubdivisionSpace& space) {
  double sign = 0;
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    const Element& element = space.elements()[static_cast<std::size_t>(e)];
    const ElementTable& table = space.table(element.shape);
    const auto P = space.control_points(e);
    const Eigen::Matrix<double, Eigen::Dynamic, 2> xu = table.Gu * P.leftCols<2>();
    const Eigen::Matrix<double, Eigen::Dynamic, 2> xv = table.Gv * P.leftCols<2>();
    for (Eigen::Index i = 0; i < xu.rows(); ++i) {
      const double J = xu(i, 0) * xv(i, 1) - xu(i, 1) * xv(i, 0);
      if (sign == 0 && J != 0) sign = J > 0 ? 1 : -1;
      if (J * sign > 0) continue;
      return Fold{element.face, (table.G.row(i) * P).transpose()};
    }
  }
  return std::nullopt;
}

}  // namespace limes
