#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/quasi_smoothing.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/golden48.h"
#include "subdiv/meshes48.h"
#include "subdiv/sectors.h"

// Plain 4-8 subdivision. The golden files hold the weights as somebody remembered them; what makes them
// right is tested apart: the mask, the spectrum of a C4 box spline, the constant number of irregular
// vertices.

namespace limes {
namespace {

const Scheme& scheme() {
  return find_scheme("four-eight");
}

Mesh after(const Mesh& mesh, int levels) {
  return refine(mesh, scheme(), {.levels = levels});
}

void expect_near(std::span<const Vec3> points, std::span<const Vec3> expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_LE((points[v] - expected[v]).norm(), 1e-12) << "vertex " << v;
}

TEST(FourEight, AgreesWithGoldenData) {
  const auto files = golden48::read("plain48_vz_");
  ASSERT_EQ(files.size(), 4U);
  for (const golden48::File& file : files)
    for (const auto& [steps, expected] : file.after) {
      SCOPED_TRACE(file.name + " after " + std::to_string(steps));
      const Mesh fine = after(file.input.mesh, steps);
      EXPECT_TRUE(std::ranges::equal(fine.topology.corners(), expected.mesh.topology.corners()));
      expect_near(fine.points.span(), expected.mesh.points.span());
    }
}

/// The smoothing of quasi 4-8 on the pattern of plain 4-8.
TEST(FourEight, QuasiSmoothingOnItsPatternAgreesWithGoldenData) {
  const auto files = golden48::read("plain48_quasi_");
  ASSERT_EQ(files.size(), 4U);
  for (const golden48::File& file : files) {
    SCOPED_TRACE(file.name);
    Topology topology = file.after.at(0).second.mesh.topology;
    std::vector<Vec3> points = file.after.at(0).second.mesh.points.vector();
    ASSERT_EQ(file.after.at(0).first, 1);
    for (int step = 2; step <= 4; ++step) {
      const Adjacency parent(topology);
      Bisection split = bisect(parent, newest_vertex_edges(parent), FirstCorner::newest);
      std::vector<Vec3> fine(static_cast<std::size_t>(split.child.num_vertices()));
      quasi_smoothing(parent, split, {}, {.boundary = QuasiBoundary::curve}, points, fine);
      topology = std::move(split.child);
      points = std::move(fine);
      for (const auto& [steps, expected] : file.after) {
        if (steps != step) continue;
        EXPECT_TRUE(std::ranges::equal(topology.corners(), expected.mesh.topology.corners()));
        expect_near(points, expected.mesh.points.span());
      }
    }
  }
}

TEST(FourEight, FacesDoubleAndIrregularVerticesStay) {
  struct Row {
    Mesh mesh;
    int irregular;
  };
  for (const auto& [mesh, irregular] :
       {Row{shapes::icosahedron(), 32}, Row{shapes::torus(6, 4), 0}, Row{shapes::cube(), 8}}) {
    int faces = mesh.topology.num_corners();
    for (int level = 1; level <= 7; ++level, faces *= 2) {
      const Mesh fine = after(mesh, level);
      EXPECT_EQ(fine.topology.num_faces(), faces);
      EXPECT_EQ(num_irregular(fine.topology), irregular);
    }
  }
}

std::vector<double> spectrum(int n) {
  const Sectors pattern(n, 5);
  const auto step = [&](const Topology& parent, int level, const std::vector<Vec3>& coarse) {
    const Adjacency adjacency(parent);
    Features features;
    features.level = level;
    const RefinementStep refinement(adjacency, features, scheme());
    std::vector<Vec3> fine(static_cast<std::size_t>(refinement.num_child_vertices()));
    refinement.apply(coarse, fine);
    return fine;
  };
  return eigenvalues(pattern.matrix(3, [&](const std::vector<Vec3>& x) {
    return step(pattern.first().child, 2, step(pattern.coarse(), 1, x));
  }));
}

TEST(FourEight, SubdominantEigenvalues) {
  const std::vector<std::pair<int, double>> expected{
      {3, 0.408311432}, {4, 0.5},         {5, 0.551323077},  {6, 0.581868401},  {7, 0.601250190},
      {8, 0.614231515}, {9, 0.623318260}, {10, 0.629912550}, {11, 0.634842886}, {12, 0.638622250}};
  for (const auto& [n, lambda] : expected) {
    SCOPED_TRACE(n);
    const auto values = spectrum(n);
    EXPECT_NEAR(values[0], 1, 1e-12);
    EXPECT_NEAR(values[1], lambda, 1e-8);
    EXPECT_NEAR(values[2], lambda, 1e-8);
    EXPECT_LT(values[3], lambda - 0.05);
  }
}

/// The four-directional box spline of class C4 reproduces polynomials up to degree 5: two steps have
/// 2^-k as eigenvalue, k + 1 times.
TEST(FourEight, RegularSpectrumIsThatOfTheC4BoxSpline) {
  const auto values = spectrum(4);
  std::size_t i = 0;
  for (int degree = 0; degree <= 5; ++degree)
    for (int k = 0; k <= degree; ++k, ++i)
      EXPECT_NEAR(values[i], std::pow(0.5, degree), 1e-4) << i;
}

/// One vertex spreads with the mask (1 2 1) x (1 2 1) / 8.
TEST(FourEight, RegularMask) {
  const Topology grid = centre_triangles(shapes::torus(6, 6)).topology;
  const Adjacency adjacency(grid);
  Features features;
  features.level = 1;
  const SparseMatrix S = RefinementStep(adjacency, features, scheme()).matrix();
  for (const int column : {7, 40}) {
    std::vector<double> weights;
    for (int row = 0; row < S.rows(); ++row)
      if (S.coeff(row, column) != 0) weights.push_back(S.coeff(row, column));
    std::sort(weights.begin(), weights.end());
    EXPECT_EQ(weights,
              (std::vector<double>{0.125, 0.125, 0.125, 0.125, 0.25, 0.25, 0.25, 0.25, 0.5}));
  }
}

/// Creases lose their sharpness when they are split, every second step.
TEST(FourEight, SharpnessDecaysEverySecondStep) {
  Mesh mesh = shapes::grid(4, 4);
  mesh.points[VertexId(12)].z() = 1;
  const auto with_crease = [&](float sharpness, int levels) {
    Mesh tagged = mesh;
    for (int i = 0; i < 4; ++i)
      tagged.tags.creases.push_back({VertexId(2 + 5 * i), VertexId(7 + 5 * i), sharpness});
    return after(tagged, levels);
  };
  for (int levels = 1; levels <= 5; ++levels) {
    SCOPED_TRACE(levels);
    const Mesh two = with_crease(2, levels), sharp = with_crease(10, levels);
    EXPECT_EQ(sharp.tags.creases.size(), 4U << levels / 2);
    EXPECT_EQ(two.tags.creases.size(), levels < 4 ? sharp.tags.creases.size() : 0);
    if (!two.tags.creases.empty()) {
      EXPECT_EQ(two.tags.creases[0].sharpness, levels < 2 ? 2 : 1);
    }
    EXPECT_EQ(two.points == sharp.points, levels <= 4);
  }
}

}  // namespace
}  // namespace limes
