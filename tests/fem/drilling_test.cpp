// Drilling stiffness: nothing against rigid motions and constant strain, all against the rest.

#include "limes/fem/drilling.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

namespace limes {
namespace {

constexpr std::array<bool, 4> all{true, true, true, true};
const ShellSection section{2.5, 0.25, 0.5, 5.0 / 6, MembraneStrain::displacement};  // G = 1

ShellQuad curved_quad() {
  ShellQuad q;
  q.x = {Vec3(0, 0, 0), Vec3(2, 0.1, 0.3), Vec3(2.3, 1.7, 0.1), Vec3(-0.2, 1.4, 0.2)};
  q.director = {Vec3(-0.1, 0.05, 1), Vec3(0.2, 0, 1), Vec3(0.1, 0.2, 1), Vec3(0, 0.1, 1)};
  for (Vec3& v : q.director)
    v.normalize();
  return q;
}

TEST(Drilling, RigidMotionsAreFree) {
  const ShellQuad quad = curved_quad();
  const ShellMatrix K = drilling_stiffness(quad, section, all, 1);
  for (int k = 0; k < 6; ++k) {
    const Vec3 shift = k < 3 ? Vec3(Vec3::Unit(k)) : Vec3::Zero();
    const Vec3 turn = k < 3 ? Vec3::Zero() : Vec3(Vec3::Unit(k - 3));
    ShellVector u;
    for (std::size_t a = 0; a < 4; ++a) {
      u.segment<3>(static_cast<Eigen::Index>(6 * a)) = shift + turn.cross(quad.x[a]);
      u.segment<3>(static_cast<Eigen::Index>(6 * a + 3)) = turn;
    }
    EXPECT_LT((K * u).cwiseAbs().maxCoeff(), 1e-15) << k;
  }
}

// Without it the element has a zero eigenvalue for each node besides the rigid motions.
TEST(Drilling, LeavesNothingElse) {
  const ShellQuad quad = curved_quad();
  const ShellMatrix K =
      mitc4_stiffness(quad, section) + drilling_stiffness(quad, section, all, 1e-3);
  const Eigen::SelfAdjointEigenSolver<ShellMatrix> modes(K);
  EXPECT_LT(std::abs(modes.eigenvalues()(5)), 1e-13);
  EXPECT_GT(modes.eigenvalues()(6), 1e-6);
}

// In a flat element: u = A x with the rotation of A, and a node that turns alone.
TEST(Drilling, ActsAgainstTheRestOfTheRotation) {
  ShellQuad quad;
  quad.x = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)};
  quad.director.fill(Vec3::UnitZ());
  ShellVector u = ShellVector::Zero();
  for (std::size_t a = 0; a < 4; ++a) {
    const Vec3& x = quad.x[a];
    u.segment<2>(static_cast<Eigen::Index>(6 * a)) =
        Vec2(3 * x.x() + 0.5 * x.y(), 0.9 * x.x() - 2 * x.y());
    u(static_cast<Eigen::Index>(6 * a + 5)) = (0.9 - 0.5) / 2;
  }
  const ShellMatrix K = drilling_stiffness(quad, section, all, 0.1);
  EXPECT_LT((K * u).cwiseAbs().maxCoeff(), 1e-15);
  ShellVector turn = ShellVector::Zero();
  turn(11) = 1;
  EXPECT_NEAR(turn.dot(K * turn), 0.1 * 1 * 0.5 * 2 / 4, 1e-15);  // factor G t A/4
  EXPECT_EQ(turn.dot(drilling_stiffness(quad, section, {true, false, true, true}, 0.1) * turn), 0);
}

}  // namespace
}  // namespace limes
