#include "limes/curve/refine_curve.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

Polyline random_polyline(int n, bool closed, unsigned seed = 7) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  Polyline line{{}, closed};
  for (int i = 0; i < n; ++i)
    line.points.emplace_back(number(random), number(random), number(random));
  return line;
}

Polyline refine(Polyline line, const CurveScheme& scheme, int levels) {
  for (int i = 0; i < levels; ++i)
    line = limes::refine(line, scheme);
  return line;
}

/// The polar form of a spline piece of a degree on whole knots, de Boor's recursion with one
/// argument per step [ramshaw_1987]: point(i) belongs to the knots i + 1 to i + degree, the piece lies
/// between the knots `piece` and `piece` + 1.
Vec3 blossom(int degree, int piece, const std::vector<double>& arguments,
             const std::function<Vec3(int)>& point) {
  std::vector<Vec3> d;
  for (int i = piece - degree; i <= piece; ++i)
    d.push_back(point(i));
  for (int r = 1; r <= degree; ++r)
    for (int k = degree; k >= r; --k) {
      const int i = piece - degree + k;  // between the knots i and i + degree + 1 - r
      const double share = (arguments[static_cast<std::size_t>(r - 1)] - i) / (degree + 1 - r);
      d[static_cast<std::size_t>(k)] =
          (1 - share) * d[static_cast<std::size_t>(k - 1)] + share * d[static_cast<std::size_t>(k)];
    }
  return d[static_cast<std::size_t>(degree)];
}

class LaneRiesenfeld : public testing::TestWithParam<int> {};

// New control points are the polar form at consecutive half knots.
TEST_P(LaneRiesenfeld, InsertsKnotsHalfWay) {
  const int degree = GetParam();
  const int n = 9;
  const Polyline coarse = random_polyline(n, true);
  const auto point = [&](int i) {
    return coarse.points[static_cast<std::size_t>(((i % n) + n) % n)];
  };
  const Polyline fine = limes::refine(coarse, lane_riesenfeld(degree));
  ASSERT_EQ(fine.points.size(), 2U * n);
  for (int j = 0; j < 2 * n; ++j) {
    // The knots m / 2 + 1/2 to m / 2 + degree / 2 have the new point's place in their middle.
    const int m = j + (degree % 2 == 1 ? (degree + 1) / 2 : degree / 2);
    std::vector<double> knots;
    for (int k = 1; k <= degree; ++k)
      knots.push_back((m + k) / 2.0);
    const int piece = static_cast<int>(std::floor(knots[static_cast<std::size_t>(degree / 2)]));
    EXPECT_LT(
        (fine.points[static_cast<std::size_t>(j)] - blossom(degree, piece, knots, point)).norm(),
        1e-11)
        << j;
  }
}

TEST_P(LaneRiesenfeld, OfAnOpenPolygonIsTheSameInside) {
  const int degree = GetParam();
  const Polyline open = random_polyline(30, false);
  Polyline closed = open;
  closed.closed = true;
  const CurveScheme scheme = lane_riesenfeld(degree);
  const Polyline a = limes::refine(open, scheme), b = limes::refine(closed, scheme);
  const std::size_t first = scheme.mask.is_primal() ? 0 : static_cast<std::size_t>(degree) / 2;
  EXPECT_EQ(a.points.size(),
            scheme.mask.is_primal() ? 59U : 60U - static_cast<std::size_t>(degree));
  const std::size_t margin = scheme.mask.is_primal() ? static_cast<std::size_t>(degree) : 0;
  for (std::size_t j = margin; j + margin < a.points.size(); ++j)
    EXPECT_EQ(a.points[j], b.points[first + j]) << j;
}

TEST_P(LaneRiesenfeld, KeepsStraightLinesStraight) {
  const CurveScheme scheme = lane_riesenfeld(GetParam());
  for (int n = scheme.fewest_open; n < scheme.fewest_open + 3; ++n) {
    Polyline line;
    for (int i = 0; i < n; ++i)
      line.points.emplace_back(i, 2 * i + 1, -i);
    const Polyline fine = refine(line, scheme, 3);
    const double step = 1.0 / 8;
    for (std::size_t j = 1; j < fine.points.size(); ++j)
      EXPECT_LT((fine.points[j] - fine.points[j - 1] - step * Vec3(1, 2, -1)).norm(), 1e-12);
    if (scheme.mask.is_primal()) {
      EXPECT_EQ(fine.points.front(), line.points.front());
      EXPECT_EQ(fine.points.back(), line.points.back());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, LaneRiesenfeld, testing::Values(1, 2, 3, 4, 5, 6, 7, 10));

// The masks that the literature prints.
TEST(CurveMasks, ArePublished) {
  EXPECT_EQ(lane_riesenfeld(1).mask.weights, (std::vector<double>{0.5, 1, 0.5}));
  EXPECT_EQ(find_curve_scheme("chaikin").mask.weights, (std::vector<double>{.25, .75, .75, .25}));
  EXPECT_EQ(lane_riesenfeld(3).mask.weights,
            (std::vector<double>{1. / 8, 4. / 8, 6. / 8, 4. / 8, 1. / 8}));
  EXPECT_EQ(four_point().mask.weights,
            (std::vector<double>{-1. / 16, 0, 9. / 16, 1, 9. / 16, 0, -1. / 16}));
  EXPECT_EQ(four_point(0).mask.weights, (std::vector<double>{0, 0, .5, 1, .5, 0, 0}));
}

TEST(CurveMasks, StencilsAddUpToOne) {
  std::vector<CurveScheme> schemes = all_curve_schemes();
  for (const double tension : {0.3, 1.7, 2.4})
    schemes.push_back(four_point(tension));
  for (int degree = 1; degree <= most_degree; ++degree)
    schemes.push_back(lane_riesenfeld(degree));
  for (const CurveScheme& s : schemes)
    for (const int parity : {0, 1}) {
      double sum = 0;
      for (const double w : s.mask.stencil(parity))
        sum += w;
      EXPECT_NEAR(sum, 1, 1e-15) << s.name;
    }
}

// (3, 1)/4 and (1, 3)/4 on every side [chaikin_1974]; the curve starts in the middle of the first side.
TEST(Chaikin, CutsCorners) {
  const Polyline line = random_polyline(5, false);
  const Polyline fine = limes::refine(line, find_curve_scheme("chaikin"));
  ASSERT_EQ(fine.points.size(), 8U);
  for (std::size_t i = 0; i + 1 < 5; ++i) {
    EXPECT_LT((fine.points[2 * i] - (0.75 * line.points[i] + 0.25 * line.points[i + 1])).norm(),
              1e-15);
    EXPECT_LT((fine.points[2 * i + 1] - (0.25 * line.points[i] + 0.75 * line.points[i + 1])).norm(),
              1e-15);
  }
  const Polyline limit = refine(line, find_curve_scheme("chaikin"), 20);
  EXPECT_LT((limit.points.front() - (line.points[0] + line.points[1]) / 2).norm(), 1e-5);
}

TEST(FourPoint, ReproducesCubicsAtTensionOne) {
  const auto cubic = [](double t) {
    return Vec3(t, t * t * t - 4 * t, 1 + t * t - 0.3 * t * t * t);
  };
  Polyline line;
  for (int i = 0; i < 20; ++i)
    line.points.push_back(cubic(i / 4.0));
  const Polyline fine = refine(line, four_point(), 4);
  for (int j = 4 * 16; j + 4 * 16 < static_cast<int>(fine.points.size()); ++j)
    EXPECT_LT((fine.points[static_cast<std::size_t>(j)] - cubic(j / 64.0)).norm(), 1e-12);
  EXPECT_GT((limes::refine(line, four_point(2)).points[19] - cubic(19 / 8.0)).norm(), 1e-3);
}

TEST(FourPoint, KeepsTheOldPointsBitForBit) {
  for (const bool closed : {false, true}) {
    const Polyline line = random_polyline(7, closed);
    const Polyline fine = limes::refine(line, four_point(1.3));
    for (std::size_t i = 0; i < line.points.size(); ++i)
      EXPECT_EQ(fine.points[2 * i], line.points[i]);
  }
}

// The end rule: the phantom beyond an end b with the neighbour c is 2 b - c.
TEST(FourPoint, EndsLikeABreakpoint) {
  const Polyline line = random_polyline(4, false);
  const auto& p = line.points;
  const Vec3 expected = 9. / 16 * (p[0] + p[1]) - 1. / 16 * ((2 * p[0] - p[1]) + p[2]);
  EXPECT_LT((limes::refine(line, four_point()).points[1] - expected).norm(), 1e-15);
}

/// The limit at a place in the cell between the points 2 and 3 of six: bisect, keep the six points
/// around the half that holds it.
double four_point_limit(std::array<double, 6> f, double t) {
  for (int step = 0; step < 50; ++step) {
    Polyline line;
    for (const double value : f)
      line.points.emplace_back(value, 0, 0);
    const Polyline fine = limes::refine(line, four_point());
    t *= 2;
    const std::size_t first = t < 1 ? 2 : 3;
    if (t >= 1) t -= 1;
    for (std::size_t i = 0; i < 6; ++i)
      f[i] = fine.points[first + i].x();
  }
  return f[2] + t * (f[3] - f[2]);
}

// Exact weights of limit points at rational places, from the fixed vector of the products of bisection
// matrices in rational arithmetic.
TEST(FourPoint, LimitsAtRationalPlaces) {
  struct Case {
    double t;
    std::array<double, 6> weights;
    double denominator;
  };
  const std::vector<Case> cases{{1. / 3, {16, -410, 4240, 2000, -256, -1}, 5589},
                                {1. / 5, {768, -11355, 153744, 34233, -4768, 3}, 172625},
                                {1. / 7, {45296, -560621, 9379184, 1337024, -188416, 46}, 10012513},
                                {1. / 4, {1, -18, 216, 66, -9, 0}, 256},
                                {1. / 2, {0, -1, 9, 9, -1, 0}, 16}};
  for (const Case& c : cases)
    for (std::size_t i = 0; i < 6; ++i) {
      std::array<double, 6> impulse{};
      impulse[i] = 1;
      EXPECT_NEAR(four_point_limit(impulse, c.t), c.weights[i] / c.denominator, 2e-15)
          << c.t << " " << i;
    }
}

TEST(CubicSpline, IsTheBoundaryOfCatmullClark) {
  const int n = 7;
  Mesh face = shapes::polygon(n);
  const Polyline closed = random_polyline(n, true);
  face.points = IdArray<VertexId, Vec3>(closed.points);
  const Mesh fine_face = refine(face, find_scheme("catmull-clark"), {.levels = 1});
  const Polyline curve = limes::refine(closed, lane_riesenfeld(3));
  for (int i = 0; i < n; ++i) {
    EXPECT_LT(
        (fine_face.points[VertexId(i)] - curve.points[static_cast<std::size_t>(2 * i)]).norm(),
        1e-15);
    EXPECT_LT(
        (fine_face.points[VertexId(n + i)] - curve.points[static_cast<std::size_t>(2 * i + 1)])
            .norm(),
        1e-15);
  }
}

// A strip whose corners are kept: its long side is an open curve.
TEST(CubicSpline, EndsLikeACornerOfCatmullClark) {
  Mesh strip = shapes::grid(5, 1);
  const Polyline side = random_polyline(6, false);
  for (int i = 0; i < 6; ++i)
    strip.points[VertexId(i)] = side.points[static_cast<std::size_t>(i)];
  const Mesh fine = refine(strip, find_scheme("catmull-clark"),
                           {.levels = 1, .boundary = BoundaryRule::edges_and_corners});
  const Polyline curve = limes::refine(side, lane_riesenfeld(3));
  const Adjacency adjacency(strip.topology);
  for (int i = 0; i < 6; ++i)
    EXPECT_LT((fine.points[VertexId(i)] - curve.points[static_cast<std::size_t>(2 * i)]).norm(),
              1e-15);
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    const int a = adjacency.from(h).value, b = adjacency.to(h).value;
    if (b != a + 1 || b >= 6) continue;
    EXPECT_LT(
        (fine.points[VertexId(12 + e)] - curve.points[static_cast<std::size_t>(a + b)]).norm(),
        1e-15);
  }
}

TEST(CurveSchemes, RefuseWhatTheyCannotDo) {
  EXPECT_THROW(static_cast<void>(find_curve_scheme("lane-riesenfeld")), UsageError);
  EXPECT_THROW(static_cast<void>(find_curve_scheme("lane-riesenfeld:0")), UsageError);
  EXPECT_THROW(static_cast<void>(find_curve_scheme("lane-riesenfeld:21")), UsageError);
  EXPECT_THROW(static_cast<void>(find_curve_scheme("lane-riesenfeld:3x")), UsageError);
  EXPECT_THROW(static_cast<void>(find_curve_scheme("loop")), UsageError);
  EXPECT_THROW(static_cast<void>(limes::refine(random_polyline(2, false), lane_riesenfeld(2))),
               InputError);
  EXPECT_THROW(static_cast<void>(limes::refine(random_polyline(2, true), four_point())),
               InputError);
}

TEST(CurveSchemes, KnowTheSizesToCome) {
  for (const CurveScheme& s : all_curve_schemes())
    for (const bool closed : {false, true})
      EXPECT_EQ(refined_size(9, closed, s, 3),
                static_cast<double>(refine(random_polyline(9, closed), s, 3).points.size()))
          << s.name;
}

}  // namespace
}  // namespace limes
