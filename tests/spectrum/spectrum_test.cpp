#include "limes/spectrum/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "limes/core/error.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

constexpr double pi = std::numbers::pi;

Spectrum spectrum(std::string_view scheme, int valence, double tension = 1.0) {
  return analyse(find_scheme(scheme), valence, {.tension = tension}).spectrum;
}

/// Real eigenvalues of one block, largest first.
std::vector<double> block(const Spectrum& s, int k) {
  std::vector<double> values;
  for (const BlockEigenvalue& e : s.eigenvalues)
    if (e.block == k) values.push_back(e.value.real());
  return values;
}

/// A mask's weight at (ring, place, sector).
double weight(const Spectrum& s, const VectorX& mask, const StarPlace& place) {
  for (std::size_t i = 0; i < s.places.size(); ++i)
    if (s.places[i] == place) return mask[static_cast<Eigen::Index>(i)];
  ADD_FAILURE() << "no such place";
  return 0;
}

// Closed forms of the subdominant eigenvalue, each from the scheme's literature.
struct ClosedForm {
  const char* scheme;
  double (*lambda)(int n);
  int first_smooth;  ///< the least valence where the surface is C1
};

class Subdominant : public testing::TestWithParam<ClosedForm> {};

TEST_P(Subdominant, IsTheClosedForm) {
  for (int n = 3; n <= 12; ++n) {
    const Spectrum s = spectrum(GetParam().scheme, n);
    EXPECT_NEAR(s.subdominant, GetParam().lambda(n), 1e-12) << n;
    EXPECT_EQ(s.c1, n >= GetParam().first_smooth) << n << ": " << s.reason;
    EXPECT_NEAR(std::abs(s.eigenvalues[0].value - 1.0), 0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Subdominant,
    testing::Values(
        // [doo_sabin_1978], [ball_storry_1988]
        ClosedForm{"catmull-clark",
                   [](int n) {
                     const double c = std::cos(2 * pi / n);
                     return (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16;
                   },
                   3},
        // [loop_1987]
        ClosedForm{"loop", [](int n) { return 3.0 / 8 + std::cos(2 * pi / n) / 4; }, 3},
        // [doo_sabin_1978]: the weights are chosen for it
        ClosedForm{"doo-sabin", [](int) { return 0.5; }, 3},
        // [zorin_schroeder_2001]: the means of two corners and of four, by the discrete Fourier transform
        ClosedForm{"repeated-averaging", [](int n) { return 0.5 + std::cos(2 * pi / n) / 4; }, 3},
        // [zorin_schroeder_sweldens_1996]: the weights are chosen for it
        ClosedForm{"butterfly", [](int) { return 0.5; }, 3},
        // [kobbelt_2000], two steps
        ClosedForm{"sqrt3", [](int n) { return (2 + 2 * std::cos(2 * pi / n)) / 9; }, 3},
        // [peters_reif_1997], two steps; around a triangle other eigenvalues are as large
        ClosedForm{"mid-edge", [](int n) { return (1 + std::cos(2 * pi / n)) / 2; }, 4}),
    [](const auto& test) {
      std::string name = test.param.scheme;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST(SpectrumOfDooSabin, IsAHalfAndQuarters) {
  for (int n = 3; n <= 9; ++n) {
    const Spectrum s = spectrum("doo-sabin", n);
    EXPECT_EQ(s.num_steps, 1);
    EXPECT_NEAR(block(s, 0)[1], 0.25, 1e-7);
    for (int k = 2; k <= n - 2; ++k)
      EXPECT_NEAR(block(s, k)[0], 0.25, 1e-7) << n << " " << k;
    EXPECT_NEAR(s.curvature_ratio, 1.0, 1e-6);
  }
}

// The second eigenvalue of block 0 is the square of the subdominant one: the weights of [loop_1987] are
// chosen for it.
TEST(SpectrumOfLoop, HasTheSquareInBlockZero) {
  for (int n = 3; n <= 12; ++n) {
    const Spectrum s = spectrum("loop", n);
    const std::vector<double> values = block(s, 0);
    EXPECT_TRUE(std::any_of(values.begin(), values.end(), [&](double x) {
      return std::abs(x - s.subdominant * s.subdominant) < 1e-9;
    })) << n;
    for (int k = 1; k < n; ++k)
      EXPECT_NEAR(block(s, k)[0], std::max(3.0 / 8 + std::cos(2 * pi * k / n) / 4, 0.125), 1e-7)
          << n << " " << k;
  }
}

// At regular vertices the surface is a polynomial: powers of 1/2, as many as homogeneous polynomials.
TEST(SpectrumOfSplines, CountsPolynomialsAtRegularVertices) {
  for (const auto& [scheme, valence] : {std::pair("catmull-clark", 4), std::pair("loop", 6)}) {
    const Spectrum s = spectrum(scheme, valence);
    std::map<int, int> count;
    for (const BlockEigenvalue& e : s.eigenvalues)
      ++count[static_cast<int>(std::lround(-std::log2(std::abs(e.value))))];
    EXPECT_EQ(count[0], 1);
    EXPECT_EQ(count[1], 2);
    EXPECT_EQ(count[2], 3);
    EXPECT_GE(count[3], 4);
    EXPECT_NEAR(s.curvature_ratio, 1, 1e-9);
  }
}

TEST(SpectrumOfLinear, HasNoTangentPlane) {
  for (int n = 3; n <= 6; ++n) {
    const Spectrum s = spectrum("linear", n);
    EXPECT_FALSE(s.c1);
    EXPECT_NEAR(s.subdominant, 0.5, 1e-12);
    EXPECT_FALSE(s.map);
  }
}

// [halstead_1993]
TEST(MasksOfCatmullClark, ArePublished) {
  for (int n = 3; n <= 12; ++n) {
    const Spectrum s = spectrum("catmull-clark", n);
    const double all = n * (n + 5.0);
    EXPECT_NEAR(weight(s, *s.limit_mask, {0, 0, 0}), n * n / all, 1e-12);
    EXPECT_NEAR(weight(s, *s.limit_mask, {1, 0, 1}), 4 / all, 1e-12);
    EXPECT_NEAR(weight(s, *s.limit_mask, {1, 1, 2}), 1 / all, 1e-12);
    EXPECT_NEAR(weight(s, *s.limit_mask, {2, 0, 0}), 0, 1e-12);

    const double c = std::cos(2 * pi / n);
    const double edge = 1 + c + std::cos(pi / n) * std::sqrt(2 * (9 + c));
    const VectorX t = s.tangent_masks->col(0);
    const double scale = weight(s, t, {1, 0, 0}) / edge;
    EXPECT_GT(scale, 0);
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(weight(s, t, {1, 0, i}), scale * edge * std::cos(2 * pi * i / n), 1e-12);
      EXPECT_NEAR(weight(s, t, {1, 1, i}),
                  scale * (std::cos(2 * pi * i / n) + std::cos(2 * pi * (i + 1) / n)), 1e-12);
    }
  }
}

TEST(MasksOfLoop, ArePublished) {
  for (int n = 3; n <= 12; ++n) {
    const Spectrum s = spectrum("loop", n);
    const double root = 3.0 / 8 + std::cos(2 * pi / n) / 4;
    const double beta = (5.0 / 8 - root * root) / n;
    const double chi = 1 / (n + 3 / (8 * beta));
    EXPECT_NEAR(weight(s, *s.limit_mask, {0, 0, 0}), 1 - n * chi, 1e-12);
    const VectorX t = s.tangent_masks->col(1);
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(weight(s, *s.limit_mask, {1, 0, i}), chi, 1e-12);
      EXPECT_NEAR(weight(s, t, {1, 0, i}),
                  weight(s, s.tangent_masks->col(0), {1, 0, 0}) * std::sin(2 * pi * i / n), 1e-12);
    }
    EXPECT_NEAR(weight(s, t, {2, 0, 0}), 0, 1e-12);
  }
}

// [velho_quasi48] and plain 4-8, from an independent program; n sectors, valence 2 n, two steps.
struct FourEightRow {
  int sectors;
  double quasi, plain;
};
class FourEight : public testing::TestWithParam<FourEightRow> {};

TEST_P(FourEight, IsThatOfAnotherProgram) {
  const auto& [n, quasi, plain] = GetParam();
  for (const auto& [scheme, lambda] :
       {std::pair("quasi-four-eight", quasi), std::pair("four-eight", plain)}) {
    const Spectrum s = spectrum(scheme, 2 * n);
    EXPECT_EQ(s.num_steps, 2);
    EXPECT_NEAR(s.subdominant, lambda, 1e-8) << scheme;
    EXPECT_EQ(s.c1, n > 2) << scheme << s.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Sectors, FourEight,
                         testing::Values(FourEightRow{2, 0.25, 0.25},
                                         FourEightRow{3, 0.405113181, 0.408311432},
                                         FourEightRow{4, 0.5, 0.5},
                                         FourEightRow{5, 0.554871875, 0.551323077},
                                         FourEightRow{6, 0.588072039, 0.581868401},
                                         FourEightRow{7, 0.609333667, 0.601250190},
                                         FourEightRow{8, 0.623654849, 0.614231515},
                                         FourEightRow{12, 0.650730725, 0.638622250}),
                         [](const auto& test) { return "n" + std::to_string(test.param.sectors); });

TEST(MasksOfFourEight, HaveKnownMiddles) {
  for (const int n : {3, 4, 5, 7}) {
    EXPECT_NEAR((*spectrum("quasi-four-eight", 2 * n).limit_mask)[0], 0.328132, 1e-6);
    EXPECT_NEAR((*spectrum("four-eight", 2 * n).limit_mask)[0], 7.0 / 24, 1e-9);
  }
}

// The limit point of a face is the mean of its corners [doo_sabin_1978].
TEST(MasksOfDooSabin, AreTheMeanOfTheFace) {
  for (int n = 3; n <= 8; ++n) {
    const Spectrum s = spectrum("doo-sabin", n);
    for (std::size_t i = 0; i < s.places.size(); ++i)
      EXPECT_NEAR((*s.limit_mask)[static_cast<Eigen::Index>(i)],
                  s.places[i].ring == 0 ? 1.0 / n : 0.0, 1e-12);
  }
}

TEST(MasksOfInterpolatorySchemes, AreTheVertex) {
  const Spectrum s = spectrum("butterfly", 5);
  EXPECT_NEAR((*s.limit_mask)[0], 1, 1e-12);
  EXPECT_NEAR(s.limit_mask->cwiseAbs().sum(), 1, 1e-12);
}

// Tangent masks measure the coordinates of the characteristic map, and no constants.
TEST(TangentMasks, AreBiorthogonal) {
  for (const Scheme& scheme : all_schemes())
    for (const int n : {4, 5, 8}) {
      if (!has_valence(scheme, n)) continue;
      const Spectrum s = analyse(scheme, n).spectrum;
      if (!s.tangent_masks) continue;
      Mat2 product = Mat2::Zero();
      for (Eigen::Index i = 0; i < s.tangent_masks->rows(); ++i)
        product += s.tangent_masks->row(i).transpose() *
                   s.map->points[static_cast<std::size_t>(i)].transpose();
      EXPECT_LT((product - Mat2::Identity()).norm(), 1e-10) << scheme.name << " " << n;
      EXPECT_LT(s.tangent_masks->colwise().sum().norm(), 1e-10) << scheme.name << " " << n;
    }
}

// The characteristic map of a regular vertex is the plane itself.
TEST(CharacteristicMap, IsTheGridAtRegularVertices) {
  for (const auto& [scheme, valence] :
       {std::pair("catmull-clark", 4), std::pair("loop", 6), std::pair("doo-sabin", 4),
        std::pair("butterfly", 6), std::pair("sqrt3", 6)}) {
    const Spectrum s = spectrum(scheme, valence);
    ASSERT_TRUE(s.map) << scheme;
    EXPECT_NEAR(s.map->least_jacobian, 1, 1e-9) << scheme;
    EXPECT_EQ(s.map->winding_number, 1);
  }
}

// Of the weights at the vertex nothing depends but the block of what is equal in all directions. With
// quarters it is the regular vertex's for every valence: the sums over spokes do not know their number.
TEST(ExtraordinaryWeights, QuartersAreTheRegularVertexOnAverage) {
  const Scheme& scheme = find_scheme("catmull-clark");
  for (int n = 3; n <= 12; ++n) {
    SCOPED_TRACE(n);
    const Spectrum standard = spectrum("catmull-clark", n);
    const Spectrum s = analyse(scheme, n, {.weights = ExtraordinaryWeights::quarters}).spectrum;
    const std::vector<double> means = block(s, 0);
    ASSERT_GE(means.size(), 3U);
    EXPECT_NEAR(means[0], 1, 1e-12);
    EXPECT_NEAR(means[1], 1.0 / 4, 1e-12);
    EXPECT_NEAR(means[2], 1.0 / 8, 1e-12);  // of the ring further out
    EXPECT_NEAR(s.subdominant, standard.subdominant, 1e-12);
    EXPECT_NEAR(weight(s, *s.limit_mask, {0, 0, 0}), 4.0 / 9, 1e-12);
    EXPECT_NEAR(weight(s, *s.limit_mask, {1, 0, 1}), 4.0 / (9 * n), 1e-12);
    EXPECT_NEAR(weight(s, *s.limit_mask, {1, 1, 2}), 1.0 / (9 * n), 1e-12);
  }
}

// [warren_weimer_2001]: 5/8 - n w is 1/4 from valence 4 on, and the limit takes half of the vertex.
TEST(ExtraordinaryWeights, WarrensHaveTheEigenvalueOneQuarter) {
  const Scheme& scheme = find_scheme("loop");
  for (int n = 3; n <= 12; ++n) {
    SCOPED_TRACE(n);
    const Spectrum s = analyse(scheme, n, {.weights = ExtraordinaryWeights::warren}).spectrum;
    EXPECT_NEAR(s.subdominant, 3.0 / 8 + std::cos(2 * pi / n) / 4, 1e-12);
    EXPECT_TRUE(s.c1) << s.reason;
    EXPECT_NEAR(block(s, 0)[1], n == 3 ? 0.125 : 0.25, 1e-12);
    EXPECT_NEAR(weight(s, *s.limit_mask, {0, 0, 0}), n == 3 ? 0.4 : 0.5, 1e-12);
  }
}

TEST(LocalSubdivision, CommutesWithTheRotation) {
  for (const Scheme& scheme : all_schemes()) {
    const LocalSubdivision local(scheme, 6, {}, 16);
    const int n = local.num_sectors();
    const Eigen::Index size = local.num_invariant_places();
    MatrixX A = MatrixX(local.matrix()).topLeftCorner(size, size);
    EXPECT_LT((A.rowwise().sum() - VectorX::Ones(size)).cwiseAbs().maxCoeff(), 1e-14)
        << scheme.name;
    const Eigen::Index middle = local.star().around_face ? 0 : 1;
    const auto next = [&](Eigen::Index p) {
      return p < middle ? p : middle + (p - middle) / n * n + ((p - middle) % n + 1) % n;
    };
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j)
        EXPECT_NEAR(A(i, j), A(next(i), next(j)), 1e-15) << scheme.name;
  }
}

TEST(Spectrum, RefusesImpossibleValences) {
  EXPECT_THROW(require_valence(find_scheme("loop"), 2), UsageError);
  EXPECT_THROW(require_valence(find_scheme("loop"), 101), UsageError);
  EXPECT_THROW(require_valence(find_scheme("four-eight"), 5), UsageError);
}

}  // namespace
}  // namespace limes
