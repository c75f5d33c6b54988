#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <thread>
#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/tile_kernel.h"
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

/// Distance to the closest corner of the parameter square.
double corner_distance(const Vec2& uv) {
  return std::max(std::min(uv.x(), 1 - uv.x()), std::min(uv.y(), 1 - uv.y()));
}

/// Bounds are relative to all derivatives of that order, as a turned frame would mix them. Second
/// derivatives are differences of first ones across a tile, whose size is that of the distance to
/// the corner: so is the rounding of both.
TEST_P(BulkOf, EqualsOnePointAtATime) {
  const Surface s(GetParam().mesh, GetParam().boundary);
  const auto where = sample_locations(s.basis, std::min(5, s.model.topology.num_faces()));
  const BulkEvaluator bulk(s.basis, s.model.points);
  SurfaceValues values;
  bulk.evaluate(where, 2, values);
  const double size = size_of(s.model);
  std::vector<std::int64_t> extraordinary;
  for (std::size_t i = 0; i < where.size(); ++i) {
    const SurfaceLocation& w = where[i];
    SCOPED_TRACE(testing::Message() << w.face.value << " " << w.corner << " " << w.uv.transpose());
    const SurfacePoint p = s.limit.evaluate(w.face, w.corner, w.uv);
    ASSERT_LE((values.x[i] - p.x).norm(), 1e-13 * size);
    if (!p.first) {
      extraordinary.push_back(static_cast<std::int64_t>(i));
      EXPECT_TRUE(std::isnan(values.xu[i].x()) && std::isnan(values.xvv[i].z()));
      continue;
    }
    const auto& [xu, xv] = *p.first;
    const double first = 1e-12 * std::max({size, xu.norm(), xv.norm()});
    ASSERT_LE((values.xu[i] - xu).norm(), first);
    ASSERT_LE((values.xv[i] - xv).norm(), first);
    const auto& [xuu, xuv, xvv] = *p.second;
    const double second = std::max(1e-12, 1e-14 / corner_distance(w.uv)) *
                          std::max({size, xuu.norm(), xuv.norm(), xvv.norm()});
    ASSERT_LE((values.xuu[i] - xuu).norm(), second);
    ASSERT_LE((values.xuv[i] - xuv).norm(), second);
    ASSERT_LE((values.xvv[i] - xvv).norm(), second);
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

void expect_same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)), 0);
}
void expect_same_bits(const SurfaceValues& a, const SurfaceValues& b) {
  expect_same_bits(a.x, b.x);
  expect_same_bits(a.xu, b.xu);
  expect_same_bits(a.xv, b.xv);
  expect_same_bits(a.xuu, b.xuu);
  expect_same_bits(a.xuv, b.xuv);
  expect_same_bits(a.xvv, b.xvv);
  EXPECT_EQ(a.extraordinary, b.extraordinary);
}

/// The shape with the most different tiles, and many points: more than one block.
struct Busy {
  Busy() : surface(shape().mesh, shape().boundary) {
    const auto some = sample_locations(surface.basis, surface.model.topology.num_faces());
    for (int k = 0; k < 40; ++k)
      where.insert(where.end(), some.begin(), some.end());
  }
  static Shape shape() {
    for (Shape& s : limit_shapes())
      if (s.name == "random_polygons0") return s;
    return {};
  }
  Surface surface;
  std::vector<SurfaceLocation> where;
};

#ifdef LIMES_WITH_TBB
TEST(Bulk, HasTheSameBitsForAnyNumberOfThreads) {
  const Busy busy;
  SurfaceValues one, two;
  for (const auto& [threads, values] : {std::pair(1, &one), std::pair(2, &two)}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    const BulkEvaluator bulk(busy.surface.basis, busy.surface.model.points);
    bulk.evaluate(busy.where, 2, *values);
  }
  expect_same_bits(one, two);
}
#endif

/// Tiles are made by whoever needs them first.
TEST(Bulk, ServesSeveralCallersAtOnce) {
  const Busy busy;
  const Surface fresh(Busy::shape().mesh, Busy::shape().boundary);
  const BulkEvaluator shared(fresh.basis, fresh.model.points);
  const BulkEvaluator alone(busy.surface.basis, busy.surface.model.points);
  SurfaceValues expected;
  alone.evaluate(busy.where, 2, expected);
  std::array<SurfaceValues, 4> values;
  std::vector<std::thread> callers;
  for (SurfaceValues& own : values)
    callers.emplace_back([&] { shared.evaluate(busy.where, 2, own); });
  for (std::thread& t : callers)
    t.join();
  for (const SurfaceValues& own : values)
    expect_same_bits(own, expected);
}

TEST(Bulk, DoesNotDependOnTheOrderOfPoints) {
  const Busy busy;
  const BulkEvaluator bulk(busy.surface.basis, busy.surface.model.points);
  SurfaceValues values;
  bulk.evaluate(busy.where, 2, values);
  for (std::size_t i = busy.where.size(); i-- > 0;) {
    SurfaceJet jet;
    const auto kind = bulk.evaluate(busy.where[i], 2, jet);
    ASSERT_EQ(std::memcmp(&jet.x, &values.x[i], sizeof(Vec3)), 0);
    if (kind == LimitBasis::Point::extraordinary) {
      EXPECT_TRUE(std::binary_search(values.extraordinary.begin(), values.extraordinary.end(),
                                     static_cast<std::int64_t>(i)));
      continue;
    }
    ASSERT_EQ(std::memcmp(&jet.xu, &values.xu[i], sizeof(Vec3)), 0);
    ASSERT_EQ(std::memcmp(&jet.xuv, &values.xuv[i], sizeof(Vec3)), 0);
  }
}

/// Lower orders are the same numbers, and leave the other arrays empty.
TEST(Bulk, ComputesWhatIsAskedFor) {
  const Busy busy;
  const BulkEvaluator bulk(busy.surface.basis, busy.surface.model.points);
  SurfaceValues two, one, zero;
  bulk.evaluate(busy.where, 2, two);
  bulk.evaluate(busy.where, 1, one);
  bulk.evaluate(busy.where, 0, zero);
  expect_same_bits(zero.x, two.x);
  expect_same_bits(one.x, two.x);
  expect_same_bits(one.xu, two.xu);
  expect_same_bits(one.xv, two.xv);
  EXPECT_TRUE(one.xuu.empty() && zero.xu.empty());
  EXPECT_EQ(zero.extraordinary, two.extraordinary);
}

TEST(Bulk, FollowsMovedPoints) {
  const Busy busy;
  std::vector<Vec3> moved = busy.surface.model.points;
  for (Vec3& x : moved)
    x = Vec3(x.y() + 3, 2 * x.x(), x.z() - x.x() * x.y());
  BulkEvaluator bulk(busy.surface.basis, busy.surface.model.points);
  const BulkEvaluator expected(busy.surface.basis, moved);
  SurfaceValues a, b;
  bulk.evaluate(busy.where, 2, a);
  bulk.update(moved);
  bulk.evaluate(busy.where, 2, a);
  expected.evaluate(busy.where, 2, b);
  expect_same_bits(a, b);
}

/// Vectors of two and of four numbers (where there are any) give the same bits.
TEST(TileKernel, HasTheSameBitsWithEveryInstructionSet) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<TileCoefficients> tiles(40);
  std::vector<TilePoint> points;
  for (TileCoefficients& tile : tiles) {
    for (double& c : tile.c)
      c = unit(random);
    points.push_back({tile.c.data(), unit(random), unit(random)});
  }
  for (int order = 0; order <= 2; ++order) {
    std::array<std::array<std::vector<Vec3>, 6>, 2> values;
    for (auto& set : values) {
      for (auto& array : set)
        array.assign(points.size(), Vec3::Zero());
      evaluate_tiles(points, order,
                     {set[0][0].data(), set[1][0].data(), set[2][0].data(), set[3][0].data(),
                      set[4][0].data(), set[5][0].data()},
                     &set == &values[0] ? TileVectors::two_doubles : TileVectors::best);
    }
    for (std::size_t k = 0; k < 6; ++k)
      expect_same_bits(values[0][k], values[1][k]);
  }
}

}  // namespace
}  // namespace limes::test
