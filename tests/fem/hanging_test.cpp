// Shells on meshes with hanging nodes: patch tests on flat ones, rigid motions on curved ones.

#include "limes/fem/hanging.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "limes/fem/mitc4.h"
#include "limes/mesh/shapes.h"
#include "limes/solve/linear.h"
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
  [[nodiscard]] ShellQuad quad(FaceId f) const {
    ShellQuad out;
    for (std::size_t a = 0; a < 4; ++a) {
      const SideNode corner = node(forest.mesh.topology.face(f)[a]);
      out.x[a] = corner.x;
      out.director[a] = corner.director;
    }
    return out;
  }
  [[nodiscard]] SparseMatrix matrix() const {
    std::vector<Triplet> entries;
    const Topology& t = forest.mesh.topology;
    for (int f = 0; f < t.num_faces(); ++f) {
      const auto corners = t.face(FaceId(f));
      const ShellMatrix K = mitc4_stiffness(quad(FaceId(f)), section);
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

/// A quarter of the Scordelis-Lo roof from 8 x 8 elements, split once more where the angle or y, in the
/// chart, say so.
HangingShell roof(const std::function<bool(const Vec3& chart)>& split) {
  const double edge = std::numbers::pi * 2 / 9, length = 25, radius = 25;
  Mesh chart;
  chart.topology = Topology(4, 4, {VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  chart.points = IdArray<VertexId, Vec3>(std::vector<Vec3>{
      Vec3(0, 0, 0), Vec3(edge, 0, 0), Vec3(edge, length, 0), Vec3(0, length, 0)});
  Forest forest(chart, find_scheme("linear"), {}, SplitUnit::faces);
  for (int level = 0; level < 3; ++level)
    forest.refine(forest.leaves());
  std::vector<FaceId> marked;
  for (const FaceId f : forest.leaves())
    if (split(forest.nodes().position(forest.corners(f)[0]))) marked.push_back(f);
  forest.refine(marked);
  HangingShell shell{forest_mesh(forest, Closure::hanging), {}};
  shell.section = {4.32e8, 0, 0.25, 5.0 / 6, MembraneStrain::displacement};
  for (int v = 0; v < shell.size() / 6; ++v) {
    Vec3& x = shell.forest.mesh.points[VertexId(v)];
    shell.director.emplace_back(std::sin(x.x()), 0, std::cos(x.x()));
    x = Vec3(0, x.y(), 0) + radius * shell.director.back();
  }
  return shell;
}

/// Diaphragm at y = 0, which holds the directors in its plane too, symmetry at y = 25 and x = 0.
std::vector<ConstraintRow> roof_supports(const HangingShell& shell) {
  std::vector<ConstraintRow> rows;
  const auto hold = [&](int v, std::initializer_list<int> unknowns) {
    for (const int i : unknowns)
      rows.push_back({{6 * v + i, 1.0}});
  };
  for (int v = 0; v < shell.size() / 6; ++v) {
    const Vec3& x = shell.forest.mesh.points[VertexId(v)];
    if (x.y() < 1e-9) hold(v, {0, 2, 4});
    if (x.y() > 25 - 1e-9) hold(v, {1, 3, 5});
    if (x.x() < 1e-9) hold(v, {0, 4, 5});
  }
  return rows;
}

double roof_energy(const HangingShell& shell) {
  VectorX f = VectorX::Zero(shell.size());
  const Topology& t = shell.forest.mesh.topology;
  for (int face = 0; face < t.num_faces(); ++face) {
    const ShellVector load = shell_area_load(
        shell.quad(FaceId(face)), [](const Vec3&, const Vec3&) { return Vec3(0, 0, -90); });
    for (int a = 0; a < 4; ++a)
      f.segment<6>(6 * t.face(FaceId(face))[static_cast<std::size_t>(a)].value) +=
          load.segment<6>(6 * a);
  }
  std::vector<ConstraintRow> rows = shell.constraints();
  const std::vector<ConstraintRow> supports = roof_supports(shell);
  rows.insert(rows.end(), supports.begin(), supports.end());
  const SparseMatrix T = eliminate(shell.size(), rows).T;
  const VectorX load = T.transpose() * f;
  const MatrixX u = DirectSolver(SparseMatrix(T.transpose() * shell.matrix() * T)).solve(load);
  return load.dot(u.col(0)) / 2;
}

// Against the limit of Reissner-Mindlin theory: finer where the solution varies is nearly as good as
// finer everywhere.
TEST(Hanging, RoofRefinedAtItsBorders) {
  const double limit = 1208.890028;
  const auto error = [&](const std::function<bool(const Vec3&)>& split) {
    return 1 - roof_energy(roof(split)) / limit;
  };
  const double coarse = error([](const Vec3&) { return false; });
  const double fine = error([](const Vec3&) { return true; });
  const double local = error([](const Vec3& chart) { return chart.x() > 0.3; });
  EXPECT_NEAR(coarse, 0.0284, 1e-4);  // as of data/roof.toml, docs/theory/mitc4.md
  EXPECT_NEAR(fine, 0.0087, 1e-4);
  EXPECT_GT(local, fine);
  EXPECT_LT(local, fine + 0.1 * (coarse - fine));
}

}  // namespace
}  // namespace limes
