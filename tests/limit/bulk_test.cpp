#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "limes/limit/bulk_evaluator.h"
#include "limes/mesh/shapes.h"
#include "limit/surface.h"
#include "limit/zoo.h"

// Many points at once against the definition, one point at a time.

namespace limes::test {
namespace {

/// Corners, dyadic points, points close to every corner, and random ones, in no order.
std::vector<SurfaceLocation> sample_locations(const LimitBasis& basis, int num_faces) {
  std::mt19937 random(2024);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<SurfaceLocation> where;
  for (int f = 0; f < num_faces; ++f) {
    for (int c = 0; c < basis.num_quadrants(FaceId(f)); ++c) {
      const auto add = [&](double u, double v) { where.push_back({FaceId(f), c, Vec2(u, v)}); };
      for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j)
          add(i / 8.0, j / 8.0);
      for (const int k : {1, 2, 5, 9, 10, 20, 40}) {
        const double t = std::ldexp(1.0, -k);
        add(t, 0), add(0, t), add(t, t), add(1 - t, 0), add(1 - t, 1 - t), add(0.3 * t, 1 - t);
      }
      add(1e-30, 2e-31), add(1e-80, 0);
      for (int i = 0; i < 8; ++i)
        add(unit(random), unit(random));
    }
  }
  std::shuffle(where.begin(), where.end(), random);
  return where;
}

double size_of(const Model& model) {
  double size = 0;
  for (const Vec3& x : model.points)
    size = std::max(size, (x - model.points[0]).norm());
  return size;
}

class BulkOf : public testing::TestWithParam<Shape> {};

/// Second derivatives diverge towards extraordinary vertices; errors are measured against the
/// derivative where it is larger than the model.
TEST_P(BulkOf, EqualsOnePointAtATime) {
  const Surface s(GetParam().mesh, GetParam().boundary);
  const auto where = sample_locations(s.basis, std::min(5, s.model.topology.num_faces()));
  const BulkEvaluator bulk(s.basis, s.model.points);
  SurfaceValues values;
  bulk.evaluate(where, 2, values);
  const double size = size_of(s.model);
  const auto near = [&](const Vec3& a, const Vec3& b, double bound) {
    return (a - b).norm() <= bound * std::max(size, b.norm());
  };
  std::vector<std::int64_t> extraordinary;
  for (std::size_t i = 0; i < where.size(); ++i) {
    const SurfaceLocation& w = where[i];
    SCOPED_TRACE(testing::Message() << w.face.value << " " << w.corner << " " << w.uv.transpose());
    const SurfacePoint p = s.limit.evaluate(w.face, w.corner, w.uv);
    ASSERT_TRUE(near(values.x[i], p.x, 1e-13));
    if (!p.first) {
      extraordinary.push_back(static_cast<std::int64_t>(i));
      EXPECT_TRUE(std::isnan(values.xu[i].x()) && std::isnan(values.xvv[i].z()));
      continue;
    }
    ASSERT_TRUE(near(values.xu[i], p.first->xu, 1e-12));
    ASSERT_TRUE(near(values.xv[i], p.first->xv, 1e-12));
    ASSERT_TRUE(near(values.xuu[i], p.second->xuu, 1e-12));
    ASSERT_TRUE(near(values.xuv[i], p.second->xuv, 1e-12));
    ASSERT_TRUE(near(values.xvv[i], p.second->xvv, 1e-12));
  }
  EXPECT_EQ(values.extraordinary, extraordinary);
}

INSTANTIATE_TEST_SUITE_P(Zoo, BulkOf, testing::ValuesIn(limit_shapes()),
                         [](const auto& shape) { return shape.param.name; });

TEST(Bulk, TakesNoPoints) {
  const Surface s(shapes::cube());
  const BulkEvaluator bulk(s.basis, s.model.points);
  SurfaceValues values;
  bulk.evaluate({}, 2, values);
  EXPECT_TRUE(values.x.empty() && values.xvv.empty() && values.extraordinary.empty());
}

}  // namespace
}  // namespace limes::test
