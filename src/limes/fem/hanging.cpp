#include "limes/fem/hanging.h"

#include <array>

namespace limes {
namespace {

/// Three rows over the unknowns (u_a, theta_a, u_b, theta_b) of a side.
using SideRows = Eigen::Matrix<double, 3, 12>;

Mat3 cross_with(const Vec3& v) {
  Mat3 out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

/// The rotation vector of an end.
SideRows rotation_of(int end) {
  SideRows out = SideRows::Zero();
  out.middleCols<3>(6 * end + 3) = Mat3::Identity();
  return out;
}

/// The same, with the part along the director n such that t . (omega x e) is how the side turns, t
/// across it in the surface.
SideRows completed_rotation(int end, const Vec3& n, const Vec3& e, double length) {
  const Vec3 across = n.cross(e);
  const Vec3 t = across.normalized();
  SideRows out = SideRows::Zero();
  out.middleCols<3>(6 * end + 3) = Mat3::Identity() - n * n.transpose();
  Eigen::Matrix<double, 1, 12> turn = -e.cross(t).transpose() * out;
  turn.segment<3>(0) -= t / length;
  turn.segment<3>(6) += t / length;
  return out + n * turn / across.norm();
}

}  // namespace

std::vector<ConstraintRow> hanging_constraints(const SideNode& node, const SideNode& a,
                                               const SideNode& b) {
  const double length = (b.x - a.x).norm();
  const Vec3 e = (b.x - a.x) / length;
  const auto rotation = [&](int end, const SideNode& at) {
    return node.smooth || at.smooth ? completed_rotation(end, at.director, e, length)
                                    : rotation_of(end);
  };
  const SideRows at_a = rotation(0, a), at_b = rotation(1, b);
  const SideRows mean = (at_a + at_b) / 2;
  SideRows u = length / 8 * cross_with(e) * (at_b - at_a);
  u -= cross_with(node.x - (a.x + b.x) / 2) * mean;
  for (const int first : {0, 6})
    u.middleCols<3>(first) += 0.5 * Mat3::Identity();
  SideRows theta = mean;
  if (node.smooth) theta -= node.director * (node.director.transpose() * mean);

  std::vector<ConstraintRow> rows(6);
  for (int i = 0; i < 6; ++i) {
    ConstraintRow& row = rows[static_cast<std::size_t>(i)];
    row.emplace_back(node.first + i, -1.0);
    for (int j = 0; j < 12; ++j) {
      const double weight = i < 3 ? u(i, j) : theta(i - 3, j);
      if (weight != 0) row.emplace_back((j < 6 ? a.first : b.first) + j % 6, weight);
    }
  }
  return rows;
}

}  // namespace limes
