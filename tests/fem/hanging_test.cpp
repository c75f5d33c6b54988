// Shells on meshes with hanging nodes: patch tests on flat ones, rigid motions on curved ones.

#include "limes/fem/hanging.h"

#include <gtest/gtest.h>

#include <random>

#include "limes/fem/mitc4.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

using NodeVector = Eigen::Matrix<double, 6, 1>;
using Field = std::function<NodeVector(const Vec3& x, const Vec3& director)>;

/// Random leaves are split, four times.
ForestMesh random_forest_mesh(const Mesh& control, unsigned seed) {
  Forest forest(control, find_scheme("linear"), {}, SplitUnit::faces);
  std::mt19937 random(seed);
  for (int step = 0; step < 4; ++step) {
    std::vector<FaceId> marked;
    for (const FaceId f : forest.leaves())
      if (random() % 3 == 0) marked.push_back(f);
    forest.refine(marked);
  }
  return forest_mesh(forest, Closure::hanging);
}

/// A shell on a mesh with hanging nodes. All nodes are smooth.
struct HangingShell {
  ForestMesh forest;
  std::vector<Vec3> director;
  ShellSection section{1000, 0.25, 0.2, 5.0 / 6, MembraneStrain::displacement};

  [[nodiscard]] int size() const { return 6 * forest.mesh.points.size(); }
  [[nodiscard]] SideNode node(VertexId v) const {
    return {forest.mesh.points[v], director[static_cast<std::size_t>(v.value)], true, 6 * v.value};
  }
  [[nodiscard]] VectorX values(const Field& field) const {
    VectorX u(size());
    for (int v = 0; v < size() / 6; ++v)
      u.segment<6>(6 * v) = field(node(VertexId(v)).x, node(VertexId(v)).director);
    return u;
  }
  [[nodiscard]] std::vector<ConstraintRow> constraints() const {
    std::vector<ConstraintRow> rows;
    for (const HangingVertex& h : forest.hanging) {
      const auto more = hanging_constraints(node(h.vertex), node(h.ends[0]), node(h.ends[1]));
      rows.insert(rows.end(), more.begin(), more.end());
    }
    for (int v = 0; v < size() / 6; ++v) {
      const Vec3& n = director[static_cast<std::size_t>(v)];
      rows.push_back({{6 * v + 3, n.x()}, {6 * v + 4, n.y()}, {6 * v + 5, n.z()}});
    }
    return rows;
  }
  [[nodiscard]] SparseMatrix matrix() const {
    std::vector<Triplet> entries;
    const Topology& t = forest.mesh.topology;
    for (int f = 0; f < t.num_faces(); ++f) {
      ShellQuad quad;
      const auto corners = t.face(FaceId(f));
      for (std::size_t a = 0; a < 4; ++a) {
        quad.x[a] = node(corners[a]).x;
        quad.director[a] = node(corners[a]).director;
      }
      const ShellMatrix K = mitc4_stiffness(quad, section);
      for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 24; ++j)
          entries.emplace_back(6 * corners[static_cast<std::size_t>(i / 6)].value + i % 6,
                               6 * corners[static_cast<std::size_t>(j / 6)].value + j % 6, K(i, j));
    }
    SparseMatrix K(size(), size());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
  }
};

double worst_violation(const std::vector<ConstraintRow>& rows, const VectorX& u) {
  double worst = 0;
  for (const ConstraintRow& row : rows) {
    double sum = 0;
    for (const auto& [unknown, weight] : row)
      sum += weight * u(unknown);
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}

/// The square [0, 3]^2 of five distorted quads.
Mesh flat_patch() {
  Mesh mesh;
  std::vector<VertexId> corners;
  for (const int v : {0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7, 4, 5, 6, 7})
    corners.emplace_back(v);
  mesh.topology = Topology(8, 4, std::move(corners));
  mesh.points = IdArray<VertexId, Vec3>(std::vector<Vec3>{
      Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 3, 0), Vec3(0, 3, 0), Vec3(0.8, 1.1, 0),
      Vec3(2.1, 0.7, 0), Vec3(1.9, 2.2, 0), Vec3(1.2, 1.8, 0)});
  return mesh;
}

HangingShell flat_shell(unsigned seed, MembraneStrain membrane) {
  HangingShell shell{random_forest_mesh(flat_patch(), seed), {}};
  shell.director.assign(static_cast<std::size_t>(shell.size() / 6), Vec3::UnitZ());
  shell.section.membrane = membrane;
  return shell;
}

bool on_border(const Vec3& x) {
  return x.head<2>().minCoeff() < 1e-12 || x.head<2>().maxCoeff() > 3 - 1e-12;
}

/// The field fulfils all conditions, no free inner unknown feels a force, the energy is exact.
void expect_patch_test(const HangingShell& shell, const Field& field, double energy) {
  const std::vector<ConstraintRow> rows = shell.constraints();
  const VectorX u = shell.values(field);
  EXPECT_LT(worst_violation(rows, u), 1e-12);
  const SparseMatrix K = shell.matrix();
  const VectorX f = K * u;
  EXPECT_NEAR(u.dot(f) / 2, energy, 1e-12 * energy);
  const Elimination fix = eliminate(shell.size(), rows);
  const VectorX free_force = fix.T.transpose() * f;
  double inner = 0, outer = 0;
  for (int i = 0; i < fix.num_free(); ++i) {
    const Vec3 x = shell.node(VertexId(fix.unknown(i) / 6)).x;
    double& worst = on_border(x) ? outer : inner;
    worst = std::max(worst, std::abs(free_force(i)));
  }
  EXPECT_LT(inner, 1e-12 * K.coeffs().cwiseAbs().maxCoeff());
  EXPECT_GT(outer, 1e-4);
}

class EverySeed : public ::testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Hanging, EverySeed, ::testing::Range(1U, 9U));

const Mat2 tensor = (Mat2() << 0.3, 0.1, 0.1, -0.2).finished();

double isotropic_density(const ShellSection& s, double stiffness) {
  const double trace = tensor.trace();
  return stiffness / (1 - s.poisson * s.poisson) / 2 *
         ((1 - s.poisson) * tensor.squaredNorm() + s.poisson * trace * trace);
}

TEST_P(EverySeed, ConstantMembraneStrain) {
  for (const auto membrane : {MembraneStrain::displacement, MembraneStrain::assumed}) {
    const HangingShell shell = flat_shell(GetParam(), membrane);
    ASSERT_GT(shell.forest.hanging.size(), 10U);
    const double stiffness = shell.section.young * shell.section.thickness;
    expect_patch_test(
        shell,
        [](const Vec3& x, const Vec3&) {
          NodeVector u = NodeVector::Zero();
          u.head<2>() = tensor * x.head<2>();
          return u;
        },
        9 * isotropic_density(shell.section, stiffness));
  }
}

// w = x . kappa x / 2 with Kirchhoff's rotations (w,y, -w,x).
TEST_P(EverySeed, ConstantCurvature) {
  const HangingShell shell = flat_shell(GetParam(), MembraneStrain::displacement);
  const double stiffness = shell.section.young * std::pow(shell.section.thickness, 3) / 12;
  expect_patch_test(
      shell,
      [](const Vec3& x, const Vec3&) {
        const Vec2 gradient = tensor * x.head<2>();
        NodeVector u;
        u << 0, 0, x.head<2>().dot(gradient) / 2, gradient.y(), -gradient.x(), 0;
        return u;
      },
      9 * isotropic_density(shell.section, stiffness));
}

Field rigid_motion(int mode) {
  return [mode](const Vec3& x, const Vec3& n) {
    NodeVector u = NodeVector::Zero();
    if (mode < 3) {
      u(mode) = 1;
    } else {
      const Vec3 omega = Vec3::Unit(mode - 3);
      u.head<3>() = omega.cross(x);
      u.tail<3>() = omega - n * n.dot(omega);  // nothing about the director
    }
    return u;
  };
}

// A cube whose nodes are pushed onto an ellipsoid, hanging ones as well: they leave the middles of the sides.
TEST_P(EverySeed, RigidMotionsOfACurvedShell) {
  HangingShell shell{random_forest_mesh(shapes::cube(), GetParam()), {}};
  const Vec3 axes(3, 2, 1);
  for (int v = 0; v < shell.size() / 6; ++v) {
    Vec3& x = shell.forest.mesh.points[VertexId(v)];
    x = axes.cwiseProduct(x.normalized());
    shell.director.push_back(x.cwiseQuotient(axes.cwiseAbs2()).normalized());
  }
  ASSERT_GT(shell.forest.hanging.size(), 10U);
  const std::vector<ConstraintRow> rows = shell.constraints();
  const SparseMatrix K = shell.matrix();
  for (int mode = 0; mode < 6; ++mode) {
    const VectorX u = shell.values(rigid_motion(mode));
    EXPECT_LT(worst_violation(rows, u), 1e-12) << mode;
    EXPECT_LT((K * u).cwiseAbs().maxCoeff(), 1e-12 * K.coeffs().cwiseAbs().maxCoeff()) << mode;
  }
}

// Along a kink rotations are full vectors; a side that leaves the kink has one end there.
TEST(Hanging, RigidMotionsAtKinks) {
  const Vec3 across = Vec3(0.1, -1, 0.2).normalized(), n = Vec3(0.1, 0.3, 1).normalized();
  const SideNode a{Vec3(0, 0, 0), n, false, 0}, end{Vec3(2, 0.4, -0.1), n, false, 6};
  SideNode b = end, smooth_node{Vec3(1.1, 0.3, 0.1), across, true, 12};
  b.smooth = true;
  SideNode kink_node = smooth_node;
  kink_node.smooth = false;
  for (const auto& [node, other] :
       {std::pair(kink_node, end), std::pair(kink_node, b), std::pair(smooth_node, b)})
    for (int mode = 0; mode < 6; ++mode) {
      VectorX u(18);
      for (const SideNode& at : {a, other, node}) {
        u.segment<6>(at.first) = rigid_motion(mode)(at.x, at.director);
        if (!at.smooth && mode >= 3) u.segment<3>(at.first + 3) = Vec3::Unit(mode - 3);
      }
      EXPECT_LT(worst_violation(hanging_constraints(node, a, other), u), 1e-14) << mode;
    }
}

}  // namespace
}  // namespace limes
