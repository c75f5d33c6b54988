#include "limes/fem/mitc4.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace limes {
namespace {

ShellQuad curved_quad() {
  ShellQuad q;
  q.x = {Vec3(0, 0, 0), Vec3(2, 0.1, 0.3), Vec3(2.3, 1.7, 0.1), Vec3(-0.2, 1.4, 0.2)};
  q.director = {Vec3(-0.1, 0.05, 1), Vec3(0.2, 0, 1), Vec3(0.1, 0.2, 1), Vec3(0, 0.1, 1)};
  for (Vec3& v : q.director)
    v.normalize();
  return q;
}

/// Five distorted quads around an inner one, in the square [0, 3]^2: the usual patch.
struct Patch {
  std::array<Vec3, 8> x{Vec3(0, 0, 0),     Vec3(3, 0, 0),     Vec3(3, 3, 0),     Vec3(0, 3, 0),
                        Vec3(0.8, 1.1, 0), Vec3(2.1, 0.7, 0), Vec3(1.9, 2.2, 0), Vec3(1.2, 1.8, 0)};
  std::array<std::array<std::size_t, 4>, 5> quads{
      {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};

  [[nodiscard]] ShellQuad quad(std::size_t e) const {
    ShellQuad q;
    for (std::size_t a = 0; a < 4; ++a) {
      q.x[a] = x[quads[e][a]];
      q.director[a] = Vec3::UnitZ();
    }
    return q;
  }
  [[nodiscard]] ShellVector field(std::size_t e, const auto& of_point) const {
    ShellVector u;
    for (std::size_t a = 0; a < 4; ++a)
      u.segment<6>(static_cast<Eigen::Index>(6 * a)) = of_point(x[quads[e][a]]);
    return u;
  }
};

using NodeVector = Eigen::Matrix<double, 6, 1>;

/// Energy of a field given at the nodes, and the largest force on an inner node.
std::pair<double, double> energy_and_inner_force(const ShellSection& section, const auto& field) {
  const Patch patch;
  std::array<NodeVector, 8> force;
  force.fill(NodeVector::Zero());
  double energy = 0;
  for (std::size_t e = 0; e < 5; ++e) {
    const ShellVector u = patch.field(e, field);
    const ShellVector f = mitc4_stiffness(patch.quad(e), section) * u;
    energy += u.dot(f) / 2;
    for (std::size_t a = 0; a < 4; ++a)
      force[patch.quads[e][a]] += f.segment<6>(static_cast<Eigen::Index>(6 * a));
  }
  double inner = 0;
  for (std::size_t n = 4; n < 8; ++n)
    inner = std::max(inner, force[n].cwiseAbs().maxCoeff());
  return {energy, inner};
}

class EveryMembrane : public ::testing::TestWithParam<MembraneStrain> {
 protected:
  static ShellSection section(double young, double poisson, double thickness) {
    return {young, poisson, thickness, 5.0 / 6, GetParam()};
  }
};
INSTANTIATE_TEST_SUITE_P(Mitc4, EveryMembrane,
                         ::testing::Values(MembraneStrain::displacement, MembraneStrain::assumed),
                         [](const auto& strain) {
                           return strain.param == MembraneStrain::assumed ? "assumed"
                                                                          : "displacement";
                         });

TEST_P(EveryMembrane, RigidMotionsAreFreeOnCurvedQuads) {
  const ShellQuad q = curved_quad();
  const ShellMatrix K = mitc4_stiffness(q, section(2e3, 0.3, 0.1));
  EXPECT_EQ((K - K.transpose()).norm(), 0);
  for (int mode = 0; mode < 6; ++mode) {
    ShellVector u = ShellVector::Zero();
    for (std::size_t a = 0; a < 4; ++a) {
      const auto first = static_cast<Eigen::Index>(6 * a);
      if (mode < 3) {
        u(first + mode) = 1;
      } else {
        u.segment<3>(first + 3) = Vec3::Unit(mode - 3);
        u.segment<3>(first) = Vec3::Unit(mode - 3).cross(q.x[a]);
      }
    }
    EXPECT_LT((K * u).norm(), 1e-12 * K.norm() * u.norm()) << mode;
  }
}

// Six rigid motions and the rotation about the director at each node, nothing else.
TEST_P(EveryMembrane, HasNoSpuriousMechanism) {
  const ShellMatrix K = mitc4_stiffness(curved_quad(), section(1, 0.3, 0.5));
  const auto values = Eigen::SelfAdjointEigenSolver<ShellMatrix>(K).eigenvalues();
  EXPECT_LT(std::abs(values(9)), 1e-14);
  EXPECT_GT(values(10), 1e-6);
}

TEST_P(EveryMembrane, ConstantMembraneStrainOnDistortedPatch) {
  const Mat2 eps = (Mat2() << 1e-3, 4e-4, 4e-4, -2e-3).finished();
  const auto [energy, inner] = energy_and_inner_force(section(1000, 0.25, 0.2), [&](const Vec3& x) {
    NodeVector u = NodeVector::Zero();
    u.head<2>() = eps * x.head<2>();
    return u;
  });
  const double c = 1000 * 0.2 / (1 - 0.25 * 0.25);
  const double density =
      c / 2 * ((1 - 0.25) * eps.squaredNorm() + 0.25 * eps.trace() * eps.trace());
  EXPECT_NEAR(energy, 9 * density, 1e-12 * energy);
  EXPECT_LT(inner, 1e-12);
}

// w = x . kappa x / 2 with Kirchhoff's rotations theta = (w,y, -w,x): no shear, constant moments.
TEST_P(EveryMembrane, ConstantCurvatureOnDistortedPatch) {
  const ShellSection plate = section(1000, 0.25, 0.1);
  const Mat2 kappa = (Mat2() << 0.3, 0.1, 0.1, -0.2).finished();
  const auto field = [&](const Vec3& x) {
    const Vec2 gradient = kappa * x.head<2>();
    NodeVector u;
    u << 0, 0, x.head<2>().dot(gradient) / 2, gradient.y(), -gradient.x(), 0;
    return u;
  };
  const auto [energy, inner] = energy_and_inner_force(plate, field);
  const double D = 1000 * 1e-3 / (12 * (1 - 0.25 * 0.25));
  const double density =
      D / 2 * ((1 - 0.25) * kappa.squaredNorm() + 0.25 * kappa.trace() * kappa.trace());
  EXPECT_NEAR(energy, 9 * density, 1e-12 * energy);
  EXPECT_LT(inner, 1e-12 * 1000 * 0.1);

  const Patch patch;
  const ShellResultants s =
      mitc4_resultants(patch.quad(4), plate, patch.field(4, field), {0.2, -0.3});
  EXPECT_NEAR(s.bending(0, 0), -D * (0.3 - 0.25 * 0.2), 1e-12 * D);
  EXPECT_NEAR(s.bending(0, 1), -D * 0.75 * 0.1, 1e-12 * D);
  EXPECT_LT(s.membrane.norm() + s.shear.norm(), 1e-12);
  // sigma_xx = -z E / (1 - nu^2) (kxx + nu kyy), and so on; on top
  const double sx = 12 * s.bending(0, 0) / 1e-3 * 0.05, sy = 12 * s.bending(1, 1) / 1e-3 * 0.05;
  const double sxy = 12 * s.bending(0, 1) / 1e-3 * 0.05;
  EXPECT_NEAR(shell_von_mises(s, 0.1, 0.05), std::sqrt(sx * sx - sx * sy + sy * sy + 3 * sxy * sxy),
              1e-10);
}

// It does not matter which corner comes first.
TEST_P(EveryMembrane, IsIsotropic) {
  const ShellQuad q = curved_quad();
  const ShellMatrix K = mitc4_stiffness(q, section(1, 0.3, 0.1));
  for (std::size_t first = 1; first < 4; ++first) {
    ShellQuad turned;
    ShellMatrix back;
    for (std::size_t a = 0; a < 4; ++a) {
      turned.x[a] = q.x[(a + first) % 4];
      turned.director[a] = q.director[(a + first) % 4];
    }
    const ShellMatrix L = mitc4_stiffness(turned, section(1, 0.3, 0.1));
    const auto block = [first](int a) { return 6 * ((a + static_cast<int>(first)) % 4); };
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        back.block<6, 6>(block(a), block(b)) = L.block<6, 6>(6 * a, 6 * b);
    EXPECT_LT((back - K).norm(), 1e-14 * K.norm()) << first;
  }
}

/// In-plane bending u = x y, v = -x^2 / 2 of one flat element.
double in_plane_bending_energy(const std::array<Vec3, 4>& x, MembraneStrain membrane) {
  ShellQuad q{x, {}};
  q.director.fill(Vec3::UnitZ());
  ShellVector u = ShellVector::Zero();
  for (std::size_t a = 0; a < 4; ++a)
    u.segment<2>(static_cast<Eigen::Index>(6 * a)) << x[a].x() * x[a].y(), -x[a].x() * x[a].x() / 2;
  return u.dot(mitc4_stiffness(q, {120, 0, 0.1, 5.0 / 6, membrane}) * u) / 2;
}

// Beam theory: E I L / 2 with I = t b^3 / 12. Displacements alone have shear, which adds
// (1 - nu) / 2 (L / b)^2 times as much.
TEST(Mitc4Assumed, InPlaneBendingOfARectangleIsThatOfABeam) {
  const std::array<Vec3, 4> x{Vec3(-2, -0.5, 0), Vec3(2, -0.5, 0), Vec3(2, 0.5, 0),
                              Vec3(-2, 0.5, 0)};
  const double exact = 120 * 0.1 / 12 * 4 / 2;
  EXPECT_NEAR(in_plane_bending_energy(x, MembraneStrain::assumed), exact, 1e-12);
  EXPECT_NEAR(in_plane_bending_energy(x, MembraneStrain::displacement), exact * (1 + 16.0 / 2),
              1e-12);
}

// The element on z = k x y twists further by w = x y, its straight sides keep their lengths by
// u = -k (x, y), and normals turn by V x dN / |N| with N = (-k y, -k x, 1). What remains is the bending
// energy of a constant twist, (1 - nu) D times the area.
TEST(Mitc4Assumed, AWarpedElementTwistsWithoutStretching) {
  const double k = 0.1, t = 1e-4, D = 1.2e13 * t * t * t / 12;
  ShellQuad q;
  ShellVector u = ShellVector::Zero();
  for (std::size_t a = 0; a < 4; ++a) {
    const double x = a == 1 || a == 2 ? 1 : -1, y = a > 1 ? 1 : -1;
    q.x[a] = Vec3(x, y, k * x * y);
    const Vec3 N(-k * y, -k * x, 1), dN = (1 + k * k) * Vec3(-y, -x, 0);
    q.director[a] = N.normalized();
    u.segment<6>(static_cast<Eigen::Index>(6 * a)) << -k * x, -k * y, x * y,
        q.director[a].cross(dN) / N.norm();
  }
  const auto energy = [&](MembraneStrain membrane) {
    return u.dot(mitc4_stiffness(q, {1.2e13, 0, t, 5.0 / 6, membrane}) * u) / 2;
  };
  EXPECT_GT(energy(MembraneStrain::displacement), 1000 * D * 4);
  EXPECT_NEAR(energy(MembraneStrain::assumed), D * 4, 0.1 * D * 4);
}

// gamma = w,x + theta_y: a constant transverse shear carries the factor.
TEST(Mitc4, ConstantShearCarriesTheFactor) {
  ShellQuad q;
  q.x = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)};
  q.director.fill(Vec3::UnitZ());
  ShellVector u = ShellVector::Zero();
  for (int a = 0; a < 4; ++a)
    u(6 * a + 2) = 0.01 * q.x[static_cast<std::size_t>(a)].x();
  for (const double factor : {5.0 / 6.0, 1.0}) {
    const ShellSection section{260, 0.3, 0.1, factor};
    const double energy = u.dot(mitc4_stiffness(q, section) * u) / 2;
    EXPECT_NEAR(energy, 0.5 * factor * 100 * 0.1 * 1e-4 * 2, 1e-14);
    EXPECT_NEAR(mitc4_resultants(q, section, u, {0, 0}).shear.x(), factor * 100 * 0.1 * 0.01,
                1e-14);
  }
}

TEST(Mitc4, LoadsAreConsistent) {
  const ShellQuad q = Patch().quad(0);
  double exact = 0;  // shoelace formula
  for (std::size_t a = 0; a < 4; ++a)
    exact += q.x[a].cross(q.x[(a + 1) % 4]).z() / 2;
  const ShellVector f =
      shell_area_load(q, [](const Vec3&, const Vec3& n) -> Vec3 { return 2 * n; });
  double total = 0;
  for (int a = 0; a < 4; ++a)
    total += f(6 * a + 2);
  EXPECT_NEAR(total, 2 * exact, 1e-14);
  // p = x along the lower side, of length 3: nodes take 3 / 2 and 3
  const ShellVector g = shell_side_load(q, 0, [](const Vec3& x) { return Vec3(0, 0, x.x()); });
  EXPECT_NEAR(g(2), 1.5, 1e-14);
  EXPECT_NEAR(g(8), 3.0, 1e-14);
}

}  // namespace
}  // namespace limes
