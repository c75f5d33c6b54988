#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "limes/spectrum/spectrum.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

using Json = nlohmann::json;

Json read(const char* name) {
  std::ifstream file(std::string(LIMES_TEST_DATA_DIR "/interpolatory/") + name);
  return Json::parse(file);
}

Spectrum kobbelt(int valence, double tension) {
  return analyse(find_scheme("kobbelt"), valence, {.tension = tension}).spectrum;
}

// Eigenvalues of an independent program, with defects: 1e-6.
TEST(SpectrumOfKobbelt, IsThatOfAnotherProgram) {
  const Json eigen = read("eigen.json");
  for (const auto& [prefix, tension] :
       {std::pair("om=1/16", 1.0), std::pair("om=1/8 (printed w=1)", 2.0)})
    for (int n = 3; n <= 12; ++n) {
      const Json& known = eigen[std::string(prefix) + " n=" + std::to_string(n)];
      const Spectrum s = kobbelt(n, tension);
      std::vector<double> values;
      for (const BlockEigenvalue& e : s.eigenvalues)
        values.push_back(std::abs(e.value));
      for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(values[i], known["eig"][i][0].get<double>(), 1e-6) << prefix << n << " " << i;
    }
}

// Holds for valence 4 to 12 and tensions up to 2 (sqrt 5 - 1); at valence 3 only up to omega = 0.104061, where
// an eigenvalue of block 0 overtakes the pair.
TEST(SpectrumOfKobbelt, IsSmoothWhereItShouldBe) {
  for (int n = 3; n <= 12; ++n) {
    EXPECT_TRUE(kobbelt(n, 1.0).c1) << n << kobbelt(n, 1.0).reason;
    EXPECT_EQ(kobbelt(n, 2.0).c1, n > 3) << n;
  }
  EXPECT_TRUE(kobbelt(3, 16 * 0.1040).c1);
  EXPECT_FALSE(kobbelt(3, 16 * 0.1042).c1);
  EXPECT_TRUE(kobbelt(5, 2 * (std::sqrt(5.0) - 1)).c1);
  EXPECT_FALSE(kobbelt(5, 0.0).c1);  // bilinear
  EXPECT_FALSE(kobbelt(4, 5.0).c1);
}

// Left eigenvectors of the pair on 2 rings, (1, 0) and (2, 0) on the spokes.
TEST(SpectrumOfKobbelt, HasKnownTangentMasks) {
  for (const auto& [n, one, two] :
       {std::tuple(3, .951953173484, -.143033616328), std::tuple(4, 2. / 3, -1. / 12),
        std::tuple(5, .525031881494, -.059734419700),
        std::tuple(6, .435147984456, -.046901757506)}) {
    const Spectrum s = kobbelt(n, 1.0);
    for (std::size_t i = 0; i < s.places.size(); ++i) {
      const double weight = (*s.tangent_masks)(static_cast<Eigen::Index>(i), 0);
      if (s.places[i] == StarPlace{1, 0, 0}) {
        EXPECT_NEAR(weight, one, 1e-11) << n;
      } else if (s.places[i] == StarPlace{2, 0, 0}) {
        EXPECT_NEAR(weight, two, 1e-11) << n;
      }
    }
    EXPECT_NEAR((*s.limit_mask)[0], 1, 1e-9);
  }
}

}  // namespace
}  // namespace limes
