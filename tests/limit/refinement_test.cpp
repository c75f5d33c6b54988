#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/limit_surface.h"
#include "limes/subdiv/schemes.h"
#include "limit/local_refinement.h"
#include "limit/zoo.h"

// Limit positions against plain refinement, for every kind of feature.

namespace limes::test {
namespace {

class LimitOf : public testing::TestWithParam<Shape> {};

/// Corners, borders, points close to corner 0 and random ones.
std::vector<Vec2> sample_points(std::mt19937& random, bool triangle) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {0.3, 0}, {1, 0.7}};
  if (triangle) points = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0.3, 0}, {0.3, 0.7}};
  for (const double scale : {1.0, 1.0, 1.0, 1.0, 0.1, 1e-3, 1e-5}) {
    Vec2 uv(unit(random), unit(random));
    if (triangle && uv.sum() > 1) uv = Vec2(1, 1) - uv;
    points.emplace_back(scale * uv);
  }
  return points;
}

void expect_equals_deep_refinement(const Model& model, const Scheme& scheme) {
  const LimitBasis basis(model.topology, model.features, scheme);
  const LimitSurface surface(basis, model.points);
  std::mt19937 random(1998);
  // Close to a vertex of high valence the control mesh comes near the limit like 0.655^levels only,
  // elsewhere like 4^-levels.
  const auto levels = [](const Vec2& uv) {
    const bool corner = (uv.x() < 1e-2 || uv.x() == 1) && (uv.y() < 1e-2 || uv.y() == 1);
    return corner ? 76 : 26;
  };
  const int num_faces = std::min(6, model.topology.num_faces());
  for (int f = 0; f < num_faces; ++f) {
    for (const Vec2& uv : sample_points(random, basis.on_triangles())) {
      const FaceId face(f);
      const int corner =
          static_cast<int>(random() % static_cast<unsigned>(basis.num_quadrants(face)));
      const Vec3 expected = limit_by_refinement(model, scheme, face, corner, uv, levels(uv));
      EXPECT_LE((surface.position(face, corner, uv) - expected).norm(), 1e-12)
          << "face " << f << " corner " << corner << " at " << uv.transpose();
    }
  }
}

TEST_P(LimitOf, EqualsDeepRefinement) {
  expect_equals_deep_refinement(make_model(GetParam().mesh, GetParam().boundary),
                                find_scheme(GetParam().scheme));
}

/// One point at a time and in bulk.
void expect_tangents_of_deep_refinement(const Model& model) {
  const Scheme& scheme = find_scheme("catmull-clark");
  const LimitBasis basis(model.topology, model.features, scheme);
  const LimitSurface surface(basis, model.points);
  const BulkEvaluator bulk(basis, model.points);
  std::mt19937 random(2001);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int compared = 0;
  for (int f = 0; f < std::min(6, model.topology.num_faces()); ++f) {
    for (const double scale : {1.0, 1.0, 0.1, 1e-3, 1e-5}) {
      const FaceId face(f);
      const Vec2 uv(scale * unit(random), scale * unit(random));
      const int corner =
          static_cast<int>(random() % static_cast<unsigned>(basis.num_quadrants(face)));
      const auto expected = tangents_by_refinement(model, scheme, face, corner, uv, 20);
      if (!expected) continue;  // within 2^-20 of a boundary or crease
      ++compared;
      const auto first = surface.evaluate(face, corner, uv).first.value();
      SurfaceJet jet;
      bulk.evaluate({face, corner, uv}, 1, jet);
      // Of the model's size, which is about one, or of the derivative where that is larger.
      const double bound = 1e-12 * std::max({1.0, (*expected)[0].norm(), (*expected)[1].norm()});
      EXPECT_LE((first.xu - (*expected)[0]).norm(), bound);
      EXPECT_LE((first.xv - (*expected)[1]).norm(), bound);
      EXPECT_LE((jet.xu - (*expected)[0]).norm(), bound);
      EXPECT_LE((jet.xv - (*expected)[1]).norm(), bound);
    }
  }
  EXPECT_GE(compared, 3);
}

class CatmullClarkLimitOf : public LimitOf {};
TEST_P(CatmullClarkLimitOf, HasTheTangentsOfDeepRefinement) {
  expect_tangents_of_deep_refinement(make_model(GetParam().mesh, GetParam().boundary));
}

/// Those with a smooth extraordinary vertex, or a dart.
bool has_other_weights(const Shape& shape) {
  for (const char* name : {"interior3", "interior5", "interior8", "dart5_4", "cube", "icosahedron",
                           "mixed_polygons", "random_cube0", "random_icosahedron0"})
    if (shape.name == name) return true;
  return false;
}

TEST(LimitWithOtherWeights, EqualsDeepRefinement) {
  int compared = 0;
  for (const Shape& shape : limit_shapes()) {
    if (!has_other_weights(shape)) continue;
    SCOPED_TRACE(shape.name);
    Model model = make_model(shape.mesh, shape.boundary);
    model.features.weights = ExtraordinaryWeights::quarters;
    expect_equals_deep_refinement(model, find_scheme("catmull-clark"));
    expect_tangents_of_deep_refinement(model);
    ++compared;
  }
  for (const Shape& shape : loop_shapes()) {
    if (!has_other_weights(shape)) continue;
    SCOPED_TRACE(shape.name);
    Model model = make_model(shape.mesh, shape.boundary);
    model.features.weights = ExtraordinaryWeights::warren;
    expect_equals_deep_refinement(model, find_scheme("loop"));
    ++compared;
  }
  EXPECT_GE(compared, 12);
}

INSTANTIATE_TEST_SUITE_P(Zoo, LimitOf, testing::ValuesIn(limit_shapes()),
                         [](const auto& shape) { return shape.param.name; });
INSTANTIATE_TEST_SUITE_P(Loop, LimitOf, testing::ValuesIn(loop_shapes()),
                         [](const auto& shape) { return shape.param.name; });
INSTANTIATE_TEST_SUITE_P(Zoo, CatmullClarkLimitOf, testing::ValuesIn(limit_shapes()),
                         [](const auto& shape) { return shape.param.name; });

}  // namespace
}  // namespace limes::test
