// Stencils and masks of every scheme against the published ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "limes/math/fraction.h"
#include "limes/mesh/shapes.h"
#include "limes/spectrum/rule_site.h"
#include "limes/spectrum/rules.h"
#include "limes/subdiv/schemes.h"

namespace limes::test {
namespace {

using Place = Rule::Place;
using Kind = ChildVertex::Kind;

SchemeRules rules_of(std::string_view name, int valence = 0, double tension = 1.0) {
  const Scheme& scheme = find_scheme(name);
  if (valence == 0) return scheme_rules(scheme, tension, nullptr);
  const LocalSubdivision local(scheme, valence, {.tension = tension}, 16);
  return scheme_rules(scheme, tension, &local);
}

std::vector<double> sorted(std::vector<double> weights) {
  std::sort(weights.begin(), weights.end());
  return weights;
}

bool agree(const Rule& rule, const std::vector<double>& weights, double denominator) {
  std::vector<double> ours;
  for (const RuleWeight& w : rule.weights)
    ours.push_back(w.weight * denominator);
  ours = sorted(ours);
  const std::vector<double> theirs = sorted(weights);
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                    [](double a, double b) { return std::abs(a - b) < 1e-12; });
}

/// Every quad cut in two.
Topology halved(const Topology& quads) {
  std::vector<VertexId> corners;
  for (int f = 0; f < quads.num_faces(); ++f) {
    const auto q = quads.face(FaceId(f));
    corners.insert(corners.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
  }
  return Topology(quads.num_vertices(), 3, std::move(corners));
}

struct Published {
  const char* scheme;
  int valence;  // 0: regular, boundary, ...
  Place place;
  Kind kind;
  double denominator;
  std::vector<double> weights;
};

/// [catmull_clark_1978], [loop_1987], [doo_sabin_1978], [zorin_schroeder_sweldens_1996],
/// [kobbelt_2000] and, with tension 1, [kobbelt_1996]; boundary and crease curves are cubic
/// B-splines.
const std::vector<Published> published{
    {"catmull-clark", 0, Place::regular, Kind::face, 4, {1, 1, 1, 1}},
    {"catmull-clark", 0, Place::regular, Kind::edge, 16, {1, 1, 6, 6, 1, 1}},
    {"catmull-clark", 0, Place::regular, Kind::vertex, 64, {1, 6, 1, 6, 36, 6, 1, 6, 1}},
    {"catmull-clark", 0, Place::boundary, Kind::vertex, 8, {1, 6, 1}},
    {"catmull-clark", 0, Place::boundary, Kind::edge, 2, {1, 1}},
    {"catmull-clark", 0, Place::crease, Kind::vertex, 8, {1, 6, 1}},
    {"catmull-clark", 0, Place::corner, Kind::vertex, 1, {1}},
    // [derose_1998]: sharpness 1/2 is half of the crease's rule and half of the smooth one.
    {"catmull-clark", 0, Place::semi_sharp, Kind::vertex, 128, {1, 6, 1, 14, 84, 14, 1, 6, 1}},
    {"catmull-clark", 0, Place::semi_sharp, Kind::edge, 32, {1, 1, 14, 14, 1, 1}},
    {"catmull-clark", 0, Place::sharp_vertex, Kind::vertex, 1, {1}},
    {"loop", 0, Place::semi_sharp, Kind::vertex, 32, {1, 1, 3, 22, 3, 1, 1}},
    {"loop", 0, Place::semi_sharp, Kind::edge, 16, {1, 7, 7, 1}},
    {"catmull-clark", 3, Place::star, Kind::vertex, 36, {15, 6, 6, 6, 1, 1, 1}},
    {"catmull-clark", 3, Place::face, Kind::face, 3, {1, 1, 1}},
    {"loop", 0, Place::regular, Kind::vertex, 16, {10, 1, 1, 1, 1, 1, 1}},
    {"loop", 0, Place::regular, Kind::edge, 8, {3, 3, 1, 1}},
    {"loop", 0, Place::boundary, Kind::vertex, 8, {1, 6, 1}},
    {"loop", 0, Place::crease, Kind::edge, 2, {1, 1}},
    {"loop", 3, Place::star, Kind::vertex, 16, {7, 3, 3, 3}},
    {"loop", 4, Place::star, Kind::vertex, 256, {132, 31, 31, 31, 31}},
    {"doo-sabin", 0, Place::regular, Kind::corner, 16, {9, 3, 3, 1}},
    {"doo-sabin", 3, Place::star, Kind::corner, 6, {4, 1, 1}},
    {"mid-edge", 0, Place::regular, Kind::edge, 2, {1, 1}},
    {"butterfly", 0, Place::regular, Kind::edge, 16, {8, 8, 2, 2, -1, -1, -1, -1}},
    {"butterfly", 0, Place::boundary, Kind::edge, 16, {-1, 9, 9, -1}},
    {"butterfly", 3, Place::star, Kind::edge, 12, {9, 5, -1, -1}},
    {"butterfly", 4, Place::star, Kind::edge, 8, {6, 3, -1}},
    {"sqrt3", 0, Place::regular, Kind::face, 3, {1, 1, 1}},
    {"sqrt3", 0, Place::regular, Kind::vertex, 18, {12, 1, 1, 1, 1, 1, 1}},
    {"sqrt3", 4, Place::star, Kind::vertex, 9, {5, 1, 1, 1, 1}},
    {"sqrt3", 0, Place::boundary, Kind::vertex, 27, {4, 19, 4}},
    {"sqrt3", 0, Place::boundary, Kind::edge, 27, {1, 16, 10}},
    {"kobbelt", 0, Place::regular, Kind::edge, 16, {-1, 9, 9, -1}},
    {"kobbelt",
     0,
     Place::regular,
     Kind::face,
     256,
     {1, -9, -9, 1, -9, 81, 81, -9, -9, 81, 81, -9, 1, -9, -9, 1}},
    // The point beyond the boundary is 2 b - c.
    {"kobbelt", 0, Place::boundary, Kind::edge, 16, {7, 10, -1}},
    {"four-eight", 0, Place::regular, Kind::face, 4, {1, 1, 1, 1}},
    {"four-eight", 0, Place::regular, Kind::edge, 4, {1, 1, 1, 1}},
    {"four-eight", 0, Place::regular, Kind::vertex, 8, {4, 1, 1, 1, 1}}};

TEST(Rules, ArePublishedOnes) {
  for (const Published& p : published) {
    const SchemeRules found = rules_of(p.scheme, p.valence);
    EXPECT_TRUE(std::any_of(found.rules.begin(), found.rules.end(),
                            [&](const Rule& rule) {
                              return rule.place == p.place && rule.kind == p.kind &&
                                     agree(rule, p.weights, p.denominator);
                            }))
        << p.scheme << " valence " << p.valence << " place " << static_cast<int>(p.place)
        << " kind " << static_cast<int>(p.kind);
  }
}

/// Around a vertex of the boundary with another number of faces: the rules listed for regular ones.
TEST(Rules, OfBoundariesHoldAtEveryValence) {
  for (const char* name : {"catmull-clark", "loop", "linear", "four-eight", "sqrt3"}) {
    const Scheme& scheme = find_scheme(name);
    const SchemeRules listed = rules_of(name);
    for (const int num_faces : {1, 3, 4, 7})
      for (int step = 0; step < num_different_steps(scheme); ++step) {
        SCOPED_TRACE(testing::Message() << name << ", " << num_faces << " faces, step " << step);
        Lattice half{shapes::half_disk(num_faces, 6), VertexId(0)};
        if (scheme.faces == FaceKind::triangles) half.mesh.topology = halved(half.mesh.topology);
        const RuleSite site(scheme, half, 1.0, step);
        for (const VertexId child : site.children_around(half.middle)) {
          std::vector<double> weights;
          for (SparseMatrix::InnerIterator entry(site.matrix(), child.value); entry; ++entry)
            if (entry.value() != 0) weights.push_back(entry.value());
          EXPECT_TRUE(std::any_of(listed.rules.begin(), listed.rules.end(), [&](const Rule& rule) {
            const bool plain = rule.place == Place::regular || rule.place == Place::boundary;
            return plain && rule.kind == site.source(child).kind && agree(rule, weights, 1);
          }));
        }
      }
  }
}

/// Nothing but the published rules on the plane.
TEST(Rules, OnThePlaneAreListedOnce) {
  const std::map<std::string_view, int> counts{
      {"catmull-clark", 3}, {"loop", 2},    {"doo-sabin", 1},  {"mid-edge", 1}, {"butterfly", 2},
      {"sqrt3", 2},         {"kobbelt", 3}, {"four-eight", 3}, {"linear", 3}};
  for (const auto& [name, count] : counts) {
    const SchemeRules found = rules_of(name);
    EXPECT_EQ(std::count_if(found.rules.begin(), found.rules.end(),
                            [](const Rule& r) { return r.place == Place::regular; }),
              count)
        << name;
    EXPECT_EQ(found.masks.size(), 1U) << name;
  }
}

TEST(Rules, AddUpToOne) {
  for (const Scheme& scheme : all_schemes()) {
    for (const Rule& rule : rules_of(scheme.name, 6).rules) {
      double sum = 0;
      for (const RuleWeight& w : rule.weights)
        sum += w.weight;
      EXPECT_NEAR(sum, 1, 1e-13) << scheme.name;
    }
  }
}

double weight_at(const RegularMask& mask, double x, double y) {
  for (const RuleWeight& w : mask.weights)
    if ((w.at - Vec2(x, y)).norm() < 1e-9) return w.weight;
  return 0;
}

/// A mask against a square of numerators, rows downwards, with new vertices every `step`.
void expect_mask(std::string_view scheme, double denominator, double step,
                 const std::vector<std::vector<double>>& rows) {
  const RegularMask mask = rules_of(scheme).masks.at(0);
  const double reach = step * static_cast<double>(rows.size() - 1) / 2;
  std::size_t nonzero = 0;
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double x = step * static_cast<double>(i) - reach;
      const double y = reach - step * static_cast<double>(j);
      EXPECT_NEAR(weight_at(mask, x, y) * denominator, rows[j][i], 1e-12)
          << scheme << " at " << x << " " << y;
      nonzero += rows[j][i] != 0;
    }
  EXPECT_EQ(mask.weights.size(), nonzero) << scheme;
}

TEST(Masks, ArePublishedOnes) {
  // Tensor products of (1, 4, 6, 4, 1)/8 and of (1, 3, 3, 1)/4.
  expect_mask("catmull-clark", 64, 0.5,
              {{1, 4, 6, 4, 1},
               {4, 16, 24, 16, 4},
               {6, 24, 36, 24, 6},
               {4, 16, 24, 16, 4},
               {1, 4, 6, 4, 1}});
  expect_mask("doo-sabin", 16, 0.5, {{1, 3, 3, 1}, {3, 9, 9, 3}, {3, 9, 9, 3}, {1, 3, 3, 1}});
  // The quartic box spline with directions (1, 0), (0, 1), (1, 1), each twice.
  expect_mask(
      "loop", 16, 0.5,
      {{0, 0, 1, 2, 1}, {0, 2, 6, 6, 2}, {1, 6, 10, 6, 1}, {2, 6, 6, 2, 0}, {1, 2, 1, 0, 0}});
  // Dyn, Levin, Gregory 1990, on the same three directions.
  expect_mask("butterfly", 16, 0.5,
              {{0, 0, 0, 0, -1, -1, 0},
               {0, 0, -1, 0, 2, 0, -1},
               {0, -1, 2, 8, 8, 2, -1},
               {0, 0, 8, 16, 8, 0, 0},
               {-1, 2, 8, 8, 2, -1, 0},
               {-1, 0, 2, 0, -1, 0, 0},
               {0, -1, -1, 0, 0, 0, 0}});
}

/// Every old vertex spreads as much weight as new vertices come to it.
double new_vertices_per_old_one(Split split) {
  if (split == Split::sqrt3) return 3;
  return is_quadrisection(split) || split == Split::dual ? 4 : 2;
}

TEST(Masks, AddUpToTheNewVerticesPerOldOne) {
  for (const Scheme& scheme : all_schemes()) {
    for (const RegularMask& mask : rules_of(scheme.name).masks) {
      double sum = 0;
      for (const RuleWeight& w : mask.weights)
        sum += w.weight;
      EXPECT_NEAR(sum, new_vertices_per_old_one(scheme.split), 1e-13) << scheme.name;
    }
  }
}

TEST(Fraction, FindsTheLeastDenominator) {
  EXPECT_EQ(as_fraction(0.375), (Fraction{3, 8}));
  EXPECT_EQ(as_fraction(-7.0 / 27.0), (Fraction{-7, 27}));
  EXPECT_EQ(as_fraction(0.0), (Fraction{0, 1}));
  EXPECT_EQ(as_fraction(59.0 / 54.0), (Fraction{59, 54}));
  EXPECT_FALSE(as_fraction(std::sqrt(2.0)));
  EXPECT_FALSE(as_fraction(1.0 / 65537.0));
  EXPECT_FALSE(as_fraction(std::nan("")));
  EXPECT_EQ(common_denominator(std::vector{0.25, 1.0 / 6.0, -2.0}), 12);
  EXPECT_FALSE(common_denominator(std::vector{0.25, std::sqrt(0.3)}));
}

}  // namespace
}  // namespace limes::test
