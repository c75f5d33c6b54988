#include "boundary_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "differences.h"
#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "limit/local_refinement.h"

namespace bench {
namespace {

using namespace limes;
using limes::test::limit_by_refinement;
using limes::test::Model;

/// An open grid of 4 x 4 faces with bumps, its corners sharp.
Model bumpy_grid() {
  Mesh mesh = shapes::grid(4, 4);
  limes::test::perturb(mesh, 0.3);
  return limes::test::make_model(mesh, BoundaryRule::edges_and_corners);
}

constexpr int columns = 5;  // vertices in a line of the grid

/// Controls of the face at column `i` of the boundary y = 0; i = 0 is the corner face.
Points controls_at(const Model& model, int i) {
  const int first = i == 0 ? 0 : i - 1;
  const int width = i == 0 ? 3 : 4;
  Points out(3 * width, 3);
  for (int line = 0; line < 3; ++line)
    for (int k = 0; k < width; ++k)
      out.row(width * line + k) =
          model.points[static_cast<std::size_t>(columns * line + first + k)];
  return out;
}

class BoundaryFace : public testing::TestWithParam<BoundaryTree::Face> {
 protected:
  [[nodiscard]] int face() const { return GetParam() == BoundaryTree::Face::corner ? 0 : 1; }
  [[nodiscard]] Vec3 truth(const Vec2& uv, int levels) const {
    return limit_by_refinement(model_, find_scheme("catmull-clark"), FaceId(face()), 0, uv, levels);
  }
  Model model_ = bumpy_grid();
  Points controls_ = controls_at(model_, face());
};

TEST_P(BoundaryFace, TreeEqualsPlainRefinement) {
  const BoundaryTree tree(GetParam());
  ASSERT_EQ(controls_.rows(), tree.num_controls());
  std::mt19937 random(2013);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec2> places{{1, 1}, {0.5, 0.5}, {0.25, 1e-4}, {0.3, 1e-6}};
  for (int i = 0; i < 20; ++i)
    places.emplace_back(unit(random), unit(random));
  for (const Vec2& uv : places)
    EXPECT_LE((tree.evaluate(controls_, uv).x - truth(uv, 27)).norm(), 1e-12) << uv.transpose();
}

TEST_P(BoundaryFace, DerivativesEqualDifferencesOfPlainRefinement) {
  const BoundaryTree tree(GetParam());
  const double h = 1.0 / 16;
  for (const Vec2& uv : {Vec2(0.5, 0.5), Vec2(0.2, 0.7), Vec2(0.8, 0.15)}) {
    const auto expected = differences([&](const Vec2& at) { return truth(at, 28); }, uv, h);
    const SurfaceJet jet = tree.evaluate(controls_, uv);
    EXPECT_LE((jet.xu - expected[0]).norm(), 1e-13 / h);
    EXPECT_LE((jet.xv - expected[1]).norm(), 1e-13 / h);
    EXPECT_LE((jet.xuu - expected[2]).norm(), 1e-12 / (h * h));
    EXPECT_LE((jet.xuv - expected[3]).norm(), 1e-12 / (h * h));
    EXPECT_LE((jet.xvv - expected[4]).norm(), 1e-12 / (h * h));
  }
}

TEST_P(BoundaryFace, PhantomsMakeItOnePatch) {
  const Points patch = phantom_matrix(GetParam()) * controls_;
  for (const Vec2& uv : {Vec2(0, 0), Vec2(0.3, 0), Vec2(0.6, 0.7), Vec2(1, 0.2)}) {
    const SurfaceJet jet = jet_of(bicubic_weights(uv, Mat2::Identity()).transpose() * patch);
    EXPECT_LE((jet.x - truth(uv, 27)).norm(), 1e-12) << uv.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Faces, BoundaryFace,
                         testing::Values(BoundaryTree::Face::boundary, BoundaryTree::Face::corner),
                         [](const auto& f) {
                           return f.param == BoundaryTree::Face::corner ? "Corner" : "Boundary";
                         });

/// E_L and E_R against the scheme: controls of the two children at the boundary.
TEST(BoundaryTree, StepsAreTheSchemesOwn) {
  const Model model = bumpy_grid();
  const Adjacency adjacency(model.topology);
  const RefinementStep step(adjacency, model.features, find_scheme("catmull-clark"));
  std::vector<Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
  step.apply(model.points, fine);
  // The boundary vertices 1 and 2 and the edges between: child vertices keep the parent's numbers,
  // edge points follow by edge, so a line of the finer boundary is found by position in the plane of
  // an unperturbed grid.
  const Mesh flat = shapes::grid(4, 4);
  std::vector<Vec3> where(fine.size());
  step.apply(flat.points.span(), where);
  const auto controls = [&](double x0) {
    Points out(12, 3);
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 4; ++i) {
        const Vec3 at(x0 + 0.5 * i, 0.5 * j, 0);
        for (std::size_t v = 0; v < fine.size(); ++v)
          if ((where[v] - at).norm() < 1e-9) out.row(4 * j + i) = fine[v];
      }
    }
    return out;
  };
  const Points coarse = controls_at(model, 1);
  EXPECT_LE((BoundaryTree::left_step() * coarse - controls(0.5)).norm(), 1e-14);
  EXPECT_LE((BoundaryTree::right_step() * coarse - controls(1.0)).norm(), 1e-14);
}

/// [barendrecht_2013] Fig. 17: half of what is left of a boundary face is regular at each level.
TEST(BoundaryTree, DepthGrowsTowardsTheBoundary) {
  const BoundaryTree tree(BoundaryTree::Face::boundary);
  EXPECT_EQ(tree.depth({0.3, 0.6}), 1);
  EXPECT_EQ(tree.depth({0.3, 0.3}), 2);
  EXPECT_EQ(tree.depth({0.9, 0.3 / 1024}), 12);
  EXPECT_THROW((void)tree.depth({0.3, 0}), InputError);
}

/// The corner phantom as printed does not even give back a plane grid.
TEST(BoundaryTree, PrintedCornerFormulaIsWrong) {
  const Model flat = limes::test::make_model(shapes::grid(4, 4), BoundaryRule::edges_and_corners);
  const Points patch = phantom_matrix(BoundaryTree::Face::corner) * controls_at(flat, 0);
  const auto P = [&](int k) { return Vec3(patch.row(k - 1)); };  // P1 to P16, four a line
  EXPECT_LE((P(1) - Vec3(-1, -1, 0)).norm(), 1e-15);
  const Vec3 printed = 4 * P(7) + 4 * P(10) + P(11) - 8 * P(6);
  EXPECT_LE((printed - Vec3(5, 5, 0)).norm(), 1e-15);
}

}  // namespace
}  // namespace bench
