#include "stam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "differences.h"
#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "limit/local_refinement.h"

namespace bench {
namespace {

using namespace limes;
using limes::test::limit_by_refinement;
using limes::test::make_model;
using limes::test::Model;

const Scheme& catmull_clark() {
  return find_scheme("catmull-clark");
}

Ring ring_of(const Model& model, FaceId f) {
  const Adjacency adjacency(model.topology);
  return gather_ring(adjacency, model.features, Sharpness(adjacency, model.features),
                     catmull_clark(), f);
}

Model bumpy(Mesh mesh) {
  limes::test::perturb(mesh, 0.1);
  return make_model(mesh);
}

class StamAtValence : public testing::TestWithParam<int> {};

TEST_P(StamAtValence, PositionEqualsPlainRefinement) {
  const Model model = bumpy(shapes::disk(GetParam(), 3));
  const Ring ring = ring_of(model, FaceId(0));
  const StamTable stam(ring, catmull_clark());
  const Points projected = stam.project(controls_of(ring, model.points));
  std::mt19937 random(1998);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec2> places{{0, 0}, {1, 1}, {1, 0}, {0, 1}, {0.5, 0.25}, {1e-3, 2e-3}};
  for (int i = 0; i < 12; ++i)
    places.emplace_back(unit(random), unit(random));
  for (const Vec2& uv : places) {
    const int levels = uv.maxCoeff() < 0.01 ? 70 : 26;
    const Vec3 truth = limit_by_refinement(model, catmull_clark(), FaceId(0), 0, uv, levels);
    EXPECT_LE((stam.evaluate(projected, uv).x - truth).norm(), 1e-12) << uv.transpose();
  }
}

TEST_P(StamAtValence, DerivativesEqualDifferencesOfPlainRefinement) {
  const Model model = bumpy(shapes::disk(GetParam(), 3));
  const Ring ring = ring_of(model, FaceId(0));
  const StamTable stam(ring, catmull_clark());
  const Points projected = stam.project(controls_of(ring, model.points));
  const auto truth = [&](const Vec2& at) {
    return limit_by_refinement(model, catmull_clark(), FaceId(0), 0, at, 30);
  };
  for (const double width : {0.5, 0.125}) {
    for (const Vec2& corner : {Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
      const Vec2 uv = width * (corner + Vec2(0.4, 0.6));
      const double h = width / 8;
      const auto expected = differences(truth, uv, h);
      const SurfaceJet jet = stam.evaluate(projected, uv);
      EXPECT_LE((jet.xu - expected[0]).norm(), 1e-13 / h);
      EXPECT_LE((jet.xv - expected[1]).norm(), 1e-13 / h);
      EXPECT_LE((jet.xuu - expected[2]).norm(), 1e-12 / (h * h));
      EXPECT_LE((jet.xuv - expected[3]).norm(), 1e-12 / (h * h));
      EXPECT_LE((jet.xvv - expected[4]).norm(), 1e-12 / (h * h));
    }
  }
}

/// The closed form of the subdominant eigenvalue, [stam_1998] appendix A.
TEST_P(StamAtValence, SubdominantEigenvalueIsThePrintedOne) {
  const int n = GetParam();
  const Model model = bumpy(shapes::disk(n, 3));
  const StamTable stam(ring_of(model, FaceId(0)), catmull_clark());
  const double c = std::cos(2 * std::acos(-1.0) / n);
  const double lambda = (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16;
  EXPECT_NEAR(stam.eigen().values(0), 1, 1e-13);
  EXPECT_NEAR(stam.eigen().values(1), lambda, 1e-13);
  EXPECT_NEAR(stam.eigen().values(2), lambda, 1e-13);
  EXPECT_LT(stam.eigen().values(3), lambda - 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Valences, StamAtValence, testing::Values(3, 4, 5, 6, 7, 8, 12, 20, 32));

TEST(Stam, RefusesJordanBlocksAtTheBoundary) {
  // Four faces at a boundary vertex: 1/2 is twice an eigenvalue along and across, with one mode
  // feeding the other.
  const Model model = bumpy(shapes::half_disk(4, 3));
  try {
    const StamTable stam(ring_of(model, FaceId(0)), catmull_clark());
    FAIL() << "no defect found";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no eigenbasis"), std::string::npos) << error.what();
  }
}

TEST(Stam, RefusesTwoExtraordinaryVertices) {
  Mesh mesh = shapes::cube();
  EXPECT_THROW(StamTable(ring_of(make_model(mesh), FaceId(0)), catmull_clark()), InputError);
}

TEST(Eigenbasis, FindsAJordanBlock) {
  MatrixX J(4, 4);
  J << 0.5, 1, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1;
  MatrixX T(4, 4);
  T << 1, 2, 0, 1, 0, 1, 3, 0, 1, 0, 1, 0, 0, 1, 0, 2;
  const Eigenbasis found = eigenbasis(T * J * T.inverse());
  ASSERT_EQ(found.defects.size(), 1U);
  EXPECT_NEAR(found.defects[0].eigenvalue, 0.5, 1e-9);
  EXPECT_EQ(found.defects[0].multiplicity, 3);
  EXPECT_EQ(found.defects[0].num_vectors, 2);
}

TEST(Eigenbasis, RefusesARotation) {
  MatrixX R(2, 2);
  R << 0, -1, 1, 0;
  EXPECT_THROW((void)eigenbasis(R), InputError);
}

}  // namespace
}  // namespace bench
