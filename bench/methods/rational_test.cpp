#include "rational.h"

#include <gtest/gtest.h>

#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "limit/local_refinement.h"

namespace bench {
namespace {

using namespace limes;
using limes::test::limit_by_refinement;
using limes::test::make_model;
using limes::test::Model;

struct Case {
  std::string name;
  Mesh mesh;
  int face = 0;
  BoundaryRule boundary = BoundaryRule::edges;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

std::vector<Case> cases() {
  std::vector<Case> out{
      {"Regular", shapes::torus(6, 5)},
      {"Cube", shapes::cube()},
      {"Valence5", shapes::disk(5, 3)},
      {"Valence12", shapes::disk(12, 3)},
      {"Boundary", shapes::grid(4, 4), 1},
      {"Corner", shapes::grid(4, 4), 0, BoundaryRule::edges_and_corners},
      {"BoundaryVertexOfFourFaces", shapes::half_disk(4, 3)},
      {"Triangles", shapes::tetrahedron()},
      {"Pentagon", shapes::polygon(5)},
  };
  Mesh creased = shapes::torus(6, 5);
  const auto face = creased.topology.face(FaceId(0));
  creased.tags.creases = {{face[0], face[1], 2.3F}, {face[1], face[2], 10.0F}};
  out.push_back({"SharpAndSemiSharpCreases", creased});
  return out;
}

class AtRationals : public testing::TestWithParam<Case> {};

TEST_P(AtRationals, WeightsGiveTheLimitOfPlainRefinement) {
  const Scheme& scheme = find_scheme("catmull-clark");
  Mesh mesh = GetParam().mesh;
  limes::test::perturb(mesh, 0.1);
  const Model model = make_model(mesh, GetParam().boundary);
  const Adjacency adjacency(model.topology);
  const Sharpness sharpness(adjacency, model.features);
  const FaceId face(GetParam().face);
  const Ring ring = gather_ring(adjacency, model.features, sharpness, scheme, face);
  const Points controls = controls_of(ring, model.points);
  RationalEvaluator evaluator(scheme);
  for (const RationalPoint& p : {RationalPoint{0, 0, 1},
                                 {1, 1, 1},
                                 {1, 0, 2},
                                 {1, 3, 4},
                                 {1, 2, 3},
                                 {2, 4, 5},
                                 {5, 1, 7},
                                 {0, 3, 7},
                                 {5, 9, 12},
                                 {17, 4, 31},
                                 {100, 3, 101},
                                 {1, 3, 1 << 20}}) {
    const Vec2 uv = Vec2(static_cast<double>(p.u), static_cast<double>(p.v)) /
                    static_cast<double>(p.denominator);
    const VectorX weights = evaluator.weights(ring, 0, p);
    EXPECT_NEAR(weights.sum(), 1, 1e-14);
    // At a vertex control points tend to the limit like 0.66^k at worst, elsewhere like 4^-k.
    const bool near_vertex = uv.maxCoeff() < 0.01 || p.denominator == 1;
    const Vec3 truth = limit_by_refinement(model, scheme, face, 0, uv, near_vertex ? 76 : 27);
    EXPECT_LE((controls.transpose() * weights - truth).norm(), 1e-12)
        << p.u << " " << p.v << " / " << p.denominator;
  }
}

INSTANTIATE_TEST_SUITE_P(Features, AtRationals, testing::ValuesIn(cases()),
                         [](const auto& c) { return c.param.name; });

/// The doubling map's period at p / q is the order of 2 modulo q; the turn of the children's
/// parameters can shorten it by half or a quarter where it maps the point onto itself.
TEST(Rational, PeriodDividesTheOrderOfTwo) {
  const Scheme& scheme = find_scheme("catmull-clark");
  const Model model = make_model(shapes::torus(6, 5));
  const Adjacency adjacency(model.topology);
  const Ring ring = gather_ring(adjacency, model.features, Sharpness(adjacency, model.features),
                                scheme, FaceId(0));
  RationalEvaluator evaluator(scheme);
  for (const auto& [q, order] : {std::pair(3, 2), {5, 4}, {7, 3}, {11, 10}, {31, 5}}) {
    (void)evaluator.weights(ring, 0, {1, 2, q});
    EXPECT_LE(evaluator.last_period(), 4 * order) << q;
    EXPECT_EQ(4 * order % evaluator.last_period(), 0) << q;
  }
}

/// A scheme whose limit is known without any refinement.
TEST(Rational, LinearSchemeGivesBilinearWeights) {
  const Scheme& scheme = find_scheme("linear");
  const Model model = make_model(shapes::torus(6, 5));
  const Adjacency adjacency(model.topology);
  const Ring ring = gather_ring(adjacency, model.features, Sharpness(adjacency, model.features),
                                scheme, FaceId(0));
  RationalEvaluator evaluator(scheme);
  const VectorX weights = evaluator.weights(ring, 0, {2, 3, 7});
  ASSERT_EQ(weights.size(), 4);
  const double u = 2.0 / 7, v = 3.0 / 7;
  EXPECT_NEAR(weights(0), (1 - u) * (1 - v), 1e-15);
  EXPECT_NEAR(weights(1), u * (1 - v), 1e-15);
  EXPECT_NEAR(weights(2), u * v, 1e-15);
  EXPECT_NEAR(weights(3), (1 - u) * v, 1e-15);
}

}  // namespace
}  // namespace bench
