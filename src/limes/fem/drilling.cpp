#include "limes/fem/drilling.h"

namespace limes {
namespace {

/// The row of omega at the centre: u_r . g^r x n + ... with the dual base of the tangent plane there.
ShellVector plane_rotation(const ShellQuad& quad, const Vec3& n) {
  constexpr std::array<double, 4> Nr{-0.25, 0.25, 0.25, -0.25}, Ns{-0.25, -0.25, 0.25, 0.25};
  Vec3 gr = Vec3::Zero(), gs = Vec3::Zero();
  for (std::size_t a = 0; a < 4; ++a) {
    gr += Nr[a] * quad.x[a];
    gs += Ns[a] * quad.x[a];
  }
  const double area = gr.cross(gs).dot(n);
  const Vec3 dual_r = gs.cross(n) / area, dual_s = n.cross(gr) / area;
  ShellVector row = ShellVector::Zero();
  for (std::size_t a = 0; a < 4; ++a)  // curl u = sum of grad N_a x u_a
    row.segment<3>(static_cast<Eigen::Index>(6 * a)) =
        0.5 * n.cross(Nr[a] * dual_r + Ns[a] * dual_s);
  return row;
}

}  // namespace

ShellMatrix drilling_stiffness(const ShellQuad& quad, const ShellSection& section,
                               const std::array<bool, 4>& nodes, double factor) {
  const Vec3 up = quad.area_normal({0, 0});
  const Vec3 n = up.normalized();
  const ShellVector omega = plane_rotation(quad, n);
  const double shear_modulus = section.young / (2 * (1 + section.poisson));
  const double stiffness = factor * shear_modulus * section.thickness * up.norm();  // |up| = A/4
  ShellMatrix K = ShellMatrix::Zero();
  for (std::size_t a = 0; a < 4; ++a) {
    if (!nodes[a]) continue;
    ShellVector row = -omega;
    row.segment<3>(static_cast<Eigen::Index>(6 * a + 3)) += n;
    K += stiffness * row * row.transpose();
  }
  return K;
}

}  // namespace limes
